/// Measures against a rubric.
#pragma once

#include <string_view>
#include <vector>

#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

/// Axes of a body in space: of a device that senses them all, and where there is no device (a scan, a volume file).
inline constexpr int kAllAxes = 6;

/// Score = 100 · sum of points / sum of their maxima, over what was measured; a criterion that was not measured has
/// points_max 0 and is marked. The maxima of the others are their weights scaled to sum to 100. Passed: at least one criterion measured, a score that
/// reaches() the pass mark, and no critical event. A critical key
/// happened when its measure is above its uncertainty. The order of `measures` does not matter.
///
/// A preparation that was begun counts in proportion to what was drilled. Where the rubric asks for target_removed and that
/// was measured, a share scales the points of every other criterion, but of uncut_remainder, surface_within_*, caries_left_*,
/// and of a tissue that the bands ask to be removed. Up to half of target_removed's ideal_lo the share is target_removed / 100;
/// from there it rises in a straight line to 1 at ideal_lo. At share 1 nothing changes. For a criterion of one of several targets that
/// target's own target_removed stands in its place, where the rubric asks for it. Where the rubric asks for those of several targets
/// alone, a criterion of the whole counts with their mean share.
///
/// reason_code: full, too_much, too_little (args value, limit = the ideal edge that was missed, lost = points),
/// too_deep, too_shallow (the same, for depth_*), too_dry, too_warm (the same, for coolant), not_measured (no args), little_drilled (args share,
/// lost) where the share takes more points than the criterion's own bands do.
///
/// A criterion that needs more axes than the device senses (`device_dof`, 3 to 6) is shown with its value and has
/// points_max 0, as if it had not been measured: what the student could not do is not marked.
[[nodiscard]] Grade grade(const Scenario& scenario, const std::vector<Measure>& measures, int device_dof = kAllAxes);

/// Sets CriterionGrade::counts_with_target: true where share scales the criterion, by the rule of the grade's evaluator.
/// grade() has called it; the records do not keep the mark, so a grade that was read from them needs it with its rubric.
void mark_counted_with_target(Grade& grade, const Rubric& rubric);

/// The share that counts for a criterion, 0 to 1, by the rule of the grade's evaluator; 1 where the rubric does not ask for the target.
[[nodiscard]] double share_counted(const Grade& grade, const Rubric& rubric, std::string_view criterion);

}  // namespace cusp::scenarios
