/// The nearest place in an intersection of half spaces, exactly: what an exact proxy's step comes to once the faces about it
/// are told by planes. Any thread; not for the haptic one.
#pragma once

#include <vector>

#include "engine/base/vec.h"

namespace cusp::bench {

using Mat3 = glm::dmat3;

/// n . c >= level is admissible; `bend` is how the normal turns: the second derivative of what it stands for, negated.
struct HalfSpace {
  Vec3 n{0.0};
  double level = 0.0;
  Mat3 bend{0.0};
};

/// The minimum of (c - z) . H (c - z) over the half spaces' intersection, given H's inverse. bend: the sum of the
/// binding ones' bends by their weights.
struct Found {
  Vec3 c{0.0};
  Mat3 bend{0.0};
};
Found nearest_in(Vec3 z, const Mat3& inverse, const std::vector<HalfSpace>& spaces);

}  // namespace cusp::bench
