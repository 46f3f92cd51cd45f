/// Removal for the surface reading: what a bur's cutting head sweeps is gone. Thread: haptic; wait-free.
#pragma once

#include "engine/tool/bur.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// What one carving came to.
struct Carved {
  bool any = false;        // a value changed
  bool overflow = false;   // a brick had no room
  IVec3 low{0}, high{0};   // voxels that may have changed, inclusive; valid when any
  /// The same brick by brick, for the first kBoxes of them; the rest are told by `low` and `high` alone.
  struct Box {
    IVec3 low{0}, high{0};
  };
  static constexpr int kBoxes = 64;
  Box box[kBoxes];
  int bricks = 0;          // that changed
  int next = -1;           // where a part of the way's bricks ended: CarvePart::first of the next part; -1: at the end
};

/// A pose that went this far in a tick swept its way; faster or further, the bur flew and did not cut there. Nor does a tick
/// cut whose search for contact was cut off (deferred): up to this speed no cutting one was, over 24 runs of 18,000 and 10,000
/// ticks with balls of 1 to 6 mm, so that no wear is owed for any.
inline bool swept_whole(double length_mm, double dt_s) noexcept {
  constexpr double kFastestMmS = 300.0, kLongestMm = 1.0;
  return length_mm <= kLongestMm && length_mm <= kFastestMmS * dt_s;
}

/// A carving may be done in parts, brick by brick in a fixed order, and comes to the same.
struct CarvePart {
  int first = 0;
  int most = 1 << 30;      // bricks to change
};

/// Calls tell(low, high) for boxes that together hold every voxel that may have changed.
template <class Tell>
void for_changed(const Carved& carved, Tell&& tell) noexcept {
  if (carved.bricks > Carved::kBoxes) {
    tell(carved.low, carved.high);
    return;
  }
  for (int i = 0; i < carved.bricks; ++i) tell(carved.box[i].low, carved.box[i].high);
}

/// Unites the cut field with a ball of radius_mm swept from a to b (mm): C = min(C, solid(r - distance to ab)).
/// Calls touched() once for every brick that changed.
Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm, CarvePart part = {}) noexcept;

/// The same for any head; pivot from a to b (mm), axis unit and fixed. A ball goes the ball's own way, bit for bit; any
/// other head is exact to 4e-4 voxel (measured 2.1e-4, a quantum being 8e-5); but within a head whose rim is less than a
/// right angle it is deeper than the head itself, so that wall and floor which the rim leaves have their distance, to 0.03
/// voxel at 1.5 of them (flat_head.h).
/// `start_carved`: the last carving ended at a, with this bur and this axis; then what the head leaves behind is not
/// looked at again. The volume comes out the same, sooner.
Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, const Bur& bur, Vec3 axis, bool start_carved = false,
                   CarvePart part = {}) noexcept;

}  // namespace cusp::engine
