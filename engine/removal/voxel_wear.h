/// Removal for the filled reading: eq. (5) of the paper, per time. Thread: haptic; wait-free.
#pragma once

#include <array>
#include <span>

#include "engine/scene/scene.h"
#include "engine/volume/occupancy.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

struct VoxelWear {
  bool any = false;       // a voxel lost density
  bool overflow = false;  // a brick had no room
  bool gone = false;      // a voxel lost its last density
  IVec3 low{0}, high{0};  // of those, inclusive; valid when gone
};

/// D' = D - k_tool alpha 40 dt with D_tissue of eq. (6), as a fraction of the tissue's density, for every voxel that
/// would hit one step further; on a diagonal (step: -1, 0 or 1 by axis) divided by its length in voxels. remainder: wear
/// below one quantum of s, a remainder for each tissue; kept from tick to tick.
VoxelWear wear_voxels(Volume& volume, Occupancy& occupancy, const Scene& scene, std::span<const IVec3> hit, IVec3 step,
                      double alpha, double dt_s, std::array<double, kTissueCodes>& remainder) noexcept;

}  // namespace cusp::engine
