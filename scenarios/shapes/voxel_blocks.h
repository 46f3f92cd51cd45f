/// Leaves of a BoxTree over one thing at each of many voxels: those of a block of four voxels along an edge share one.
#pragma once

#include <utility>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/box_tree.h"

namespace cusp::scenarios {

inline IVec3 block_of(IVec3 voxel) noexcept { return {voxel.x >> 2, voxel.y >> 2, voxel.z >> 2}; }

/// box_of(i): low and high corner of the thing at voxels[i]. Pre: voxels of a block stand side by side.
template <class BoxOf>
std::vector<BoxTree::Leaf> leaves_of_blocks(const std::vector<IVec3>& voxels, BoxOf&& box_of) {
  std::vector<BoxTree::Leaf> leaves;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const std::pair<Vec3, Vec3> box = box_of(i);
    if (i == 0 || block_of(voxels[i]) != block_of(voxels[i - 1])) leaves.push_back({box.first, box.second, i, i});
    BoxTree::Leaf& leaf = leaves.back();
    leaf.low = glm::min(leaf.low, box.first);
    leaf.high = glm::max(leaf.high, box.second);
    leaf.last = i + 1;
  }
  return leaves;
}

}  // namespace cusp::scenarios
