/// How far a foot pedal is down, from its reports: every HID device with buttons, keys or axes. Pure.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/hid/report_descriptor.h"
#include "engine/base/pedal_source.h"

namespace cusp::device::hid {

/// A control that a foot can move: a button, an axis, or a key of a pedal that acts as a keyboard.
struct ControlId {
  std::uint16_t page = 0, usage = 0;
  std::uint8_t index = 0;  // which of several with the same usage
  friend auto operator<=>(const ControlId&, const ControlId&) = default;
};

enum class ControlKind : std::uint8_t { button, axis, key };

struct Control {
  ControlId id;
  ControlKind kind = ControlKind::button;
  std::int32_t least = 0, most = 1;
  std::int32_t value = 0;  // newest; `least` before the first report
  bool reported = false;   // false: no report yet, and an axis may stand anywhere
  friend bool operator==(const Control&, const Control&) = default;
};

/// Raw values at rest and fully down; many rheostats rest at their maximum. Linear in between, without a dead zone at both
/// ends.
class PedalCalibration {
 public:
  static constexpr double kLeastDeadZone = 0.0, kMostDeadZone = 0.3, kUsualDeadZone = 0.04;
  /// nullopt if both values are equal or the dead zone (a share of the range) is out of range.
  static std::optional<PedalCalibration> from(std::int32_t released, std::int32_t pressed,
                                              double dead_zone = kUsualDeadZone) noexcept;
  /// A switch: 0 released, 1 pressed.
  static PedalCalibration of_switch() noexcept { return PedalCalibration(0, 1, 0.0); }

  /// 0 released to 65535 fully down; rises with the way, whatever the direction of the raw values.
  std::uint16_t pressed(std::int32_t raw) const noexcept;
  std::int32_t released_raw() const noexcept { return released_; }
  std::int32_t pressed_raw() const noexcept { return pressed_; }
  double dead_zone() const noexcept { return dead_zone_; }
  friend bool operator==(const PedalCalibration&, const PedalCalibration&) = default;

 private:
  PedalCalibration(std::int32_t released, std::int32_t pressed, double dead_zone) noexcept
      : released_(released), pressed_(pressed), dead_zone_(dead_zone) {}
  std::int32_t released_, pressed_;
  double dead_zone_;
};

/// State of a device after its reports.
class PedalState {
 public:
  explicit PedalState(const ReportDescriptor& descriptor);

  /// A report as read, its number first if the device uses numbers. False, and no change, for a report that is too short or
  /// of an unknown number. No allocation.
  bool take(std::span<const std::uint8_t> report) noexcept;
  /// Forgets all reports: the device was lost.
  void release() noexcept;

  /// Buttons and axes in the descriptor's order, then the keys that are down.
  std::vector<Control> controls() const;
  /// Newest value. Without a report a button or key is up, and an axis has none.
  std::optional<std::int32_t> value(ControlId id) const noexcept;
  /// Any button or key is down.
  bool any_switch() const noexcept;

 private:
  struct Held {
    InputField field;
    ControlId id;
    ControlKind kind = ControlKind::button;
    std::optional<std::int32_t> value;
  };
  static constexpr std::size_t kMostKeys = 32;  // slots of all lists together
  struct Key {
    ControlId id;
    std::uint8_t report = 0;
  };
  std::vector<Held> held_;
  std::vector<InputField> lists_;
  std::array<Key, kMostKeys> keys_{};  // down now
  std::size_t key_count_ = 0;
  std::array<std::uint16_t, 256> bytes_{};
  bool numbered_ = false;
};

/// Which device and control drive the handpiece.
struct PedalSettings {
  bool on = true;
  std::uint16_t vendor = 0, product = 0;  // 0: the first pedal that is known to be one (is_known_pedal)
  int interface_number = -1;
  std::optional<ControlId> drill;         // nullopt: any button of a known pedal
  PedalCalibration calibration = PedalCalibration::of_switch();
  std::optional<ControlId> coolant;       // down: coolant runs
  friend bool operator==(const PedalSettings&, const PedalSettings&) = default;
};

/// Devices that are pedals and nothing else, which drill without being chosen: VEC Infinity (05f3:00ff).
bool is_known_pedal(std::uint16_t vendor, std::uint16_t product) noexcept;

/// The reading that a state gives.
PedalReading reading_of(const PedalState& state, const PedalSettings& settings) noexcept;

}  // namespace cusp::device::hid
