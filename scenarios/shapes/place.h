/// Where a place lies beside the target: in the tolerance zone (`leeway` in the format) or beyond it, and off which face.
/// A place belongs to the face that it is nearest to; off the rounded edge the bisector divides. Any thread.
#pragma once

#include <cstdint>

#include "scenarios/shapes/outline.h"

namespace cusp::scenarios {

enum class Place : std::uint8_t { target, tolerated_floor, tolerated_side, beyond_floor, beyond_side };
inline constexpr int kPlaces = 5;

/// From the two distances (TargetShape::outline_mm and below_floor_mm).
inline Place place_of(double u, double v, double corner_mm, const Leeway& leeway) noexcept {
  const double d = rounded_corner(u, v, corner_mm);
  if (d <= 0.0) return Place::target;
  if (v >= u) return d <= leeway.floor_mm ? Place::tolerated_floor : Place::beyond_floor;
  return d <= leeway.side_mm ? Place::tolerated_side : Place::beyond_side;
}
inline Place place_of(const TargetShape& shape, const Leeway& leeway, Vec3 p) noexcept {
  return place_of(shape.outline_mm({p.x, p.y}), shape.below_floor_mm(p.z), shape.corner_mm(), leeway);
}

}  // namespace cusp::scenarios
