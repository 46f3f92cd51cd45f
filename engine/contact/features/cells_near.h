/// Cells of a brick whose points or edges may lie in a ball or in two cylinders, a bit each as in BrickVoxelSet: what a
/// look needs of a brick, which mostly is a small part of it. Any thread.
#pragma once

#include <cstdint>

#include "engine/contact/features/near_points.h"

namespace cusp::engine {

struct CellsNear {
  std::uint64_t slice[8];

  static constexpr unsigned kAllSlices = 0xff;
  static CellsNear all() noexcept;
  /// Voxels from the brick's first voxel. slices: the others stay empty.
  static CellsNear ball(Vec3f centre, float reach, unsigned slices = kAllSlices) noexcept;
  /// Slice by slice where they stand rather upright, else all cells.
  static CellsNear cylinders(const TwoCylinders& shape, unsigned slices = kAllSlices) noexcept;
  CellsNear operator|(const CellsNear& other) const noexcept;
  CellsNear without(const std::uint64_t (&others)[8]) const noexcept;
};

}  // namespace cusp::engine
