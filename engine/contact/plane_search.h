/// Closest admissible point: min |y - q|^2 with n_i . y >= c_i, in three dimensions, at most three planes active.
/// Dual active set (Goldfarb and Idnani 1983): starts at q, adds the most violated plane, drops those that pull.
/// Wait-free, bounded; ties go to the lowest index. Units as given (mm). Thread: haptic.
#pragma once

#include <cstdint>
#include <span>

#include "engine/base/vec.h"

namespace cusp {

struct Plane {
  Vec3 n{0.0};           // unit, out of the tissue
  double c = 0.0;        // n . y >= c is admissible
  std::int32_t from = 0; // candidate that it stands for
};

struct PlaneSearch {
  Vec3 y{0.0};
  int active = 0;              // number of active planes, at most 3
  int index[3] = {0, 0, 0};    // into the span given
  double weight[3] = {0, 0, 0};// multipliers: y - q = sum weight * n
  bool feasible = true;
};

/// tolerance_mm: a plane counts as violated below -tolerance.
PlaneSearch closest_point(Vec3 q, std::span<const Plane> planes, double tolerance_mm) noexcept;

}  // namespace cusp
