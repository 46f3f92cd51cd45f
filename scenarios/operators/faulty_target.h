/// Changes to a target, face by face: what a fault cuts instead of it. Any thread.
#pragma once

#include <functional>

#include "scenarios/format/region.h"

namespace cusp::scenarios {

using FaceChoice = std::function<bool(FaceName)>;

/// The chosen faces of outlines, boxes, cylinders, cones and spheres, moved out of the region (below 0: into it), mm. The
/// walls of a slot move all together. A half-space, which is an open side, and leaves of voxels stay. False if nothing moved.
bool move_faces(Region& region, const FaceChoice& chosen, double out_mm);

/// The walls on the side +y of outlines and boxes turned about their lower edge, so that they open upwards. False if there is
/// none.
bool tilt_walls(Region& region, double deg);

[[nodiscard]] Region either(Region a, Region b);   // union
[[nodiscard]] Region without(Region a, Region b);  // a less b
[[nodiscard]] Region grown(Region a, double by_mm);
[[nodiscard]] Region region_of(Tissue tissue);
/// The first lesion leaf of the target; one down to firm dentine if it has none.
[[nodiscard]] Region lesion_of(const Region& target);

}  // namespace cusp::scenarios
