/// Frictionless contact in closed form, in place of the engine: planes that push a point back out.
#pragma once

#include <cmath>
#include <vector>

#include "engine/base/haptic_port.h"

namespace cusp::test {

/// Tissue lies where dot(normal, p - point) < 0.
struct Plane {
  Vec3 point_mm{0.0};
  Vec3 normal{0.0, 0.0, 1.0};
};

class ToyTissue {
 public:
  double stiffness_n_per_mm = 2.0;
  std::vector<Plane> planes{Plane{}};

  /// The proxy of a device point: projected onto every plane it lies behind (exact for planes at right angles).
  Feedback feel(Vec3 device_mm) const {
    Feedback out;
    out.proxy_mm = device_mm;
    for (const Plane& plane : planes) {
      const double depth = glm::dot(plane.normal, out.proxy_mm - plane.point_mm);
      if (depth < 0.0) out.proxy_mm -= plane.normal * depth;
    }
    out.stiffness_n_per_mm = stiffness_n_per_mm;
    out.force_n = (out.proxy_mm - device_mm) * stiffness_n_per_mm;
    out.in_contact = out.proxy_mm != device_mm;
    return out;
  }
};

}  // namespace cusp::test
