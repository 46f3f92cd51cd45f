#include "device/hid/pedal.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::hid {

namespace {

constexpr double kFull = 65535.0;
constexpr std::uint16_t kFirstKey = 0x04;  // lower codes: no key, or too many keys

std::optional<ControlKind> kind_of(const InputField& field) noexcept {
  if (field.relative || field.most <= field.least) return std::nullopt;
  if (field.page == usage::kButtonPage && field.usage != 0) return ControlKind::button;
  if (field.page == usage::kKeyPage) return ControlKind::key;
  const bool one_bit = field.least == 0 && field.most == 1;
  if (field.page == usage::kDesktopPage && field.usage >= 0x30 && field.usage <= 0x38)
    return one_bit ? ControlKind::button : ControlKind::axis;
  // Rudder, throttle, accelerator, brake, clutch, and what else a foot moves in a simulation.
  if (field.page == usage::kSimulationPage && field.usage >= 0xB0)
    return one_bit ? ControlKind::button : ControlKind::axis;
  return std::nullopt;
}

}  // namespace

std::optional<PedalCalibration> PedalCalibration::from(std::int32_t released, std::int32_t pressed,
                                                       double dead_zone) noexcept {
  if (released == pressed || !(dead_zone >= kLeastDeadZone && dead_zone <= kMostDeadZone)) return std::nullopt;
  return PedalCalibration(released, pressed, dead_zone);
}

std::uint16_t PedalCalibration::pressed(std::int32_t raw) const noexcept {
  const double way = static_cast<double>(pressed_) - released_;
  const double share = (static_cast<double>(raw) - released_) / way;
  const double live = (share - dead_zone_) / (1.0 - 2.0 * dead_zone_);
  return static_cast<std::uint16_t>(std::lround(kFull * std::clamp(live, 0.0, 1.0)));
}

PedalState::PedalState(const ReportDescriptor& descriptor) : bytes_(descriptor.bytes), numbered_(descriptor.numbered) {
  std::size_t slots = 0;
  for (const InputField& field : descriptor.inputs) {
    if (field.list) {
      if (field.page != usage::kKeyPage && field.page != usage::kButtonPage) continue;
      if (slots + field.count > kMostKeys) continue;
      slots += field.count;
      lists_.push_back(field);
      continue;
    }
    const auto kind = kind_of(field);
    if (!kind) continue;
    Held held;
    held.field = field;
    held.kind = *kind;
    held.id = {field.page, field.usage, 0};
    for (const Held& before : held_) {
      if (before.id.page == field.page && before.id.usage == field.usage && held.id.index < 255) ++held.id.index;
    }
    held_.push_back(held);
  }
}

bool PedalState::take(std::span<const std::uint8_t> report) noexcept {
  std::uint8_t number = 0;
  if (numbered_) {
    if (report.empty()) return false;
    number = report[0];
    report = report.subspan(1);
  }
  if (bytes_[number] == 0 || report.size() < bytes_[number]) return false;
  for (Held& held : held_) {
    if (held.field.report != number) continue;
    if (const auto value = value_in(held.field, report)) held.value = *value;
  }
  std::size_t kept = 0;  // keys of other reports stay
  for (std::size_t i = 0; i < key_count_; ++i) {
    if (keys_[i].report != number) keys_[kept++] = keys_[i];
  }
  key_count_ = kept;
  for (const InputField& list : lists_) {
    if (list.report != number) continue;
    for (std::uint16_t slot = 0; slot < list.count; ++slot) {
      const auto value = value_in(list, report, slot);
      if (!value) continue;
      const std::int64_t named = static_cast<std::int64_t>(list.usage) + *value - list.least;
      const bool nothing = list.page == usage::kKeyPage ? named < kFirstKey : named <= 0;
      if (nothing || named > UINT16_MAX || key_count_ >= keys_.size()) continue;
      keys_[key_count_++] = {{list.page, static_cast<std::uint16_t>(named), 0}, number};
    }
  }
  return true;
}

void PedalState::release() noexcept {
  for (Held& held : held_) held.value.reset();
  key_count_ = 0;
}

std::vector<Control> PedalState::controls() const {
  std::vector<Control> out;
  for (const Held& held : held_) {
    out.push_back({held.id, held.kind, held.field.least, held.field.most, held.value.value_or(held.field.least),
                   held.value.has_value()});
  }
  for (std::size_t i = 0; i < key_count_; ++i) {
    const bool button = keys_[i].id.page == usage::kButtonPage;
    out.push_back({keys_[i].id, button ? ControlKind::button : ControlKind::key, 0, 1, 1, true});
  }
  return out;
}

std::optional<std::int32_t> PedalState::value(ControlId id) const noexcept {
  for (const Held& held : held_) {
    if (held.id != id) continue;
    if (held.value) return held.value;
    return held.kind == ControlKind::axis ? std::nullopt : std::optional<std::int32_t>(0);
  }
  for (std::size_t i = 0; i < key_count_; ++i) {
    if (keys_[i].id == id) return 1;
  }
  return lists_.empty() ? std::nullopt : std::optional<std::int32_t>(0);
}

bool PedalState::any_switch() const noexcept {
  if (key_count_ > 0) return true;
  return std::any_of(held_.begin(), held_.end(), [](const Held& held) {
    return held.kind != ControlKind::axis && held.value.value_or(held.field.least) > held.field.least;
  });
}

bool is_known_pedal(std::uint16_t vendor, std::uint16_t product) noexcept { return vendor == 0x05f3 && product == 0x00ff; }

PedalReading reading_of(const PedalState& state, const PedalSettings& settings) noexcept {
  PedalReading out;
  if (!settings.on) return out;
  if (!settings.drill) {
    out.pressed = state.any_switch() ? 65535 : 0;
  } else if (const auto raw = state.value(*settings.drill)) {
    out.pressed = settings.calibration.pressed(*raw);
  }
  if (settings.coolant) {
    out.coolant = state.value(*settings.coolant).value_or(0) != 0;
    // Without this the coolant's switch would drill, if any switch drills.
    if (!settings.drill && out.coolant) out.pressed = 0;
  }
  return out;
}

}  // namespace cusp::device::hid
