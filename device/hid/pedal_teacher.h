/// Finds out which control a foot moves, and from where to where: first what stands at rest, then what is held down.
/// Pure.
#pragma once

#include <optional>
#include <vector>

#include "device/hid/pedal.h"

namespace cusp::device::hid {

struct Taught {
  ControlId id;
  ControlKind kind = ControlKind::button;
  PedalCalibration calibration = PedalCalibration::of_switch();
};

class PedalTeacher {
 public:
  /// An axis that moves less of its range than this was not meant.
  static constexpr double kLeastWay = 0.2;

  /// The foot is off: forgets what was pressed before.
  void rest(const std::vector<Control>& controls);
  /// The foot is on its way or down; as often as one likes. The furthest place counts.
  void press(const std::vector<Control>& controls);
  /// What moved the most; nothing yet when nothing moved enough. Of a switch and an axis that both did, the axis.
  std::optional<Taught> found(double dead_zone = PedalCalibration::kUsualDeadZone) const;

 private:
  struct Way {
    Control rest;
    std::int32_t furthest = 0;
  };
  std::vector<Way> ways_;
};

}  // namespace cusp::device::hid
