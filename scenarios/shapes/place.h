/// Where a place lies beside the target: in the tolerance zone (`leeway` in the format) or beyond it, and off which face.
/// A place belongs to the face that it is nearest to; off the rounded edge the bisector divides. Any thread.
#pragma once

#include <cstdint>

#include "scenarios/format/scenario.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

enum class Place : std::uint8_t { target, tolerated_floor, tolerated_side, beyond_floor, beyond_side };
inline constexpr int kPlaces = 5;

inline Place place_of(const Near& near, const Leeway& leeway) noexcept {
  if (near.distance_mm <= 0.0) return Place::target;
  const bool tolerated = near.distance_mm <= leeway.of(near.face);
  if (near.floor_mm >= near.wall_mm) return tolerated ? Place::tolerated_floor : Place::beyond_floor;
  return tolerated ? Place::tolerated_side : Place::beyond_side;
}
inline Place place_of(const TargetShape& shape, const Leeway& leeway, Vec3 p) noexcept { return place_of(shape.near(p), leeway); }

}  // namespace cusp::scenarios
