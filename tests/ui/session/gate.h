/// Holds a thread until the test lets it through. After half a minute it lets it through by itself and reports that: then
/// somebody has waited for what was to be waited for by nobody.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace cusp::test {

class Gate {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    if (!opened_.wait_for(lock, std::chrono::seconds(30), [this] { return open_; })) gave_up_ = true;
  }
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    opened_.notify_all();
  }
  bool gave_up() const {
    const std::lock_guard lock(mutex_);
    return gave_up_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable opened_;
  bool open_ = false, gave_up_ = false;
};

}  // namespace cusp::test
