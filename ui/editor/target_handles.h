/// The handles on a target: where they stand and what moving one makes of the target. No window.
/// Frame: specimen, z up. Millimetres.
#pragma once

#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

struct TargetHandle {
  enum class Kind { point, width, size_x, size_y, depth };
  Kind kind = Kind::point;
  std::size_t path = 0, point = 0;  // of a point; where paths meet, of the first of them
  Vec3 at_mm{0.0};                  // on the reference plane; the depth's on the floor
  friend bool operator==(const TargetHandle&, const TargetHandle&) = default;
};

inline constexpr double kLeastHandleMm = 0.1;  // width, depth and sides dragged together stay this wide
inline constexpr double kHandleStepMm = 0.01;  // what a drag rounds to

/// Every point once (points of several paths at one place are one handle), then width or sides, then depth.
std::vector<TargetHandle> handles_of(const Target& target);

/// The target after the handle was moved to a place: a point goes there in the occlusal plane (with all points at its
/// place), width and sides reach there, the floor sinks or rises there. Rounded to kHandleStepMm.
/// Pre: the handle is one of handles_of(target).
Target moved(const Target& target, const TargetHandle& handle, Vec3 to_mm);

}  // namespace cusp::ui
