/// The voxelised bur superposed on the occupancy map: what the methods on the filled reading stand on.
/// A pivot's voxel is free when the tool about it hits nothing, or by the pivot alone where the scene asks for that.
/// Source: paper, "Collision detection"; design, "Contact methods", 1. Thread: haptic; wait-free; memory at
/// construction.
#pragma once

#include <span>
#include <vector>

#include "engine/contact/methods/tissue_box.h"
#include "engine/scene/scene.h"
#include "engine/tool/voxel_tool.h"
#include "engine/volume/occupancy.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// What a method on voxels found.
struct VoxelContact {
  Vec3 pose_mm{0.0};
  bool touching = false;     // proxy and device point differ
  bool shank = false;        // the holder hits, one voxel further
  bool deferred = false;     // the moves of one tick were not enough
  IVec3 step{0};             // one voxel further towards the device point
  Vec3 mean_offset_mm{0.0};  // of eq. (3): mean of centre minus collision point, over the cutting voxels that hit there
};

/// Voxels x0 to x1 of one row, from a pivot.
struct VoxelRow {
  int z, y, x0, x1;
};

/// Calls visit(x, bits) for every eight voxels that a row about a pivot touches: bit i of those of the row that are occupied is
/// the voxel x + i.
template <class Visit>
void for_occupied(const Occupancy& occupancy, const VoxelRow& row, IVec3 pivot, Visit&& visit) noexcept {
  const int x1 = pivot.x + row.x1;
  for (int x = pivot.x + row.x0; x <= x1; x = (x | 7) + 1) {
    unsigned bits = 0xffu << (x & 7);
    if ((x | 7) > x1) bits &= 0xffu >> (7 - (x1 & 7));
    visit(x & ~7, bits & occupancy.row({x, pivot.y + row.y, pivot.z + row.z}));
  }
}

class ToolOverlap {
 public:
  ToolOverlap(const Scene& scene, const Volume& volume);

  /// The voxel that holds a place.
  static IVec3 voxel_at(const Grid& grid, Vec3 p) noexcept;

  bool free(std::size_t bur, IVec3 pivot) const noexcept;
  /// First stage: nowhere between the two poses can the bur's box meet the tissue's box.
  bool apart(const Grid& grid, const Scene& scene, std::size_t bur, Vec3 from, Vec3 to) const noexcept;
  /// What would hit one voxel further from contact.pose_mm towards the device point: step, offset, shank and hit_voxels().
  void hit_further(const Grid& grid, std::size_t bur, Vec3 device, VoxelContact& contact) noexcept;
  /// Cutting voxels of the last hit_further(); at most as many as the tool has. Emptied by forget_hits().
  std::span<const IVec3> hit_voxels() const noexcept { return {hit_.data(), hit_count_}; }
  void forget_hits() noexcept { hit_count_ = 0; }

  Occupancy& occupancy() noexcept { return occupancy_; }
  const Occupancy& occupancy() const noexcept { return occupancy_; }

 private:
  struct Tool {
    VoxelTool voxels;
    std::vector<VoxelRow> cutting, holder;  // the same voxels by rows, in order of z, y, x
  };
  static std::vector<VoxelRow> rows_of(const std::vector<IVec3>& voxels);
  bool any(const std::vector<VoxelRow>& rows, IVec3 pivot) const noexcept;

  Occupancy occupancy_;
  std::vector<Tool> tools_;  // one for each bur of the scene
  std::vector<IVec3> hit_;
  std::size_t hit_count_ = 0;
  TissueVoxels tissue_;
  bool pivot_only_ = false;  // Method::occupancy_pivot
};

}  // namespace cusp::engine
