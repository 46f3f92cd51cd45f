/// Work that the window starts and never waits for: asking a service, closing a device that may not answer. Each errand
/// has a thread of its own. Whoever drops an Errand goes on at once; what still runs then is waited for when the program
/// ends, or by whoever needs what it holds. Any thread but the haptic one.
#pragma once

#include <functional>
#include <memory>

namespace cusp::ui {

class Errand {
 public:
  Errand() = default;  // none
  /// Begins at once. `work` owns all that it touches, or shares it.
  explicit Errand(std::function<void()> work);
  /// Does not wait.
  ~Errand();
  Errand(Errand&& other) noexcept;
  Errand& operator=(Errand&& other) noexcept;

  bool over() const noexcept;

 private:
  struct Job;
  std::shared_ptr<Job> job_;
};

/// Until every errand that was dropped is over. Not for the window's thread.
void wait_for_dropped_errands();

}  // namespace cusp::ui
