/// The surface that the burr has left, as points and edges: one of each at most for a cell. Computed when contact asks
/// for it, kept until a voxel that it was read from changes. What it answers depends on the volume alone, so that an
/// incremental answer equals a full rebuild bit for bit. Fixed memory. Thread: haptic.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/volume.h"

namespace cusp {

/// Places in voxels from the cell's lower corner.
struct CutFeature {
  Vec3f point{0.0f}, normal{0.0f};    // of the cut's surface, where the base is solid; normal into the void
  Vec3f edge{0.0f}, tangent{0.0f};    // where both surfaces meet in this cell
  Vec3f other_normal{0.0f};           // of the base near the point
  float other_d_mm = 0.0f;            // distance of the point to the base's surface, negative inside
  Tissue tissue = Tissue::empty;      // just under the point
  bool has_point = false, has_edge = false, near_other = false;
};

class CutSurface {
 public:
  explicit CutSurface(const Volume& volume);

  /// Voxels low..high (inclusive) of the cut field have changed.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept;

  /// The feature of a cell in a brick that has a cut; nullptr where its cell is not crossed.
  /// Pre: volume.cut_slot(brick) >= 0.
  const CutFeature* at(const Volume& volume, int brick, int offset) noexcept;

  /// Everything is to be read anew (after the volume was loaded).
  void forget() noexcept;

 private:
  static constexpr std::uint32_t kStale = 0x80000000u;
  static constexpr std::uint32_t kNoEntry = 0x7FFFFFFFu;
  static CutFeature compute(const Volume& volume, IVec3 cell) noexcept;

  std::vector<std::uint32_t> entry_;  // [slot][512]
  std::vector<CutFeature> pool_;
  std::uint32_t used_ = 0;
  CutFeature scratch_[2];
  int scratch_at_ = 0;
};

}  // namespace cusp
