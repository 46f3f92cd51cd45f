/// Pieces and hollows of a map of tissue codes. Neighbours share a face.
#pragma once

#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Empties all but the piece of most voxels (the first in index order of several as large); how many went.
std::size_t keep_largest_piece(const Grid& grid, std::vector<Tissue>& labels);

/// Gives what no way leads to from outside a tissue; how many voxels.
std::size_t fill_hollows(const Grid& grid, std::vector<Tissue>& labels, Tissue tissue);

}  // namespace cusp::scenarios
