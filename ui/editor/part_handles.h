/// The handles of a leaf that is no outline, and any part but an outline after one of its handles was moved. Frame: specimen, z up.
/// Millimetres. Pure functions.
#pragma once

#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/editor/target_handles.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Place and, as far as the shape has them, other end, radii, two extents and floor. None of a node (node_handles.h), of an outline, and of a shape that
/// is of the specimen's voxels.
std::vector<TargetHandle> handles_of_part(const Region& part);

/// The part after a handle was moved: a place and an end go there, a radius and an extent reach there on both sides, and a floor moves
/// under a top that stays. All leaves of a node move as its place does; its rounding and its growth change by the way along the handle.
/// Rounds to kHandleStepMm but for the middle of a box whose floor moves. Pre: the handle is one of handles_of_part(part) or
/// handles_of_node(part).
Region moved_part(const Region& part, const TargetHandle& handle, Vec3 to_mm);

}  // namespace cusp::ui
