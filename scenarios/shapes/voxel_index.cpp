#include "scenarios/shapes/voxel_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/shapes/voxel_blocks.h"

namespace cusp::scenarios {

VoxelIndex::VoxelIndex(const Specimen& specimen, const TissueSet& tissues) : grid_(specimen.grid()) {
  const IVec3 bricks = specimen.brick_count();
  const auto is_one = [&](IVec3 v) { return tissues[index_of(specimen.tissue(v))] && was_solid(specimen, v); };
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (specimen.uniform(b) && !tissues[index_of(specimen.tissue_in(b, 0))]) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (!is_one(v)) continue;
      bool outermost = false;
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -1; step <= 1; step += 2) {
          IVec3 next = v;
          next[axis] += step;
          outermost = outermost || !is_one(next);
        }
      if (outermost) voxels_.push_back(v);
    }
  }
  index();
}

VoxelIndex::VoxelIndex(const Grid& grid, std::vector<IVec3> voxels) : grid_(grid), voxels_(std::move(voxels)) {
  const auto key = [](IVec3 v) { return std::array{v.z, v.y, v.x}; };
  std::ranges::sort(voxels_, {}, key);
  voxels_.erase(std::unique(voxels_.begin(), voxels_.end()), voxels_.end());
  index();
}

void VoxelIndex::index() {
  std::ranges::stable_sort(voxels_, {}, [](IVec3 v) {
    const IVec3 block = block_of(v);
    return std::array{block.z, block.y, block.x};
  });
  tree_ = BoxTree(leaves_of_blocks(voxels_, [&](std::size_t i) {
    const Vec3 centre = grid_.centre_mm(voxels_[i]);
    return std::pair{centre - 0.5 * grid_.voxel_mm, centre + 0.5 * grid_.voxel_mm};
  }));
}

double VoxelIndex::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (voxels_.empty()) return at_most_mm;
  return std::sqrt(tree_.nearest_squared(p, at_most_mm * at_most_mm, [&](std::size_t i, double) {
    const Vec3 centre = grid_.centre_mm(voxels_[i]);
    return BoxTree::gap_squared(p, centre - 0.5 * grid_.voxel_mm, centre + 0.5 * grid_.voxel_mm);
  }));
}

}  // namespace cusp::scenarios
