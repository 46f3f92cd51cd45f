/// Measures against a rubric.
#pragma once

#include <vector>

#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

/// Axes of a body in space: of a device that senses them all, and where there is no device (a scan, a volume file).
inline constexpr int kAllAxes = 6;

/// Score = 100 · sum of points / sum of their maxima, over what was measured; a criterion that was not measured has
/// points_max 0 and is marked. The maxima of the others are their weights scaled to sum to 100. Passed: at least one criterion measured, score >= pass and no critical event. A critical key
/// happened when its measure is above its uncertainty. The order of `measures` does not matter.
///
/// What is kept intact counts in proportion to what was drilled. Where the rubric asks for target_removed and that was
/// measured, share = min(1, target_removed / its ideal_lo) scales the points of every criterion that a tooth nobody
/// touched would earn: remaining_over_pulp, and whatever gives points at 0 (overcut_*, depth_most, force_*, time), but
/// target_removed and uncut_remainder themselves. At share 1 nothing changes.
///
/// reason_code: full, too_much, too_little (args value, limit = the ideal edge that was missed, lost = points),
/// too_deep, too_shallow (the same, for depth_*), too_dry, too_warm (the same, for coolant), not_measured (no args), little_drilled (args share,
/// lost) where the share takes more points than the criterion's own bands do.
///
/// A criterion that needs more axes than the device senses (`device_dof`, 3 to 6) is shown with its value and has
/// points_max 0, as if it had not been measured: what the student could not do is not marked.
[[nodiscard]] Grade grade(const Scenario& scenario, const std::vector<Measure>& measures, int device_dof = kAllAxes);

/// Sets CriterionGrade::counts_with_target: true where share scales the criterion. grade() has called it; the records do
/// not keep the mark, so a grade that was read from them needs it with its scenario's rubric.
void mark_counted_with_target(Grade& grade, const Rubric& rubric);

}  // namespace cusp::scenarios
