/// The station's foot pedal: read on a thread of its own, taken by the haptic tick as one atomic value.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "device/hid/hid_follower.h"
#include "device/hid/pedal.h"

namespace cusp::device::hid {

/// What a screen may want to know; plain values.
struct PedalView {
  std::vector<HidDevice> devices;  // that have something to press
  std::optional<HidDevice> device; // the one that is followed
  std::vector<Control> controls;   // of it
  PedalReading reading;
  bool connected = false;
  bool denied = false;             // there, but this user may not open it (device/hid/permissions.h)
  std::uint64_t reports = 0;
};

class PedalReader final : public PedalSource, private HidSink {
 public:
  explicit PedalReader(std::function<std::unique_ptr<HidBus>()> make_bus, const PedalSettings& settings = {});
  ~PedalReader() override;

  void start() { follower_.start(); }
  void stop() { follower_.stop(); }

  /// Haptic thread. Released once the reader has not looked for kStale before `now`.
  PedalReading latest(std::chrono::steady_clock::time_point now) const noexcept override;

  // One other thread (the window's).
  PedalView view() const;
  PedalSettings settings() const;
  /// Taken at the next report, or at once when the device is another.
  void set_settings(const PedalSettings& settings);

  static constexpr std::chrono::milliseconds kStale{250};  // the reader looks every 30 ms

 private:
  std::optional<HidDevice> choose(const std::vector<HidDevice>& devices) override;
  void opened(const HidDevice& device) override;
  void refused(const HidDevice& device, const PortFailure& failure) override;
  void report(std::span<const std::uint8_t> report, HidTime now) override;
  void looked(HidTime now) override;
  void lost() override;
  void publish(HidTime now);

  mutable std::mutex mutex_;           // settings_ and view_, held for a copy; never taken by the haptic thread
  PedalSettings settings_;
  PedalView view_;
  std::optional<PedalState> state_;    // the follower's thread
  std::atomic<std::uint64_t> latest_{0};  // pressed, coolant, and when the reader last looked
  HidFollower follower_;
};

}  // namespace cusp::device::hid
