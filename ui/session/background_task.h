/// Work that the window starts and never waits for: asking a service, closing a device that may not answer. Each background task
/// has a thread of its own. Whoever drops a BackgroundTask continues at once; what still runs then is waited for when the program
/// ends, or by whoever needs what it holds. Any thread but the haptic one.
#pragma once

#include <functional>
#include <memory>

namespace cusp::ui {

class BackgroundTask {
 public:
  BackgroundTask() = default;  // none
  /// Begins at once. `work` owns all that it touches, or shares it.
  explicit BackgroundTask(std::function<void()> work);
  /// Does not wait.
  ~BackgroundTask();
  BackgroundTask(BackgroundTask&& other) noexcept;
  BackgroundTask& operator=(BackgroundTask&& other) noexcept;

  bool over() const noexcept;

 private:
  struct Job;
  std::shared_ptr<Job> job_;
};

/// Until every background task that was dropped is over. Not for the window's thread.
void wait_for_dropped_tasks();

}  // namespace cusp::ui
