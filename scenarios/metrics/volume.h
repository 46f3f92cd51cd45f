/// Over-cut by the target's faces. Source: dentistry.md, group "volume".
///
/// overcut_leeway_<face>, overcut_beyond_<face> (mm3): tissue that was removed outside the target, within its tolerance zone
/// and beyond it, where that face of the target is the nearest.
/// Needs: a target. A place off an edge belongs to the face that it lies furthest out of (scenarios/shapes/near.h).
#pragma once

#include <array>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct FaceOvercut {
  double mm3 = 0;
  double uncertainty_mm3 = 0;  // 95 %: the cut face, and a tenth of what an edge between two faces divides
  std::optional<Vec3> at_mm;   // on the cut surface, furthest off
};

struct OvercutByFace {
  std::array<FaceOvercut, kFaceNames> leeway, beyond;  // by FaceName
};

/// Walks the cut bricks once. nullopt where the target is empty.
[[nodiscard]] std::optional<OvercutByFace> overcut_by_face(const Reference& reference, const Volume& volume);

/// Appends all sixteen.
void add_volume(const Reference& reference, const Volume& volume, std::vector<Measure>& out);

}  // namespace cusp::scenarios
