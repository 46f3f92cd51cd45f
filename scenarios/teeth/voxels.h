/// From the fields of a tooth to voxels: the outside sampled only near the surface, turned into true distance, and each
/// voxel's tissue decided only where a boundary is near.
#pragma once

#include "scenarios/teeth/body.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {

/// Fails only with `cancelled`. Progress from `from` to 1.
Result<VoxelVolume, ToothFailure> voxels_of(const Body& body, double voxel_mm, ToothCancel cancel,
                                            const ToothProgress& progress, double from);

/// Bodies that stand side by side as one volume: each voxel is of the one that reaches furthest into it. All on one
/// lattice of voxels (whole voxels from the origin), as voxels_of makes them. Pre: not empty, one voxel size.
VoxelVolume united(const std::vector<VoxelVolume>& parts);

/// Teeth within what surrounds them: where a tooth is, it stays; elsewhere the surroundings are. One lattice, as above.
VoxelVolume embedded(VoxelVolume teeth, const VoxelVolume& around);

/// The same volume with x turned round: voxel for voxel, bit for bit.
VoxelVolume mirrored(const VoxelVolume& volume);

}  // namespace cusp::scenarios
