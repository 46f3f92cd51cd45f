/// Asks the desktop neither to blank nor to lock the screen, nor to let the computer sleep, while this stands: a haptic device moves
/// without mouse and keys, which are all that the desktop counts. Over org.freedesktop.ScreenSaver on the session bus; where nobody
/// answers there, nothing happens. No call waits. Any thread but the haptic one.
#pragma once

#include <memory>
#include <string>

#include "ui/session/background_task.h"

namespace cusp::ui {

class KeepAwake {
 public:
  /// `why`: for the desktop to show.
  explicit KeepAwake(std::string why);
  ~KeepAwake();
  KeepAwake(const KeepAwake&) = delete;
  KeepAwake& operator=(const KeepAwake&) = delete;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  BackgroundTask task_;
};

}  // namespace cusp::ui
