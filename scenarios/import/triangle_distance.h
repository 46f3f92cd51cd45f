/// Distances to triangles on a grid, one triangle after the other.
#pragma once

#include <array>
#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Distances are exact up to here, in voxels; the band ends at 2.75.
inline constexpr int kDistanceReach = 3;

/// Lowers `squared` [z][y][x], squared distances in voxels, about one triangle whose corners are in voxels from the grid's
/// first. Begins with kDistanceReach squared everywhere.
void stamp_triangle(const std::array<Vec3, 3>& corners, const Grid& grid, std::vector<float>& squared);

}  // namespace cusp::scenarios
