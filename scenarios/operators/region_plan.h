/// Strokes that remove a target of any shape with one bur, upright or tilted, from above downwards.
#pragma once

#include "scenarios/operators/plan.h"
#include "scenarios/operators/poses.h"

namespace cusp::scenarios {

/// How a path is laid; lengths in radii of the bur.
struct RegionPlanStyle {
  double layer_radii = 0.75;  // height of a layer
  double row_radii = 0.5;     // distance of its rows
};

/// One bur's path. Layers from the highest tissue of the target down: each clears its area by rows, then follows the area's
/// edge. Then the edge at the height of each level floor, and rows along the lowest poses: the floor, level or not. Within a
/// layer the bur stays in allowed poses; between areas it lifts above the specimen. What lies under an overhang is reached
/// from the side, in layers. Seconds for a fine target. No strokes where no pose is allowed. `above_mm`: height of moves
/// above the specimen.
[[nodiscard]] Plan plan_region(const Poses& poses, double above_mm, const RegionPlanStyle& style, PlanCancel cancel = nullptr);

}  // namespace cusp::scenarios
