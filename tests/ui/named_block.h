/// A block of one tissue that its author has named.
#pragma once

#include "engine/volume/voxel_volume.h"
#include "tests/modules.h"

namespace cusp::test {

/// 4.8 mm each way, of the code 16: "pulp stone".
inline VoxelVolume named_block() {
  VoxelVolume out(Grid{IVec3(20), 0.4, Vec3(-3.8)});
  IVec3 v;
  for (v.z = 4; v.z < 16; ++v.z)
    for (v.y = 4; v.y < 16; ++v.y)
      for (v.x = 4; v.x < 16; ++v.x) {
        out.tissue[out.grid.index(v)] = Tissue{16};
        out.s[out.grid.index(v)] = kSolid;
      }
  out.names[16] = "pulp stone";
  return out;
}

}  // namespace cusp::test
