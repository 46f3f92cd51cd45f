/// Exact signed distances of a closed shell on a grid.
#pragma once

#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/import/image.h"
#include "scenarios/import/triangle_distance.h"
#include "scenarios/import/triangle_mesh.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Distance of each voxel in voxels, negative inside, [z][y][x]; clamped to +-kDistanceReach. The points are in the
/// grid's frame; what lies outside the grid counts too. `progress` is called a hundred times at most. Throws std::bad_alloc.
std::vector<float> mesh_distance(const TriangleMesh& shell, const Grid& grid, const ImportProgress& progress = {});

/// For the former: whether each voxel is inside, by OpenVDB, which sees it right also where shells touch or cross
/// themselves (mesh_to_volume_openvdb.cpp). Its own distances are exact to 1.5 voxels only: further out they were found
/// 0.9 of a voxel too long.
std::vector<bool> mesh_inside(const TriangleMesh& shell, const Grid& grid);

}  // namespace cusp::scenarios
