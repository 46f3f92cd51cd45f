/// Where some tissues of the uncut specimen end, below a voxel. A tissue is known to a voxel: the surface runs where a normal
/// smoothing of its voxels is one half, so that a slanting border has no steps.
/// Frame: specimen. Millimetres. Immutable; any thread; no memory per query.
#pragma once

#include <memory>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/box_tree.h"
#include "scenarios/shapes/voxel_index.h"

namespace cusp::scenarios {

class BorderSurface {
 public:
  /// Tens of milliseconds.
  BorderSurface(std::shared_ptr<const Specimen> specimen, const TissueSet& tissues);
  bool empty() const noexcept { return patches_.empty(); }
  /// Distance from a place outside to the surface, 0 up to a voxel below it; at most `at_most_mm`, which is also the answer
  /// where there is none: the search stops there. It changes by no more than the place.
  double distance_mm(Vec3 p, double at_most_mm) const noexcept;
  /// The outermost voxels of these tissues.
  const std::vector<IVec3>& voxels() const noexcept { return voxels_; }

 private:
  /// A disc of the surface beside one of the outermost voxels, a voxel thick below. A voxel without a side has no normal: its
  /// patch is a ball.
  struct Patch {
    Vec3 at_mm{0.0};
    Vec3 out{0.0};
  };

  Patch patch_of(IVec3 v) const noexcept;
  double squared_to(const Patch& patch, Vec3 p) const noexcept;
  bool has(IVec3 v) const noexcept { return tissues_[index_of(specimen_->tissue(v))] && was_solid(*specimen_, v); }

  std::shared_ptr<const Specimen> specimen_;
  TissueSet tissues_;
  std::vector<IVec3> voxels_;
  std::vector<Patch> patches_;  // of voxels_, in their order
  BoxTree tree_;
};

}  // namespace cusp::scenarios
