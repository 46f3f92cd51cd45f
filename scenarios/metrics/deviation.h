/// How far a surface point is off the target, for the report's colouring.
#pragma once

#include <cstdint>
#include <optional>

#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

/// Surface of a specimen (SurfacePoint::cut): made by a bur, or the specimen's own.
enum class SurfaceKind : std::uint8_t { original, cut };

/// Signed deviation in mm: positive over-cut (the cut surface lies outside the target), negative uncut remainder (tissue
/// reaches into the target). nullopt: the original surface outside the target, which nobody was to touch.
[[nodiscard]] inline std::optional<double> deviation_mm(const TargetShape& target, Vec3 point_mm,
                                                        SurfaceKind surface) noexcept {
  if (target.empty()) return std::nullopt;
  const double d = target.distance_mm(point_mm);
  if (surface == SurfaceKind::original && d >= 0.0) return std::nullopt;
  return d;
}

}  // namespace cusp::scenarios
