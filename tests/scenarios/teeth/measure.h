/// Measures teeth on their voxels alone, by other ways than the generator's: crossings of s = 1/2, floods, columns.
#pragma once

#include <functional>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/teeth/landmarks.h"

namespace cusp {

/// Furthest crossing of the surface along an axis (0 x, 1 y, 2 z; sign ±1) over all grid lines whose z is in [low, high].
double extent(const VoxelVolume& volume, int axis, int sign, double z_low, double z_high);

/// Lengths as teeth.json defines them; CEJ heights are those of the mesial and distal side.
ToothDims measured_dims(const VoxelVolume& volume, double cej_mesial, double cej_distal, bool mirrored);

/// Pieces of the voxels that `wanted` accepts, joined over faces.
int pieces(const VoxelVolume& volume, const std::function<bool(std::size_t)>& wanted);

/// Peaks of the surface seen from above that stand at least `prominence_mm` over the way to a higher one.
int peaks(const VoxelVolume& volume, double prominence_mm);

/// Distance in mm from the surface at a place, by trilinear s; only within the band.
double distance_mm(const VoxelVolume& volume, Vec3 at_mm);

/// Tissue of the voxel at a place; empty when s < 1/2 there.
Tissue tissue_at(const VoxelVolume& volume, Vec3 at_mm);

/// Least distance from a pulp voxel above `z_from` to one that is neither pulp nor dentine; `most_mm` when none is nearer.
double pulp_cover_mm(const VoxelVolume& volume, double z_from, double most_mm);

}  // namespace cusp
