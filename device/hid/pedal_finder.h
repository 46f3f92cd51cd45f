/// Finds the control that a foot moves, and its two ends: first the values at rest, then the values while pressed, then those
/// with the foot off again. Pure.
#pragma once

#include <optional>
#include <vector>

#include "device/hid/pedal.h"

namespace cusp::device::hid {

struct FoundControl {
  ControlId id;
  ControlKind kind = ControlKind::button;
  PedalCalibration calibration = PedalCalibration::of_switch();
};

class PedalFinder {
 public:
  /// Least movement of an axis, as a share of its range.
  static constexpr double kLeastWay = 0.2;
  /// Most that the value with the foot off again is apart from the one at rest, as a share of the movement: a worn spring.
  static constexpr double kMostApart = 0.2;

  /// Values with the foot off. Forgets earlier presses.
  void rest(const std::vector<Control>& controls);
  /// Values while the foot presses; any number of calls. The furthest value counts.
  void press(const std::vector<Control>& controls);
  /// A switch or key that was down at rest(): a foot was on it, or it opens when pressed. nullopt if none was.
  std::optional<Control> down_at_rest() const;
  /// The control that moved the most, an axis before a switch; nullopt if none moved enough.
  std::optional<FoundControl> found(double dead_zone = PedalCalibration::kUsualDeadZone) const;
  /// The found control, of values with the foot off again; both values at rest are released. nullopt while it is apart from
  /// where it rested: a foot is on it now, or was on it at rest(), and its ends would be the wrong way round.
  std::optional<FoundControl> released(const std::vector<Control>& controls, double dead_zone = PedalCalibration::kUsualDeadZone) const;

 private:
  struct Way {
    Control rest;
    std::int32_t furthest = 0;
  };
  static void move(Way& of, std::int32_t to);
  const Way* best() const;
  std::vector<Way> ways_;
};

}  // namespace cusp::device::hid
