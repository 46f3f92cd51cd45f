/// The voxels of some tissues in the uncut specimen as a signed distance. A tissue is known to a voxel: the shape is the union
/// of its voxels' cubes. Frame: specimen. Millimetres. Immutable; any thread; no memory per query.
#pragma once

#include <memory>

#include "engine/volume/specimen.h"
#include "scenarios/format/region.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/voxel_index.h"

namespace cusp::scenarios {

/// The tissues of a leaf. Pre: is_of_voxels(leaf.kind).
[[nodiscard]] TissueSet tissues_of(const Region& leaf) noexcept;

class TissueShape {
 public:
  /// Tens of milliseconds.
  TissueShape(std::shared_ptr<const Specimen> specimen, const TissueSet& tissues);
  bool empty() const noexcept { return within_.empty(); }
  /// The sign is exact: a place belongs to the voxel whose centre is the nearest. The distance is exact. An empty shape lies
  /// kFarMm off everywhere.
  double distance_mm(Vec3 p) const noexcept;
  bool contains(Vec3 p) const noexcept { return has(voxel_of(p)); }
  /// Out of the shape, by differences over a voxel; of length 1.
  Vec3 out_of(Vec3 p) const noexcept;
  /// No distance outside its box is below this.
  double least_mm(Vec3 p) const noexcept;
  Vec3 low() const noexcept { return low_; }  // the box about it
  Vec3 high() const noexcept { return high_; }

  static constexpr double kFarMm = 100.0;

 private:
  bool has(IVec3 v) const noexcept { return tissues_[index_of(specimen_->tissue(v))] && was_solid(*specimen_, v); }
  IVec3 voxel_of(Vec3 p) const noexcept {
    const Grid& grid = specimen_->grid();
    return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm + 0.5));
  }
  /// Distance to the nearest of the 26 voxels about v on that side; kFarMm where there is none.
  enum class Side : std::uint8_t { within, without };
  double beside(Vec3 p, IVec3 v, Side side) const noexcept;

  std::shared_ptr<const Specimen> specimen_;
  TissueSet tissues_;
  VoxelIndex within_, without_;  // its outermost voxels, and the voxels about them
  Vec3 low_{0.0}, high_{0.0};
};

}  // namespace cusp::scenarios
