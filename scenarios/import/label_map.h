/// A map of tissue codes made into a specimen: cropped, padded, and with a band of distances about its surface.
#pragma once

#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// The box of what is not empty.
struct LabelBox {
  IVec3 first, last;
  bool empty() const noexcept { return first.x > last.x; }
};
LabelBox box_of_labels(const Grid& grid, const std::vector<Tissue>& labels);
/// The box of the voxels for whose index `holds` is true.
template <class Holds>
LabelBox box_where(const Grid& grid, Holds holds) {
  LabelBox box{grid.size, IVec3(-1)};
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
        if (!holds(i)) continue;
        box.first = glm::min(box.first, v);
        box.last = glm::max(box.last, v);
      }
  return box;
}

/// The grid of that box with kPadVoxels about it.
Grid padded_grid(const Grid& grid, const LabelBox& box);

/// Of the nearest labelled voxel within four; the first in index order when several are as near; empty when none is.
Tissue nearest_label(const Grid& grid, const std::vector<Tissue>& labels, IVec3 at);

/// s from the distance to the nearest voxel of the other side, less half a voxel: exact on faces along the axes, up to
/// half a voxel off elsewhere, for that is all a label map knows. Pre: the box is not empty.
VoxelVolume volume_of_labels(const Grid& grid, const std::vector<Tissue>& labels);

}  // namespace cusp::scenarios
