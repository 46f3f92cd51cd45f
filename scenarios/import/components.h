/// Connected components and hollows of a map of tissue codes. Neighbours share a face.
#pragma once

#include <vector>

#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Empties all but the largest component (of equal ones the first in index order); returns the emptied voxels.
std::size_t keep_largest_component(const Grid& grid, std::vector<Tissue>& labels);

/// Gives `tissue` to every hollow that is closed to the outside; returns its voxels.
std::size_t fill_hollows(const Grid& grid, std::vector<Tissue>& labels, Tissue tissue);

}  // namespace cusp::scenarios
