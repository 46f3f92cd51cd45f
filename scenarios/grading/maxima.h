/// Points as people read them: a rubric's weights scaled so that the greatest points sum to the score's maximum, in
/// tenths, and the order in which losses are reported. Any thread.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

/// Steps of a point that are shown. The remainders of the rounding go to the largest first, so that the sum holds.
inline constexpr double kShownPoint = 0.1;
/// Points: a smaller loss does not show.
inline constexpr double kLeastShownLoss = 0.5 * kShownPoint;

/// A score as people read it: to kShownPoint, but never up to a whole number: 69.96 is not 70, the mark to pass.
[[nodiscard]] inline double shown_score(double points) noexcept {
  const double whole = std::round(points), tenth = std::round(points * 10) / 10;
  return points > 0.0 && tenth == whole && points < whole - kScoreSlack ? whole - kShownPoint : tenth;
}

/// Greatest points of each criterion before an attempt, in the rubric's order: multiples of kShownPoint that sum to 100.
/// All 0 if no criterion has a weight.
[[nodiscard]] std::vector<double> scaled_maxima(const Scenario& scenario);

struct ScaledPoints {
  double points = 0, points_max = 0;
};

/// Points of each criterion of a grade, new or stored, in its order. The maxima sum to grade.score_max over what was
/// measured; where all was measured they are scaled_maxima(). What was not measured has 0 of 0, but of a target that was left out. Points sum to
/// shown_score(), but full points stay full and none stays none, which can put the sum off by a step or two.
[[nodiscard]] std::vector<ScaledPoints> scaled_points(const Grade& grade);

/// Points of the score for one point of a criterion: 1 where the greatest points sum to score_max. A grade whose points are of the
/// weights has another sum.
[[nodiscard]] double score_per_point(const Grade& grade);

/// `points` given to a criterion of the grade, in points of the score, not rounded: but full ones are those of scaled_points().
[[nodiscard]] double points_of_score(const Grade& grade, std::string_view criterion, double points);

/// A stored number as it counts: 0 unless it is finite and above 0.
[[nodiscard]] inline double usable(double value) noexcept { return std::isfinite(value) && value > 0.0 ? value : 0.0; }

/// Of the greatest points of its criteria.
[[nodiscard]] inline double sum_of_maxima(const Grade& grade) noexcept {
  double sum = 0;
  for (const CriterionGrade& c : grade.criteria) sum += usable(c.points_max);
  return sum;
}

/// Points of the score that a criterion of the grade lost, not rounded, whatever its own points are of.
[[nodiscard]] inline double lost_points(const Grade& grade, const CriterionGrade& criterion) noexcept {
  const double sum = sum_of_maxima(grade);
  return sum > 0.0 ? usable(grade.score_max) * usable(criterion.points_max - criterion.points) / sum : 0.0;
}

/// A critical event, or a criterion that lost points.
struct LossReason {
  std::string critical;       // key ("pulp_exposure"); empty: a criterion
  std::size_t criterion = 0;  // index in grade.criteria
  double lost = 0;            // scaled points, not rounded; 0 of a critical event
};

/// Critical events first, the opened pulp before all others. Then the criteria whose loss shows, the greatest loss
/// first. Last those that lost only because little was drilled: they follow from the target.
[[nodiscard]] std::vector<LossReason> loss_reasons(const Grade& grade);

}  // namespace cusp::scenarios
