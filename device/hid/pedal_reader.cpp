#include "device/hid/pedal_reader.h"

#include <algorithm>

namespace cusp::device::hid {

namespace {

// latest_: pressed in the lowest 16 bits, coolant above, then the milliseconds of the clock in the upper 32.
constexpr std::uint64_t kCoolantBit = 1u << 16;

std::uint32_t milliseconds(HidTime now) noexcept {
  return static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count());
}

bool has_controls(const HidDevice& device) {
  const auto parsed = parse_report_descriptor(device.descriptor);
  if (!parsed) return false;
  return std::any_of(parsed->inputs.begin(), parsed->inputs.end(), [](const InputField& field) {
    return field.page == usage::kButtonPage || field.page == usage::kKeyPage ||
           (field.page == usage::kSimulationPage && !field.relative) ||
           (field.page == usage::kDesktopPage && field.usage >= 0x30 && field.usage <= 0x38 && !field.relative);
  });
}

}  // namespace

PedalReader::PedalReader(std::function<std::unique_ptr<HidBus>()> make_bus, const PedalSettings& settings)
    : settings_(settings), follower_(std::move(make_bus), *this) {}

PedalReader::~PedalReader() { follower_.stop(); }

PedalReading PedalReader::latest(std::chrono::steady_clock::time_point now) const noexcept {
  const std::uint64_t value = latest_.load(std::memory_order_acquire);
  // Wraps after 49 days, as the difference does.
  const std::uint32_t since = milliseconds(now) - static_cast<std::uint32_t>(value >> 32);
  // The reader may have polled just after the tick took its time.
  if (since > static_cast<std::uint32_t>(kStale.count()) && since < UINT32_MAX / 2) return {};
  return {static_cast<std::uint16_t>(value), (value & kCoolantBit) != 0};
}

PedalView PedalReader::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

PedalSettings PedalReader::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

void PedalReader::set_settings(const PedalSettings& settings) {
  {
    const std::lock_guard lock(mutex_);
    settings_ = settings;
  }
  follower_.again();
}

std::optional<HidDevice> PedalReader::choose(const std::vector<HidDevice>& devices) {
  std::vector<HidDevice> some;
  for (const HidDevice& device : devices) {
    if (has_controls(device)) some.push_back(device);
  }
  const std::lock_guard lock(mutex_);
  view_.denied = false;
  view_.devices = std::move(some);
  const auto wanted = [this](const HidDevice& device) {
    return settings_.vendor != 0
               ? device.vendor == settings_.vendor && device.product == settings_.product &&
                     (settings_.interface_number < 0 || device.interface_number == settings_.interface_number)
               : is_known_pedal(device.vendor, device.product);
  };
  // The pedal in use stays so if another of its kind is plugged in, whose path may sort before.
  if (view_.connected && view_.device && wanted(*view_.device) && std::ranges::find(view_.devices, *view_.device) != view_.devices.end())
    return view_.device;
  const auto first = std::ranges::find_if(view_.devices, wanted);
  if (first != view_.devices.end()) return *first;
  view_.device.reset();  // one that was refused is gone as well
  return std::nullopt;
}

void PedalReader::opened(const HidDevice& device) {
  if (auto parsed = parse_report_descriptor(device.descriptor)) state_.emplace(*parsed);
  const std::lock_guard lock(mutex_);
  view_.device = device;
  view_.connected = true;
  view_.controls = state_ ? state_->controls() : std::vector<Control>();
}

void PedalReader::refused(const HidDevice& device, const PortFailure& failure) {
  const std::lock_guard lock(mutex_);
  view_.device = device;
  view_.denied = failure.code == PortError::no_permission;
}

void PedalReader::report(std::span<const std::uint8_t> report, HidTime now) {
  if (!state_ || !state_->take(report)) return;
  publish(now);
  const std::lock_guard lock(mutex_);
  ++view_.reports;
  view_.controls = state_->controls();
}

void PedalReader::polled(HidTime now) { publish(now); }

void PedalReader::lost() {
  state_.reset();
  latest_.store(0, std::memory_order_release);
  const std::lock_guard lock(mutex_);
  view_.device.reset();
  view_.connected = false;
  view_.controls.clear();
  view_.reading = {};
}

void PedalReader::publish(HidTime now) {
  PedalReading reading;
  if (state_) {
    const std::lock_guard lock(mutex_);
    reading = reading_of(*state_, settings_);
    view_.reading = reading;
  }
  latest_.store(static_cast<std::uint64_t>(milliseconds(now)) << 32 | (reading.coolant ? kCoolantBit : 0) | reading.pressed,
                std::memory_order_release);
}

}  // namespace cusp::device::hid
