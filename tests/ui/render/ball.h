// A ball of enamel round a dentine core, and a cut, for the tests of the picture.
#pragma once

#include <cmath>

#include "engine/volume/volume.h"
#include "tests/modules.h"

namespace cusp::test {

inline constexpr double kVoxel = 0.1;

inline VoxelVolume ball(double mm, double core_mm = 0.0) {
  const int n = static_cast<int>(std::ceil(2 * mm / kVoxel)) + 10;
  VoxelVolume out(Grid{IVec3(n), kVoxel, Vec3(-kVoxel * (n - 1) / 2.0)});
  IVec3 v;
  for (v.z = 0; v.z < n; ++v.z)
    for (v.y = 0; v.y < n; ++v.y)
      for (v.x = 0; v.x < n; ++v.x) {
        const double from_middle = glm::length(out.grid.centre_mm(v));
        const std::size_t i = out.grid.index(v);
        out.s[i] = solid_from_distance((from_middle - mm) / kVoxel);
        if (out.s[i] > 0) out.tissue[i] = from_middle < core_mm ? Tissue::dentine : Tissue::enamel;
      }
  return out;
}

/// Carves a ball out of the cut field; the bricks that changed.
inline std::vector<std::int32_t> carve(Volume& volume, Vec3 centre, double mm) {
  std::vector<std::int32_t> touched;
  const IVec3 n = volume.specimen().brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const IVec3 corner = volume.specimen().brick_at(b) * kBrickEdge;
    std::uint16_t* cut = nullptr;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      const std::uint16_t s = solid_from_distance((mm - glm::length(volume.grid().centre_mm(v) - centre)) / kVoxel);
      if (s == kSolid || s >= volume.cut(v)) continue;
      if (cut == nullptr) cut = volume.cut_for_writing(b);
      if (cut == nullptr) break;
      cut[o] = s;
    }
    if (cut == nullptr) continue;
    volume.touched(b);
    touched.push_back(b);
  }
  return touched;
}

}  // namespace cusp::test
