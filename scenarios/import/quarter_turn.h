/// A specimen turned by right angles: voxels change their places and nothing else.
#pragma once

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Right-handed quarter turns about the specimen frame's x, y or z (0, 1, 2) through its origin, as UpAxis turns a file:
/// one about x is UpAxis::y. Any number, negative too. Any thread; takes the memory of a second volume.
VoxelVolume quarter_turned(const VoxelVolume& volume, int axis, int quarters);

}  // namespace cusp::scenarios
