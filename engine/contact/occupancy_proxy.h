/// The paper's proxy: a voxel at a time to the free neighbour nearest to the device point, then along the ray.
/// A voxel is free when the superposed tool hits nothing; by the pivot alone in the variant kept for the record.
/// Source: paper, "Choosing the position of the proxy"; design, "Contact methods", 1. Thread: haptic; wait-free.
#pragma once

#include <vector>

#include "engine/step/scene.h"
#include "engine/tool/voxel_tool.h"
#include "engine/volume/occupancy.h"
#include "engine/volume/volume.h"

namespace cusp {

struct OccupancyContact {
  Vec3 pose_mm{0.0};
  bool touching = false;     // proxy and device point differ
  bool shank = false;        // the holder hits, one voxel further
  bool deferred = false;     // 64 moves were not enough
  IVec3 step{0};             // one voxel further towards the device point
  int hits = 0;              // cutting voxels that would hit there
  Vec3 mean_offset_mm{0.0};  // of eq. (3): mean of centre minus collision point
};

class OccupancyProxy {
 public:
  OccupancyProxy(const Scene& scene, const Volume& volume, bool pivot_only);

  OccupancyContact solve(const Volume& volume, const Scene& scene, std::size_t burr, Vec3 from, Vec3 device) noexcept;

  /// Cutting voxels that hit at the pose of the last solve, one voxel further; at most as many as the tool has.
  std::span<const IVec3> hit_voxels() const noexcept { return {hit_.data(), hit_count_}; }
  /// Every voxel that the tool's cutting part covers with its pivot on the way loses all its density. False: no room.
  bool remove_along(Volume& volume, std::size_t burr, Vec3 from, Vec3 to) noexcept;
  Occupancy& occupancy() noexcept { return occupancy_; }
  const Occupancy& occupancy() const noexcept { return occupancy_; }

 private:
  bool free(const VoxelTool& tool, IVec3 pivot) const noexcept;

  Occupancy occupancy_;
  std::vector<VoxelTool> tools_;  // one for each burr of the scene
  std::vector<IVec3> hit_;
  std::size_t hit_count_ = 0;
  IVec3 low_{0}, high_{0};        // voxels that hold tissue
  bool pivot_only_ = false;
};

}  // namespace cusp
