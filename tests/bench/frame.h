/// A shape's axes in the specimen frame: x and y along the surface, z out of the tissue, oblique to the grid.
#pragma once

#include <cmath>

#include "engine/base/vec.h"

namespace cusp::bench {

inline double length(Vec3 v) { return std::sqrt(glm::dot(v, v)); }
inline Vec3 unit(Vec3 v) { return v / length(v); }

struct Frame {
  Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
  Vec3 origin{0.0};

  Vec3 to_world(Vec3 p) const { return origin + x * p.x + y * p.y + z * p.z; }
  Vec3 to_local(Vec3 p) const {
    const Vec3 d = p - origin;
    return {glm::dot(d, x), glm::dot(d, y), glm::dot(d, z)};
  }
  Vec3 direction(Vec3 d) const { return x * d.x + y * d.y + z * d.z; }

  /// z nearest to `up`, x nearest to `along`.
  static Frame of(Vec3 up, Vec3 along, Vec3 at) {
    Frame f;
    f.z = unit(up);
    f.x = unit(along - f.z * glm::dot(along, f.z));
    f.y = glm::cross(f.z, f.x);
    f.origin = at;
    return f;
  }
};

/// 12 degrees from the grid's z, 27 from its x; the origin 0.1 to 0.3 voxels (10/128 mm) off any grid plane.
inline Frame oblique_frame() { return Frame::of({0.11, 0.18, 1.0}, {1.0, 0.51, 0.0}, {0.0137, -0.0211, 0.0173}); }

}  // namespace cusp::bench
