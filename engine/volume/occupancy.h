/// The paper's occupancy map: external (empty), internal (no external neighbour) and boundary voxels over the 26
/// neighbours, kept current as voxels vanish. Outside the grid all is external. Bits by brick, 128 bytes each. Wholly
/// empty and wholly occupied bricks share theirs, so memory grows with the surface. Thread: the volume's owner.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/volume.h"

namespace cusp::engine {

enum class VoxelClass : std::uint8_t { external, boundary, internal };

class Occupancy {
 public:
  /// Reserves bits for as many bricks as the volume has cut room for.
  explicit Occupancy(const Volume& volume);

  bool occupied(IVec3 v) const noexcept {
    if (v.x < 0 || v.y < 0 || v.z < 0 || v.x >= size_.x || v.y >= size_.y || v.z >= size_.z) return false;
    return (occupied_[word(place_[brick(v)], v)] & mask(v)) != 0;
  }
  /// Occupied voxels of the brick's row of eight that contains v: bit i is voxel (v.x & ~7) + i. 0 outside the grid.
  unsigned row(IVec3 v) const noexcept {
    if (v.x < 0 || v.y < 0 || v.z < 0 || v.x >= size_.x || v.y >= size_.y || v.z >= size_.z) return 0;
    return static_cast<unsigned>(occupied_[word(place_[brick(v)], v)] >> ((v.y & 7) << 3)) & 0xffu;
  }
  VoxelClass of(IVec3 v) const noexcept;
  /// Haptic thread. Empties a voxel; its internal neighbours become boundary.
  /// Pre: the volume has a cut for the voxel's brick: memory is reserved for no others.
  void vanish(IVec3 v) noexcept;

  std::size_t bytes() const noexcept {
    return place_.size() * sizeof(std::int32_t) + (occupied_.size() + boundary_.size()) * sizeof(std::uint64_t);
  }

 private:
  static constexpr std::int32_t kEmpty = 0, kWhole = 1;  // places of the bits that uniform bricks share

  std::size_t brick(IVec3 v) const noexcept {
    return static_cast<std::size_t>(v.x >> 3) +
           static_cast<std::size_t>(bricks_.x) *
               (static_cast<std::size_t>(v.y >> 3) +
                static_cast<std::size_t>(bricks_.y) * static_cast<std::size_t>(v.z >> 3));
  }
  static std::size_t word(std::int32_t place, IVec3 v) noexcept {
    return static_cast<std::size_t>(place) * 8 + static_cast<std::size_t>(v.z & 7);
  }
  static std::uint64_t mask(IVec3 v) noexcept { return std::uint64_t{1} << ((v.x & 7) | (v.y & 7) << 3); }

  /// Slice z (-1 to 8) of a brick's occupied voxels that have occupied neighbours along x and y too.
  std::uint64_t inner_slice(IVec3 brick, int z) const noexcept;
  /// Recomputes the boundary of a brick from it and its neighbours.
  void classify(IVec3 brick, std::int32_t place) noexcept;

  IVec3 size_, bricks_;
  std::vector<std::int32_t> place_;      // [brick]: place of its bits
  std::vector<std::uint64_t> occupied_;  // [place][z]: 64 bits of an 8 x 8 slice, x fastest
  std::vector<std::uint64_t> boundary_;  // [place][z]; not kept for a whole brick: of() reads the neighbours
  std::int32_t used_ = 2;                // places taken
};

}  // namespace cusp::engine
