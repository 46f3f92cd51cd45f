/// The outside of a voxel tooth: heights from above, and its surface as places. Inside of this folder.
/// Frame: specimen. Millimetres. Any thread.
#pragma once

#include <optional>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

using Vec2 = glm::dvec2;

class ToothSurface {
 public:
  /// Keeps a reference. Gums, bone and ligament are no tooth; where enamel or dentine is there, nor are the volume's own tissues.
  explicit ToothSurface(const VoxelVolume& volume);

  const Grid& grid() const noexcept { return volume_.grid; }
  bool empty() const noexcept { return voxels_ == 0; }
  bool is_tooth(IVec3 v) const noexcept;
  Tissue tissue(IVec3 v) const noexcept { return volume_.tissue[grid().index(v)]; }
  double top_mm() const noexcept { return top_mm_; }  // of its highest place
  Vec3 centroid_mm() const noexcept { return centroid_mm_; }
  /// Direction of its greatest extent, upwards; nullopt where no extent is the greatest.
  std::optional<Vec3> long_axis() const noexcept { return long_axis_; }
  /// Height of the surface seen from above, between columns linearly; nullopt beside the tooth.
  std::optional<double> height_mm(Vec2 at) const noexcept;
  /// Middles of the columns whose surface lies above that height.
  std::vector<Vec2> columns_above(double z_mm) const;
  /// Places of the surface at or above a height, one beside each voxel of it, known to a hundredth of a voxel where the band is.
  std::vector<Vec3> surface_above(double z_mm) const;

 private:
  double distance_voxels(IVec3 v) const noexcept;
  void weigh();

  const VoxelVolume& volume_;
  bool own_tissues_ = false;  // codes from 16 on count
  std::size_t voxels_ = 0;
  double top_mm_ = 0;
  Vec3 centroid_mm_{0.0};
  std::optional<Vec3> long_axis_;
  std::vector<double> heights_;  // [y][x]; NaN where no tooth is
};

}  // namespace cusp::scenarios
