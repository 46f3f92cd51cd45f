/// Specimens and cuts of exactly known shape, for tests: sampled from signed distances, no step involved.
#pragma once

#include <memory>

#include "engine/volume/volume.h"

namespace cusp::engine::carved {

/// A specimen of one distance (mm, negative inside), all of one tissue or by `tissue_at`.
template <class Distance, class TissueAt>
std::shared_ptr<const Specimen> specimen(const Grid& grid, Reading reading, Distance&& distance, TissueAt&& tissue_at) {
  VoxelVolume dense(grid);
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        const std::size_t i = grid.index(v);
        dense.s[i] = solid_from_distance(distance(grid.centre_mm(v)) / grid.voxel_mm);
        if (dense.s[i] > 0) dense.tissue[i] = tissue_at(grid.centre_mm(v));
      }
  return Specimen::build(dense, reading);
}

/// Removes the inside of `tool` (mm, negative inside) as an ideal bur would. Bricks out of its reach stay uncut.
template <class Distance>
void carve(Volume& volume, Distance&& tool) {
  const Specimen& s = volume.specimen();
  const Grid& grid = s.grid();
  const IVec3 n = s.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const IVec3 corner = s.brick_at(b) * kBrickEdge;
    std::uint16_t* cut = nullptr;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      const double d = tool(grid.centre_mm(v)) / grid.voxel_mm;
      std::uint16_t value = solid_from_distance(-d);
      if (s.reading() == Reading::filled) {
        if (d > 0.0) continue;
        value = 0;
      }
      if (value == kSolid) continue;
      if (cut == nullptr) cut = volume.cut_for_writing(b);
      if (cut == nullptr) break;  // out of the tissue's reach
      if (value < cut[o]) cut[o] = value;
    }
    if (cut != nullptr) volume.touched(b);
  }
}

}  // namespace cusp::engine::carved
