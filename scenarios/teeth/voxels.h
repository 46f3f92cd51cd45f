/// From the fields of a tooth to voxels: the outside sampled only near the surface, turned into true distance, and each
/// voxel's tissue decided only where a boundary is near.
#pragma once

#include "scenarios/teeth/shape.h"
#include "scenarios/teeth/tooth.h"

namespace cusp {

/// Fails only with `cancelled`. Progress from `from` to 1.
Result<VoxelVolume, ToothFailure> voxels_of(const ToothShape& shape, double voxel_mm, ToothCancel cancel,
                                            const ToothProgress& progress, double from);

/// The same volume with x turned round: voxel for voxel, bit for bit.
VoxelVolume mirrored(const VoxelVolume& volume);

}  // namespace cusp
