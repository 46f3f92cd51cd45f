/// The paper's occupancy map: external (empty), internal (no external neighbour) and boundary voxels over the 26
/// neighbours, kept current as voxels vanish. Bits by brick; outside the box all is external. Thread: the volume's owner.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/volume.h"

namespace cusp {

enum class VoxelClass : std::uint8_t { external, boundary, internal };

class Occupancy {
 public:
  explicit Occupancy(const Volume& volume);

  bool occupied(IVec3 v) const noexcept {
    if (v.x < 0 || v.y < 0 || v.z < 0 || v.x >= size_.x || v.y >= size_.y || v.z >= size_.z) return false;
    return bit(occupied_, v);
  }
  VoxelClass of(IVec3 v) const noexcept {
    return !occupied(v) ? VoxelClass::external : bit(boundary_, v) ? VoxelClass::boundary : VoxelClass::internal;
  }
  /// Haptic thread. The voxel has lost its last density: its internal neighbours become boundary.
  void vanish(IVec3 v) noexcept;

 private:
  bool bit(const std::vector<std::uint64_t>& words, IVec3 v) const noexcept {
    return words[word(v)] >> (brick_offset(v.x & 7, v.y & 7, v.z & 7) & 63) & 1;
  }
  std::size_t word(IVec3 v) const noexcept {
    const IVec3 b(v.x >> 3, v.y >> 3, v.z >> 3);
    return (static_cast<std::size_t>(b.x) +
            static_cast<std::size_t>(bricks_.x) *
                (static_cast<std::size_t>(b.y) + static_cast<std::size_t>(bricks_.y) * static_cast<std::size_t>(b.z))) *
               8 +
           static_cast<std::size_t>(v.z & 7);
  }
  static std::uint64_t mask(IVec3 v) noexcept {
    return std::uint64_t{1} << (brick_offset(v.x & 7, v.y & 7, v.z & 7) & 63);
  }

  IVec3 size_, bricks_;
  std::vector<std::uint64_t> occupied_;  // [brick][z]: 64 bits of an 8 x 8 slice, x fastest
  std::vector<std::uint64_t> boundary_;
};

}  // namespace cusp
