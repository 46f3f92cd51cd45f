/// Time since a loop's last tick: the loop calls beat() once a tick, any thread calls silence().
/// The watchdog does not change the force. A tick that begins late is a fault of the step's guard
/// (GuardSettings::late_ms), which gives zero force; a device switches its motors off when packets stop.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace cusp::engine {

class Watchdog {
 public:
  using Clock = std::chrono::steady_clock;
  /// Haptic thread. Wait-free.
  void beat(Clock::time_point now) noexcept {
    last_ns_.store(now.time_since_epoch().count(), std::memory_order_release);
  }
  /// Any thread. Time since the last beat; zero before the first.
  std::chrono::nanoseconds silence(Clock::time_point now) const noexcept {
    const std::int64_t last = last_ns_.load(std::memory_order_acquire);
    return last == 0 ? std::chrono::nanoseconds{0} : now.time_since_epoch() - std::chrono::nanoseconds{last};
  }

 private:
  std::atomic<std::int64_t> last_ns_{0};
};

}  // namespace cusp::engine
