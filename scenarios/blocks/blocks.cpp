#include "scenarios/blocks/blocks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "scenarios/import/limits.h"
#include "scenarios/shapes/distance.h"

namespace cusp::scenarios {
namespace {

/// A box whose top face lies at z = 0 in the middle of x and y; tissue_at(depth below the top face, mm).
template <class TissueAt>
VoxelVolume block(Vec3 size_mm, double voxel_mm, TissueAt tissue_at) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  // The hair below one keeps 20 / 0.1 from becoming 201 voxels by rounding.
  for (int i = 0; i < 3; ++i)
    grid.size[i] = static_cast<int>(std::ceil(size_mm[i] / voxel_mm - 1e-9)) + 2 * kPadVoxels;
  grid.origin_mm.x = -0.5 * voxel_mm * (grid.size.x - 1);
  grid.origin_mm.y = -0.5 * voxel_mm * (grid.size.y - 1);
  grid.origin_mm.z = -voxel_mm * (grid.size.z - kPadVoxels - 0.5);

  const Vec3 middle(0.0, 0.0, -0.5 * size_mm.z);
  const Vec3 half = 0.5 * size_mm;
  VoxelVolume out(grid);
  std::size_t i = 0;
  for (int z = 0; z < grid.size.z; ++z) {
    // Outside the box the nearest tissue is that of the nearest point of the box.
    const double depth_mm = std::clamp(-grid.centre_mm({0, 0, z}).z, 0.0, size_mm.z);
    const Tissue tissue = tissue_at(depth_mm);
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x, ++i) {
        const double d = box_distance(grid.centre_mm({x, y, z}), middle, half) / voxel_mm;
        out.s[i] = solid_from_distance(d);
        if (out.s[i] > 0) out.tissue[i] = tissue;
      }
  }
  return out;
}

}  // namespace

VoxelVolume paper_block() {
  constexpr std::array layers = {Tissue::dentine, Tissue::bone, Tissue::enamel};  // from above
  return block(Vec3(kPaperBlockMm), kPaperBlockMm / kPaperBlockVoxels, [&](double depth_mm) {
    return layers[std::min<std::size_t>(static_cast<std::size_t>(depth_mm / kPaperLayerMm), layers.size() - 1)];
  });
}

VoxelVolume dexterity_block(double voxel_mm) {
  assert(voxel_mm >= kDexterityLeastVoxelMm && voxel_mm <= kDexterityMostVoxelMm);
  return block(kDexterityBlockMm, voxel_mm, [](double) { return Tissue::plastic; });
}

VoxelVolume layered_block(double voxel_mm) {
  assert(voxel_mm >= kDexterityLeastVoxelMm && voxel_mm <= kDexterityMostVoxelMm);
  return block(kDexterityBlockMm, voxel_mm,
               [](double depth_mm) { return depth_mm < kHardLayerMm ? Tissue::composite : Tissue::plastic; });
}

}  // namespace cusp::scenarios
