/// The station's SpaceMouse, read on a thread of its own.
#pragma once

#include <mutex>
#include <optional>

#include "device/hid/hid_follower.h"
#include "device/hid/report_descriptor.h"
#include "device/hid/space_mouse.h"

namespace cusp::device::hid {

/// Plain values for a screen.
struct SpaceMouseView {
  std::optional<HidDevice> device;
  bool connected = false;
  bool denied = false;                // connected, but this user may not open it (device/hid/permissions.h)
  std::array<std::int16_t, 6> raw{};
  SpaceMouseMotion motion;            // by the settings, at the time of the call
  std::optional<int> battery_percent;
  std::uint64_t reports = 0;
};

class SpaceMouseReader final : private HidSink {
 public:
  explicit SpaceMouseReader(std::function<std::unique_ptr<HidBus>()> make_bus, const SpaceMouseSettings& settings = {});
  ~SpaceMouseReader() override;

  void start() { follower_.start(); }
  void stop() { follower_.stop(); }

  // Any thread.
  SpaceMouseView view(std::chrono::steady_clock::time_point now) const;
  SpaceMouseSettings settings() const;
  void set_settings(const SpaceMouseSettings& settings);

 private:
  std::optional<HidDevice> choose(const std::vector<HidDevice>& devices) override;
  void opened(const HidDevice& device) override;
  void refused(const HidDevice& device, const PortFailure& failure) override;
  void report(std::span<const std::uint8_t> report, HidTime now) override;
  void polled(HidTime now) override;
  void lost() override;

  mutable std::mutex mutex_;  // guards all members; held for a copy
  SpaceMouseSettings settings_;
  SpaceMouseState state_;
  SpaceMouseView view_;
  HidFollower follower_;
};

}  // namespace cusp::device::hid
