/// Measures against a rubric.
#pragma once

#include <vector>

#include "scenarios/grading/grade.h"

namespace cusp {

/// Score = 100 · sum of points / sum of their maxima, over what was measured; a criterion that was not measured has
/// points_max 0 and says so. Passed: at least one criterion measured, score >= pass and no critical event. A critical key
/// happened when its measure is above its uncertainty. The order of `measures` does not matter.
///
/// reason_code: full, too_much, too_little (args value, limit = the ideal edge that was missed, lost = points),
/// too_deep, too_shallow (the same, for depth_*), not_measured (no args).
[[nodiscard]] Grade grade(const Scenario& scenario, const std::vector<Measure>& measures);

}  // namespace cusp
