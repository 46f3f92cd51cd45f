/// nearest_in solves one step of an exact proxy: the nearest point of an intersection of half spaces, exactly.
/// Thread: any but the haptic one; it allocates.
#pragma once

#include <vector>

#include "engine/base/vec.h"

namespace cusp::bench {

using Mat3 = glm::dmat3;

/// n . c >= level is admissible. bend: negated second derivative of the surface that the half space replaces.
struct HalfSpace {
  Vec3 n{0.0};
  double level = 0.0;
  Mat3 bend{0.0};
};

/// The minimum of (c - z) . H (c - z) over the intersection, given H's inverse. bend: weighted sum over the active set.
struct Found {
  Vec3 c{0.0};
  Mat3 bend{0.0};
};
Found nearest_in(Vec3 z, const Mat3& inverse, const std::vector<HalfSpace>& spaces);

}  // namespace cusp::bench
