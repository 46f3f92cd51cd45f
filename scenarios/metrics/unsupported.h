/// Enamel that nothing carries. Source: dentistry.md, group "margin".
///
/// unsupported_enamel (mm3): enamel that is left and whose rod is cut: the straight way from it to the dentine, against the slope of the
/// distance to the dentino-enamel junction, passes what was removed, or the dentine was removed within kCarrierMm below its end.
/// Needs: a banded volume, a cut, enamel and dentine.
#pragma once

#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A thinner film of dentine carries nothing, mm [M].
inline constexpr double kCarrierMm = 0.1;

struct UnsupportedEnamel {
  double mm3 = 0, uncertainty_mm3 = 0;  // 95 %: the rods' direction, the junction and the cut face
  std::optional<Vec3> at_mm;            // some of it, next to the cut
  std::vector<IVec3> voxels;            // that hold some of it
};

/// Some tenths of a second for a molar at 0.1 mm. nullopt where one of the needs is missing.
[[nodiscard]] std::optional<UnsupportedEnamel> unsupported_enamel(const Reference& reference, const Volume& volume);

void add_unsupported(const Reference& reference, const Volume& volume, std::vector<Measure>& out);

}  // namespace cusp::scenarios
