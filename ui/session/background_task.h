/// Work that the window starts and never waits for: asking a service, closing a device that may not answer. Each background task
/// has a thread of its own. Whoever drops a BackgroundTask continues at once; what still runs then is waited for when the program
/// ends, or by whoever needs what it holds. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace cusp::ui {

class BackgroundTask {
 public:
  /// What a task has in hand that an attempt needs.
  enum class Holds : std::uint8_t { nothing, device };
  BackgroundTask() = default;  // none
  /// Begins at once. `work` owns all that it touches, or shares it.
  explicit BackgroundTask(std::function<void()> work, Holds holds = Holds::nothing);
  /// Does not wait.
  ~BackgroundTask();
  BackgroundTask(BackgroundTask&& other) noexcept;
  BackgroundTask& operator=(BackgroundTask&& other) noexcept;

  bool over() const noexcept;

 private:
  struct Job;
  std::shared_ptr<Job> job_;
};

/// Until every background task that was dropped is over. The window's thread calls it at its end alone (TasksEndHere).
void wait_for_dropped_tasks();
/// The same for those that hold a device, or until `called_off` says true.
void wait_for_dropped_devices(const std::function<bool()>& called_off = {});

/// Waits for dropped tasks where it goes. It stands between the application and whoever starts tasks: they use the application and
/// the statics of the program.
class TasksEndHere {
 public:
  TasksEndHere() = default;
  ~TasksEndHere() { wait_for_dropped_tasks(); }
  TasksEndHere(const TasksEndHere&) = delete;
  TasksEndHere& operator=(const TasksEndHere&) = delete;
};

}  // namespace cusp::ui
