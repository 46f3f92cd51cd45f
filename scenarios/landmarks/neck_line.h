/// The cemento-enamel junction of a voxel tooth, by its tissues. Inside of this folder.
#pragma once

#include <vector>

#include "scenarios/landmarks/tooth_surface.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Points every 5 degrees about a vertical line: where, going down, the outermost tissue is enamel for the last time. Closed. Empty
/// where more than a tenth of the ways meet no enamel above another tissue: of one tissue, or without a root.
[[nodiscard]] std::vector<Vec3> neck_line(const ToothSurface& tooth, Vec2 middle_mm);

}  // namespace cusp::scenarios
