/// The station's foot pedal, read on a thread of its own. The haptic tick reads it as one atomic value.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "device/hid/hid_follower.h"
#include "device/hid/pedal.h"

namespace cusp::device::hid {

/// Plain values for a screen.
struct PedalView {
  std::vector<HidDevice> devices;  // that have controls
  std::optional<HidDevice> device; // the followed one
  std::vector<Control> controls;   // of `device`
  PedalReading reading;
  bool connected = false;
  bool denied = false;             // connected, but this user may not open it (device/hid/permissions.h)
  std::uint64_t reports = 0;
};

class PedalReader final : public PedalSource, private HidSink {
 public:
  explicit PedalReader(std::function<std::unique_ptr<HidBus>()> make_bus, const PedalSettings& settings = {});
  ~PedalReader() override;

  void start() { follower_.start(); }
  void stop() { follower_.stop(); }

  /// Thread: haptic. Released if the reader has not polled for kStale before `now`.
  PedalReading latest(std::chrono::steady_clock::time_point now) const noexcept override;

  // One other thread (the window's).
  PedalView view() const;
  PedalSettings settings() const;
  /// Applied at the next report, or at once if the device changes.
  void set_settings(const PedalSettings& settings);

  static constexpr std::chrono::milliseconds kStale{250};  // the reader polls every 30 ms

 private:
  std::optional<HidDevice> choose(const std::vector<HidDevice>& devices) override;
  void opened(const HidDevice& device) override;
  void refused(const HidDevice& device, const PortFailure& failure) override;
  void report(std::span<const std::uint8_t> report, HidTime now) override;
  void polled(HidTime now) override;
  void lost() override;
  void publish(HidTime now);

  mutable std::mutex mutex_;           // settings_ and view_, held for a copy; never taken by the haptic thread
  PedalSettings settings_;
  PedalView view_;
  std::optional<PedalState> state_;    // the follower's thread
  std::atomic<std::uint64_t> latest_{0};  // pressed, coolant, and the time of the last poll
  HidFollower follower_;
};

}  // namespace cusp::device::hid
