/// The paper's bur: voxels of the specimen's size about the pivot's voxel, cutting ones and the others.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/tool/bur.h"

namespace cusp::engine {

struct VoxelTool {
  std::vector<IVec3> cutting;  // offsets from the pivot's voxel, in order of z, y, x
  std::vector<IVec3> holder;   // outer voxels of neck and shank: they collide and never cut
  int reach = 0;               // voxels from the pivot to the furthest cutting one
};

/// Voxels whose centre lies in the bur; axis: unit, from the head towards the shank. Not for the haptic thread.
VoxelTool voxelise(const Bur& bur, Vec3 axis, double voxel_mm);

}  // namespace cusp::engine
