/// Follows one HID device on a thread of its own: finds and opens it, passes on its reports, and finds it again after it
/// was unplugged. No other thread waits for it.
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
  /// The device to follow, or nullopt. Called about once a second, and after again().
  virtual std::optional<HidDevice> choose(const std::vector<HidDevice>& devices) = 0;
  virtual void opened(const HidDevice& device) = 0;
  /// The chosen device could not be opened. HidFollower tries again.
  virtual void refused(const HidDevice& device, const PortFailure& failure) = 0;
  virtual void report(std::span<const std::uint8_t> report, HidTime now) = 0;
  /// At least every 30 ms, with or without reports.
  virtual void polled(HidTime now) = 0;
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
  /// Any thread. Makes the follower call choose() at once.
  void again() noexcept { again_.store(true, std::memory_order_release); }

 private:
  void run();
  std::function<std::unique_ptr<HidBus>()> make_bus_;
  HidSink& sink_;
  std::atomic<bool> stop_{false}, again_{true};
  std::thread thread_;
};

}  // namespace cusp::device::hid
