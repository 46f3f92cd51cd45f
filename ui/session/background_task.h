/// Work that the window starts and never waits for: asking a service, closing a device that may not answer. Each background task
/// has a thread of its own. Whoever drops a BackgroundTask continues at once; what still runs then is waited for when the program
/// ends, or by whoever needs what it holds. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace cusp::ui {

class BackgroundTask {
 public:
  /// What a task has in hand. nothing: what it reads, computes or asks can be had again. device: an attempt needs it. change: it changes a
  /// file or the records.
  enum class Holds : std::uint8_t { nothing, device, change };
  BackgroundTask() = default;  // none
  /// Begins at once. `work` owns all that it touches, or shares it.
  explicit BackgroundTask(std::function<void()> work, Holds holds = Holds::change);
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

/// What would be lost if the process ended beside the background tasks that were dropped and are not over.
enum class DroppedWork : std::uint8_t { none, harmless, change };
DroppedWork dropped_work();

/// Waits for dropped tasks where it goes. It stands between the application and whoever starts tasks: they use the application and
/// the statics of the program.
class TasksEndHere {
 public:
  TasksEndHere() = default;
  ~TasksEndHere();
  TasksEndHere(const TasksEndHere&) = delete;
  TasksEndHere& operator=(const TasksEndHere&) = delete;
  /// Then it does not wait: it ends the process with this status, and the tasks with it.
  void leave_tasks(int status) { status_ = status; }

 private:
  std::optional<int> status_;
};

}  // namespace cusp::ui
