/// The drilling sound of one attempt: the synthesiser, its volume on the handpiece's panel, and where that is kept. Silent
/// where the exercise has no sound. Thread: GUI.
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

#include "scenarios/format/scenario.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/modules.h"
#include "ui/session/observer.h"

namespace cusp::ui {

class DrillSound;
class Settings;

class AttemptSound : public QObject {
  Q_OBJECT

 public:
  /// `panel` and `sound` outlive this; without a sound it makes its own.
  AttemptSound(HandpiecePanel& panel, QObject* parent, DrillSound* sound = nullptr);

  /// Where volume and mute are kept; outlives this. Without: the usual ones, not kept.
  void keep_in(Settings* settings) { settings_ = settings; }
  /// Where there is no output, or where it goes away, one is looked for until stop().
  void begin(const Scenario& scenario);
  void follow(const LiveView& live, const Scene& scene);
  void stop();

 private:
  void show(bool available);
  void look_later();

  HandpiecePanel& panel_;
  DrillSound* sound_;
  Settings* settings_ = nullptr;
  HandpiecePanel::Sound state_;
  QTimer again_{this};
  std::chrono::seconds pause_{1};  // before the next look
};

}  // namespace cusp::ui
