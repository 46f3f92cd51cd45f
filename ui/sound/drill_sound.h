/// The drilling sound on the computer's speaker. Where there is no audio output, or the program was built without Qt
/// Multimedia, it is silent and start() is false. Nothing of it touches the haptic thread. Thread: GUI.
#pragma once

#include <QObject>
#include <memory>

#include "ui/sound/drill_synth.h"

namespace cusp::ui {

class DrillSound : public QObject {
  Q_OBJECT

 public:
  explicit DrillSound(QObject* parent = nullptr);
  ~DrillSound() override;

  /// Looks for an output and opens it; false where there is none. Until then nothing is asked of the system. Virtual for tests.
  virtual bool start();
  void stop();
  /// False before start(), and where there is nothing to hear it with.
  virtual bool available() const;

  /// The newest of the loop, at frame rate; it sounds until the next.
  void follow(const DrillHeard& heard);
  /// 0 to 100; beyond counts as the nearest.
  void set_volume(int percent);
  void set_muted(bool muted);

 Q_SIGNALS:
  /// The output went away, as when the sound server ends: available() is false now.
  void lost();

 private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
