/// Cells whose fields read changed voxels of a brick. A cell's field reads the voxels at its corners, and along each axis the
/// four beyond two of its faces (volume/cell_field.h). Thread: any; no allocation.
#pragma once

#include <cstdint>

#include "engine/volume/changed_voxels.h"

namespace cusp::engine {

class FieldReaders {
 public:
  explicit FieldReaders(const ChangedVoxels& voxels) noexcept {
    for (int z = 0; z < kBrickEdge; ++z) {
      if (voxels.slice[z] == 0) continue;
      // Bit x + 2 of row y + 3; `wide`: as far as a field reads along x.
      std::uint16_t core[kBrickEdge + 6] = {}, wide[kBrickEdge + 6] = {};
      for (int y = 0; y < kBrickEdge; ++y) {
        const auto row = static_cast<unsigned>(voxels.slice[z] >> (8 * y) & 0xff) << 2;
        core[y + 3] = static_cast<std::uint16_t>(row | row >> 1);
        wide[y + 3] = static_cast<std::uint16_t>(core[y + 3] | row >> 2 | row << 1);
      }
      for (int y = 0; y < kCells; ++y) {
        const int near = core[y + 1] | core[y + 2];
        const int beside = wide[y + 1] | wide[y + 2] | core[y] | core[y + 3];
        add(y, z, near);
        add(y, z + 1, beside);
        add(y, z + 2, beside);
        add(y, z + 3, near);
      }
    }
  }
  /// Those in slice z of the brick whose first voxel is `shift` off, a bit each as in brick_offset(): 0 or a brick's edge either
  /// way along each axis.
  std::uint64_t in(IVec3 shift, int z) const noexcept {
    const int from = z + shift.z + 2;
    if (from < 0 || from >= kCells) return 0;
    std::uint64_t out = 0;
    for (int y = 0; y < kBrickEdge; ++y) {
      const int row = y + shift.y + 2;
      if (row < 0 || row >= kCells) continue;
      const unsigned cells = rows_[from][row];
      out |= static_cast<std::uint64_t>((shift.x < 0 ? cells << 6 : shift.x > 0 ? cells >> 10 : cells >> 2) & 0xff) << (8 * y);
    }
    return out;
  }

 private:
  static constexpr int kCells = kBrickEdge + 3;  // cells -2 to 8 along an axis
  void add(int y, int z, int cells) noexcept { rows_[z][y] = static_cast<std::uint16_t>(rows_[z][y] | cells); }
  std::uint16_t rows_[kCells][kCells] = {};
};

}  // namespace cusp::engine
