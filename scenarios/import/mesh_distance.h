/// Exact distances of a closed mesh on a grid, by OpenVDB (mesh_to_volume_openvdb.cpp).
#pragma once

#include <functional>
#include <span>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/triangle_mesh.h"

namespace cusp {

/// Signed distances of one row of voxels along x, in voxels, negative inside; beyond kDistanceReach they only bound.
using DistanceRow = std::function<void(int y, int z, std::span<const float> distance)>;

/// Wider than the band (2.75), so that no value within it is clipped.
inline constexpr float kDistanceReach = 4.0f;

/// Calls `row` for every row of `grid` that may hold a distance below kDistanceReach, z then y ascending; the others are
/// all outside. What a shell encloses is inside, whatever lies within it: cavities are asked for apart. The points are
/// in the grid's frame. Throws std::bad_alloc, as OpenVDB does.
void mesh_distance(const TriangleMesh& mesh, const Grid& grid, const DistanceRow& row);

}  // namespace cusp
