/// Voxels of one brick that have changed. Units: voxels of the specimen. Thread: any; no allocation.
#pragma once

#include <bit>
#include <cstdint>

#include "engine/volume/specimen.h"

namespace cusp::engine {

struct ChangedVoxels {
  IVec3 low{0}, high{0};        // box about them, inclusive
  std::uint64_t slice[8] = {};  // a bit each, as in brick_offset()

  /// `row`: the voxels of a row of the brick, x from bit 0. The box is not valid before close().
  void add_row(int y, int z, unsigned row) noexcept { slice[z] |= static_cast<std::uint64_t>(row) << (8 * y); }
  /// Sets the box of what was added; `corner`: the brick's first voxel. False if nothing was.
  bool close(IVec3 corner) noexcept {
    std::uint64_t all = 0;
    unsigned rows = 0, columns = 0, slices = 0;
    for (int z = 0; z < kBrickEdge; ++z) {
      all |= slice[z];
      slices |= static_cast<unsigned>(slice[z] != 0) << z;
    }
    for (int y = 0; y < kBrickEdge; ++y) {
      const auto row = static_cast<unsigned>(all >> (8 * y) & 0xff);
      columns |= row;
      rows |= static_cast<unsigned>(row != 0) << y;
    }
    if (all == 0) return false;
    low = corner + IVec3(std::countr_zero(columns), std::countr_zero(rows), std::countr_zero(slices));
    high = corner + IVec3(std::bit_width(columns), std::bit_width(rows), std::bit_width(slices)) - 1;
    return true;
  }
};

/// Calls visit(changed) for each brick of a box of voxels low..high, inclusive, all of which may have changed.
template <class Visit>
void for_bricks_of(IVec3 low, IVec3 high, Visit&& visit) noexcept {
  for (int bz = low.z >> 3; bz <= high.z >> 3; ++bz)
    for (int by = low.y >> 3; by <= high.y >> 3; ++by)
      for (int bx = low.x >> 3; bx <= high.x >> 3; ++bx) {
        const IVec3 corner = IVec3(bx, by, bz) * kBrickEdge;
        ChangedVoxels out;
        out.low = glm::max(low, corner);
        out.high = glm::min(high, corner + (kBrickEdge - 1));
        const IVec3 a = out.low - corner, b = out.high - corner;
        for (int z = a.z; z <= b.z; ++z)
          for (int y = a.y; y <= b.y; ++y) out.add_row(y, z, (2u << b.x) - (1u << a.x));
        visit(out);
      }
}

}  // namespace cusp::engine
