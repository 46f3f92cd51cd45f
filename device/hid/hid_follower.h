/// Follows one HID device on a thread of its own: finds it, opens it, hands on its reports, and finds it again after it
/// was unplugged. No other thread ever waits for it.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <thread>

#include "device/hid/hid_bus.h"

namespace cusp::device::hid {

using HidTime = std::chrono::steady_clock::time_point;

/// Called on the follower's thread alone. None may throw.
class HidSink {
 public:
  virtual ~HidSink() = default;
  /// Which of these to follow; nothing: none of them. Asked about once a second, and after again().
  virtual std::optional<HidDevice> choose(const std::vector<HidDevice>& devices) = 0;
  virtual void opened(const HidDevice& device) = 0;
  /// The chosen device could not be opened; it is tried again.
  virtual void refused(const HidDevice& device, const PortFailure& failure) = 0;
  virtual void report(std::span<const std::uint8_t> report, HidTime now) = 0;
  /// At least every 30 ms, whether or not anything came.
  virtual void looked(HidTime now) = 0;
  virtual void lost() = 0;
};

class HidFollower {
 public:
  /// `sink` outlives this. `make_bus` is called on the thread.
  HidFollower(std::function<std::unique_ptr<HidBus>()> make_bus, HidSink& sink);
  ~HidFollower();
  HidFollower(const HidFollower&) = delete;
  HidFollower& operator=(const HidFollower&) = delete;

  void start();
  void stop();
  /// Any thread: choose anew, at once.
  void again() noexcept { again_.store(true, std::memory_order_release); }

 private:
  void run();
  std::function<std::unique_ptr<HidBus>()> make_bus_;
  HidSink& sink_;
  std::atomic<bool> stop_{false}, again_{true};
  std::thread thread_;
};

}  // namespace cusp::device::hid
