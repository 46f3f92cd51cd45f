/// The drilling sound of one attempt: the synthesiser, its volume on the handpiece's panel, and where that is kept. Silent
/// where the exercise has no sound. Thread: GUI.
#pragma once

#include <QObject>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/session/observer.h"

namespace cusp::ui {

class DrillSound;
class HandpiecePanel;
class Settings;

class AttemptSound : public QObject {
  Q_OBJECT

 public:
  /// `panel` outlives this.
  AttemptSound(HandpiecePanel& panel, QObject* parent);

  /// Where volume and mute are kept; outlives this. Without: the usual ones, not kept.
  void keep_in(Settings* settings) { settings_ = settings; }
  void begin(const Scenario& scenario);
  void follow(const LiveView& live, const Scene& scene);
  void stop();

 private:
  HandpiecePanel& panel_;
  DrillSound* sound_;
  Settings* settings_ = nullptr;
};

}  // namespace cusp::ui
