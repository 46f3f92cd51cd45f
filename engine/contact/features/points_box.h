/// Where in a brick its points lie. Thread: any.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/base/vec.h"

namespace cusp::engine {

/// Box about the points of a brick, in sixteenths of a voxel from a quarter voxel below its first voxel.
struct PointsBox {
  std::uint8_t from[3] = {255, 255, 255};
  std::uint8_t to[3] = {0, 0, 0};
  bool edges = false;
  bool empty() const noexcept { return from[0] > to[0]; }
  Vec3 low() const noexcept { return Vec3(from[0], from[1], from[2]) * 0.0625 - 0.25; }
  Vec3 high() const noexcept { return Vec3(to[0], to[1], to[2]) * 0.0625 - 0.25; }
  /// p: in voxels from the brick's first voxel.
  void add(Vec3f p) noexcept {
    for (int a = 0; a < 3; ++a) {
      const int below = static_cast<int>((p[a] + 0.25f) * 16.0f);
      from[a] = static_cast<std::uint8_t>(std::min<int>(from[a], below));
      to[a] = static_cast<std::uint8_t>(std::max<int>(to[a], below + 1));
    }
  }
};

}  // namespace cusp::engine
