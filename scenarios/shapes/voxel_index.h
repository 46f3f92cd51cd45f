/// Distance to the voxels of some tissues. A tissue is known to a voxel.
/// Frame: specimen. Millimetres. Immutable; any thread.
#pragma once

#include <array>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/box_tree.h"

namespace cusp::scenarios {

/// Which tissue codes.
using TissueSet = std::array<bool, kTissueCodes>;

/// A voxel is there in the specimen's own reading before anything was cut.
inline bool was_solid(const Specimen& specimen, IVec3 v) noexcept {
  return specimen.reading() == Reading::filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf;
}

/// The outermost voxels of these tissues, as cubes.
class VoxelIndex {
 public:
  VoxelIndex(const Specimen& specimen, const TissueSet& tissues);
  /// Of these voxels, each as a cube.
  VoxelIndex(const Grid& grid, std::vector<IVec3> voxels);
  bool empty() const noexcept { return voxels_.empty(); }
  /// Distance from a place outside to the nearest of them, 0 in an outermost one; at most `at_most_mm`, which is also the
  /// answer where there is none: the search stops there.
  double distance_mm(Vec3 p, double at_most_mm) const noexcept;
  const std::vector<IVec3>& surface_voxels() const noexcept { return voxels_; }

 private:
  void index();

  Grid grid_;
  std::vector<IVec3> voxels_;
  BoxTree tree_;
};

}  // namespace cusp::scenarios
