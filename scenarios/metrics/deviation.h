/// How far a surface point is off the target, for the report's colouring.
#pragma once

#include <optional>

#include "scenarios/shapes/outline.h"

namespace cusp::scenarios {

/// Signed deviation in mm: positive over-cut (the cut surface lies outside the target), negative uncut remainder (tissue
/// reaches into the target). `cut`: the point is on a surface left by a bur
/// (SurfacePoint::cut). nullopt: the specimen's own surface outside the target, which nobody was to touch.
[[nodiscard]] inline std::optional<double> deviation_mm(const TargetShape& target, Vec3 point_mm, bool cut) noexcept {
  if (target.empty()) return std::nullopt;
  const double d = target.distance_mm(point_mm);
  if (!cut && d >= 0.0) return std::nullopt;
  return d;
}

}  // namespace cusp::scenarios
