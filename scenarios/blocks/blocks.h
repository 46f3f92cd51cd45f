/// Blocks to practise on, as exact distances of a box (edges and corners included) in the band of s.
/// Frame: specimen; the top face lies at z = 0, the z axis goes through the middle of the block. Millimetres.
#pragma once

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Edge of the paper's cube, voxels along it (so a voxel is 10/128 = 0.078125 mm) and height of one of its materials.
inline constexpr double kPaperBlockMm = 10.0;
inline constexpr int kPaperBlockVoxels = 128;
inline constexpr double kPaperLayerMm = kPaperBlockMm / 3.0;

/// The paper's block (section 4, figure 12): 128^3 occupied voxels, 1.2, 0.8 and 0.5 mm/s in the order in which the paper
/// names them and drills them, so from above dentine, bone, enamel. Padded to 136^3.
[[nodiscard]] VoxelVolume paper_block();

/// Size of the dexterity block (facts/dental.md 2.1: 20 x 20 x 10 mm).
inline constexpr Vec3 kDexterityBlockMm{20.0, 20.0, 10.0};

/// Plastic, padded by four voxels. Pre: 0.04 <= voxel_mm <= 1 (at 0.04 it has 65 million voxels).
[[nodiscard]] VoxelVolume dexterity_block(double voxel_mm = 0.1);

/// The same block of two materials: a hard layer of composite above plastic, so that the bur breaks through into
/// what gives way faster, as from enamel into dentine. Pre: as above.
inline constexpr double kHardLayerMm = 1.0;
[[nodiscard]] VoxelVolume layered_block(double voxel_mm = 0.1);
inline constexpr double kDexterityLeastVoxelMm = 0.04;
inline constexpr double kDexterityMostVoxelMm = 1.0;

}  // namespace cusp::scenarios
