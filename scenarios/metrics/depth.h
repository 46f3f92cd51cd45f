/// Depth of the floor that was reached, below the target's reference plane.
#pragma once

#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct FloorDepth {
  double least_mm = 0, mean_mm = 0, most_mm = 0;
  Vec3 least_at_mm{0.0}, most_at_mm{0.0};
  std::size_t samples = 0;  // columns with a floor that a bur left
};

/// Looks down columns half a voxel apart, over the outline inset by the corner's radius (there the target's floor is
/// flat). A column counts when the first tissue from above is a face that a bur left and leans less than 45 degrees
/// (dental.md 2.2: more is a wall). In a tree the face must face its pulpal floor (scenarios/shapes/facing.h) where
/// the target is flat, off a rounded axiopulpal line angle, or lie in a hole below that place, more than kWallReachMm beside the other
/// floors; depth is from the plane of its first outline. nullopt when no column has such a floor, or the target has no outline.
/// A column that was cut through has its floor where the specimen ended: else a hole would be no depth. In a tree it counts if the
/// specimen ended below the pulpal floor: below a proximal box stands air.
[[nodiscard]] std::optional<FloorDepth> floor_depth(const Reference& reference, const Volume& volume);

/// Of the columns of a tree that were cut through below this floor of the target, a voxel apart, the lowest place where the tooth
/// ended. nullopt where there is none, and of a filled volume.
[[nodiscard]] std::optional<Vec3> lowest_cut_through(const Reference& reference, const Volume& volume, FaceName floor);

}  // namespace cusp::scenarios
