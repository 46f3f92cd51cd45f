/// Removal for the banded reading: C = min(C, outside of the swept head). Frame: specimen, mm. Thread: haptic. Wait-free.
#pragma once

#include <array>

#include "engine/base/lanes.h"
#include "engine/contact/cavity/sweeps.h"
#include "engine/tool/bur.h"
#include "engine/volume/changed_voxels.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// solid_from_distance() of four places, in single precision.
inline LaneMask solid_from_distances(Lanes voxels) noexcept {
  const Lanes s = 0.5f + voxels * static_cast<float>(1.0 / (2.0 * kBandVoxels));
  return __builtin_convertvector(most_of(least_of(s, all_lanes(1.0f)), Lanes{}) * 65535.0f + 0.5f, LaneMask);
}

/// Result of one carving.
struct Carved {
  bool any = false;        // a value changed
  bool overflow = false;   // a brick had no room
  IVec3 low{0}, high{0};   // voxels that may have changed, inclusive; valid when any
  /// The same brick by brick, for the first kKept bricks; `low` and `high` alone cover the rest. More of them cost cells made
  /// anew, never another answer. 64: the front of a ball of 2.2 mm at voxels of 0.04 mm, (2.2 / 0.32 + 1)^2. 88 bytes each.
  static constexpr int kKept = 64;
  ChangedVoxels brick[kKept];
  int bricks = 0;          // that changed

  void add(const ChangedVoxels& changed) noexcept {
    low = any ? glm::min(low, changed.low) : changed.low;
    high = any ? glm::max(high, changed.high) : changed.high;
    any = true;
    if (bricks < kKept) brick[bricks] = changed;
    ++bricks;
  }
};

/// True if a pose that moved length_mm in dt_s swept its way. Faster or further, the bur flew and did not cut there.
/// 300 mm/s: no cutting tick was deferred up to it in 24 runs with balls of 1 to 6 mm, so no wear is lost.
inline bool swept_whole(double length_mm, double dt_s) noexcept {
  constexpr double kFastestMmS = 300.0, kLongestMm = 1.0;
  return length_mm <= kLongestMm && length_mm <= kFastestMmS * dt_s;
}

/// Calls brick(at) for the bricks with voxels low..high, inclusive.
template <class Brick>
void for_bricks_within(IVec3 low, IVec3 high, Brick&& brick) noexcept {
  for (int z = low.z >> 3; z <= high.z >> 3; ++z)
    for (int y = low.y >> 3; y <= high.y >> 3; ++y)
      for (int x = low.x >> 3; x <= high.x >> 3; ++x) brick(IVec3(x, y, z));
}

/// Calls visit(changed), a brick each, with every voxel that has changed; beyond kKept bricks with all in the box about them.
template <class Visit>
void for_changed(const Carved& carved, Visit&& visit) noexcept {
  if (carved.bricks > Carved::kKept) return for_bricks_of(carved.low, carved.high, visit);
  for (int i = 0; i < carved.bricks; ++i) visit(carved.brick[i]);
}

/// Unites the cut field with a ball of radius_mm swept from a to b (mm): C = min(C, solid(r - distance to ab)).
/// Calls touched() once for every brick that changed.
Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm) noexcept;

/// The same with the sweeps of a run, kMostAtOnce at most. A voxel that one of them lowers keeps its id.
inline constexpr std::int32_t kMostAtOnce = 16;
Carved carve_run(Volume& volume, const Sweeps& sweeps, SweepRun run) noexcept;

enum class SweepStart : std::uint8_t { uncut, carved };

/// A way in straight pieces, end to end, mm.
struct Polyline {
  /// Vertices. Under a tremor of 0.05 mm two bends leave 0.6 of the cells to be made anew that sweeps without any do; a third
  /// leaves no fewer.
  static constexpr int kMost = 4;
  std::array<Vec3, kMost> vertex{};
  int count = 0;

  const Vec3& first() const noexcept { return vertex[0]; }
  const Vec3& last() const noexcept { return vertex[static_cast<std::size_t>(count - 1)]; }
  /// Pre: fewer than kMost.
  void add(Vec3 at) noexcept { vertex[static_cast<std::size_t>(count++)] = at; }
};

/// The same for any head, its pivot led along a way of two vertices or more, axis unit and fixed. A ball's way has two, and
/// gives the same bits as above. Other heads are exact to 4e-4 voxel (tests/engine/tool/carve_test.cpp). If
/// the rim's angle is below 90 degrees, the field inside the head is deeper than the head: wall and floor beside the rim then keep
/// their distance (flat_head.h).
/// carved: the last carving ended where the way begins, with this bur and axis. The volume is the same; the head's rear is skipped.
Carved carve_sweep(Volume& volume, const Polyline& way, const Bur& bur, Vec3 axis, SweepStart start = SweepStart::uncut) noexcept;
inline Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, const Bur& bur, Vec3 axis, SweepStart start = SweepStart::uncut) noexcept {
  return carve_sweep(volume, Polyline{{a, b}, 2}, bur, axis, start);
}

}  // namespace cusp::engine
