#include "device/hid/space_mouse_reader.h"

namespace cusp::device::hid {

SpaceMouseReader::SpaceMouseReader(std::function<std::unique_ptr<HidBus>()> make_bus, const SpaceMouseSettings& settings)
    : settings_(settings), follower_(std::move(make_bus), *this) {}

SpaceMouseReader::~SpaceMouseReader() { follower_.stop(); }

SpaceMouseView SpaceMouseReader::view(std::chrono::steady_clock::time_point now) const {
  const std::lock_guard lock(mutex_);
  SpaceMouseView out = view_;
  out.raw = state_.raw();
  out.motion = state_.motion(settings_, now);
  out.battery_percent = state_.battery_percent();
  return out;
}

SpaceMouseSettings SpaceMouseReader::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

void SpaceMouseReader::set_settings(const SpaceMouseSettings& settings) {
  const std::lock_guard lock(mutex_);
  settings_ = settings;
}

std::optional<HidDevice> SpaceMouseReader::choose(const std::vector<HidDevice>& devices) {
  const std::lock_guard lock(mutex_);
  view_.denied = false;
  for (const HidDevice& device : devices) {
    if (!is_space_mouse(device.vendor, device.product)) continue;
    // A receiver has interfaces for a keyboard and a mouse beside the six axes.
    const auto parsed = parse_report_descriptor(device.descriptor);
    if (!parsed || (parsed->page == usage::kDesktopPage && parsed->usage == usage::kMultiAxis)) return device;
  }
  view_.device.reset();  // one that was refused is gone as well
  return std::nullopt;
}

void SpaceMouseReader::opened(const HidDevice& device) {
  const std::lock_guard lock(mutex_);
  state_.release();
  view_.device = device;
  view_.connected = true;
}

void SpaceMouseReader::refused(const HidDevice& device, const PortFailure& failure) {
  const std::lock_guard lock(mutex_);
  view_.device = device;
  view_.denied = failure.code == PortError::no_permission;
}

void SpaceMouseReader::report(std::span<const std::uint8_t> report, HidTime now) {
  const std::lock_guard lock(mutex_);
  if (state_.take(report, now)) ++view_.reports;
}

void SpaceMouseReader::polled(HidTime) {}

void SpaceMouseReader::lost() {
  const std::lock_guard lock(mutex_);
  state_.release();
  view_.device.reset();
  view_.connected = false;
}

}  // namespace cusp::device::hid
