/// The scenario's volume as the engine holds it: bricks of 8x8x8, immutable after loading, shared by the loop, its
/// mirror and the graders. Outside the box lies endless empty space. A brick that is all empty, or all of one sound
/// tissue, costs one table entry. Any thread (read only).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/volume/base_surface.h"
#include "engine/volume/voxel_volume.h"

namespace cusp {

/// How s is read (design, "The volume").
enum class Reading : std::uint8_t {
  filled,  // the paper's: s is 0 or 1 at the start, a voxel is there while s > 0, wear lowers s
  banded,  // s is a clamped distance, a voxel is there while s >= 1/2, removal carves
};

inline constexpr int kBrickEdge = 8;
inline constexpr int kBrickVoxels = 512;

/// Position of a voxel within its brick: x fastest. Pre: 0 <= local < 8.
inline int brick_offset(int x, int y, int z) noexcept { return x | y << 3 | z << 6; }

class Specimen {
 public:
  /// Takes the dense form; s >= 1/2 becomes 1 and the rest 0 for a filled reading, so both readings begin with the
  /// same occupied voxels. Not for the haptic thread.
  static std::shared_ptr<const Specimen> build(const VoxelVolume& dense, Reading reading);

  const Grid& grid() const noexcept { return grid_; }
  Reading reading() const noexcept { return reading_; }
  IVec3 brick_count() const noexcept { return bricks_; }
  /// Index of a brick, x fastest; -1 outside.
  int brick_index(IVec3 brick) const noexcept {
    if (brick.x < 0 || brick.y < 0 || brick.z < 0 || brick.x >= bricks_.x || brick.y >= bricks_.y ||
        brick.z >= bricks_.z)
      return -1;
    return brick.x + bricks_.x * (brick.y + bricks_.y * brick.z);
  }
  IVec3 brick_at(int index) const noexcept {
    return {index % bricks_.x, index / bricks_.x % bricks_.y, index / (bricks_.x * bricks_.y)};
  }

  std::uint16_t s(IVec3 v) const noexcept {
    const int b = brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    return b < 0 ? std::uint16_t{0} : s_in(b, brick_offset(v.x & 7, v.y & 7, v.z & 7));
  }
  Tissue tissue(IVec3 v) const noexcept {
    const int b = brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    return b < 0 ? Tissue::empty : tissue_in(b, brick_offset(v.x & 7, v.y & 7, v.z & 7));
  }
  std::uint16_t s_in(int brick, int offset) const noexcept {
    const Entry& e = table_[static_cast<std::size_t>(brick)];
    return e.slot < 0 ? e.uniform_s : s_[static_cast<std::size_t>(e.slot) * kBrickVoxels + static_cast<std::size_t>(offset)];
  }
  Tissue tissue_in(int brick, int offset) const noexcept {
    const Entry& e = table_[static_cast<std::size_t>(brick)];
    return e.slot < 0 ? e.uniform_tissue
                      : tissue_[static_cast<std::size_t>(e.slot) * kBrickVoxels + static_cast<std::size_t>(offset)];
  }
  /// True when all 512 voxels are alike: wholly empty or wholly solid and of one tissue.
  bool uniform(int brick) const noexcept { return table_[static_cast<std::size_t>(brick)].slot < 0; }
  /// The 512 s values of a brick that is not uniform; nullptr for one that is.
  const std::uint16_t* s_of(int brick) const noexcept {
    const Entry& e = table_[static_cast<std::size_t>(brick)];
    return e.slot < 0 ? nullptr : &s_[static_cast<std::size_t>(e.slot) * kBrickVoxels];
  }

  /// Surface points of a banded specimen; none for a filled one.
  const BaseSurface& surface() const noexcept { return surface_; }

  /// Bytes held, and a hash of grid, reading, tissues and s (the same on every machine).
  std::size_t bytes() const noexcept;
  std::uint64_t hash() const noexcept { return hash_; }
  const std::map<std::uint8_t, std::string>& names() const noexcept { return names_; }

  /// Back to the dense form (for files and metrics).
  VoxelVolume dense() const;

 private:
  struct Entry {
    std::int32_t slot = -1;
    std::uint16_t uniform_s = 0;
    Tissue uniform_tissue = Tissue::empty;
  };
  Grid grid_;
  Reading reading_ = Reading::banded;
  IVec3 bricks_{0};
  std::vector<Entry> table_;
  std::vector<std::uint16_t> s_;
  std::vector<Tissue> tissue_;
  BaseSurface surface_;
  std::map<std::uint8_t, std::string> names_;
  std::uint64_t hash_ = 0;
};

}  // namespace cusp
