/// Makes the tooth of an exercise that somebody may start next, at low priority. Thread: GUI; the work has its own.
#pragma once

#include <atomic>
#include <memory>

#include "ui/session/background_task.h"
#include "ui/view/tooth_cache.h"

namespace cusp::ui {

class ToothAhead {
 public:
  /// Begins at once.
  ToothAhead(std::shared_ptr<ToothCache> teeth, ToothWish wish);
  /// Stops, and does not wait.
  ~ToothAhead();
  ToothAhead(const ToothAhead&) = delete;
  ToothAhead& operator=(const ToothAhead&) = delete;

 private:
  std::shared_ptr<std::atomic<bool>> stop_;
  BackgroundTask task_;
};

}  // namespace cusp::ui
