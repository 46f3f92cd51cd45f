/// Removal for the surface reading: what a burr's ball sweeps is gone. Thread: haptic; wait-free.
#pragma once

#include "engine/volume/volume.h"

namespace cusp {

/// What one carving came to.
struct Carved {
  bool any = false;        // a value changed
  bool overflow = false;   // a brick had no room
  IVec3 low{0}, high{0};   // voxels that may have changed, inclusive; valid when any
};

/// Unites the cut field with a ball of radius_mm swept from a to b (mm): C = min(C, solid(r - distance to ab)).
/// Calls touched() once for every brick that changed.
Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm) noexcept;

}  // namespace cusp
