#include "scenarios/grading/maxima.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cusp::scenarios {

namespace {

constexpr double kStepsPerPoint = 10.0;  // 1 / kShownPoint, as a whole number
static_assert(kStepsPerPoint * kShownPoint == 1.0);

double sum_of(const std::vector<double>& values) noexcept {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A value in steps between two bounds.
struct Step {
  double wanted = 0;
  long least = 0, most = 0;
  long taken = 0;
};

/// Largest remainder: each gets the whole steps below what it wants, the rest go where most is missing.
void round_to(std::vector<Step>& steps, long whole) {
  long rest = whole;
  for (Step& s : steps) {
    s.taken = std::clamp(static_cast<long>(std::floor(s.wanted)), s.least, s.most);
    rest -= s.taken;
  }
  const auto missing = [](const Step& s) { return s.wanted - static_cast<double>(s.taken); };
  while (rest != 0) {
    Step* next = nullptr;
    for (Step& s : steps) {
      if (rest > 0 ? s.taken >= s.most : s.taken <= s.least) continue;
      const bool better = next == nullptr || (rest > 0 ? missing(s) > missing(*next) : missing(s) < missing(*next));
      if (better) next = &s;
    }
    if (next == nullptr) return;
    next->taken += rest > 0 ? 1 : -1;
    rest += rest > 0 ? -1 : 1;
  }
}

/// Weights as steps of points that sum to `whole`.
std::vector<long> maxima_of(const std::vector<double>& weights, long whole) {
  const double sum = sum_of(weights);
  std::vector<Step> steps;
  for (const double weight : weights)
    steps.push_back({sum > 0.0 ? static_cast<double>(whole) * (weight / sum) : 0.0, 0, weight > 0.0 ? whole : 0, 0});
  if (sum > 0.0) round_to(steps, whole);
  std::vector<long> out;
  for (const Step& s : steps) out.push_back(s.taken);
  return out;
}

long steps_of(double points) noexcept { return std::lround(points * kStepsPerPoint); }

}  // namespace

std::vector<double> scaled_maxima(const Scenario& scenario) {
  std::vector<double> weights;
  for (const Criterion& c : scenario.rubric.criteria) weights.push_back(usable(c.weight));
  std::vector<double> out;
  for (const long steps : maxima_of(weights, steps_of(Grade{}.score_max)))
    out.push_back(static_cast<double>(steps) / kStepsPerPoint);
  return out;
}

std::vector<ScaledPoints> scaled_points(const Grade& grade) {
  std::vector<double> weights, points;
  for (const CriterionGrade& c : grade.criteria) {
    weights.push_back(usable(c.points_max));
    points.push_back(std::min(usable(c.points), weights.back()));
  }
  const double sum = sum_of(weights);
  const long whole = steps_of(usable(grade.score_max));
  const std::vector<long> maxima = maxima_of(weights, whole);
  std::vector<Step> steps;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool full = points[i] == weights[i], none = points[i] == 0.0;
    const double wanted = sum > 0.0 ? static_cast<double>(whole) * (points[i] / sum) : 0.0;
    steps.push_back({wanted, full ? maxima[i] : 0, none ? 0 : maxima[i], 0});
  }
  if (sum > 0.0) round_to(steps, steps_of(shown_score(usable(grade.score_max) * sum_of(points) / sum)));
  std::vector<ScaledPoints> out;
  for (std::size_t i = 0; i < steps.size(); ++i)
    out.push_back({static_cast<double>(steps[i].taken) / kStepsPerPoint, static_cast<double>(maxima[i]) / kStepsPerPoint});
  return out;
}

double score_per_point(const Grade& grade) {
  const double sum = sum_of_maxima(grade);
  const double whole = usable(grade.score_max);
  const bool of_the_score = std::abs(sum - whole) <= kScoreSlack;
  return of_the_score || sum == 0.0 || whole == 0.0 ? 1.0 : whole / sum;
}

double points_of_score(const Grade& grade, std::string_view criterion, double points) {
  const auto of = std::ranges::find(grade.criteria, criterion, &CriterionGrade::id);
  const bool full = of != grade.criteria.end() && of->points_max > 0.0 && points >= of->points_max;
  return full ? scaled_points(grade)[static_cast<std::size_t>(of - grade.criteria.begin())].points_max : points * score_per_point(grade);
}

std::vector<LossReason> loss_reasons(const Grade& grade) {
  std::vector<LossReason> out;
  for (const std::string& key : grade.critical) out.push_back({key, 0, 0.0});
  std::stable_sort(out.begin(), out.end(), [](const LossReason& a, const LossReason& b) {
    return a.critical == "pulp_exposure" && b.critical != "pulp_exposure";
  });
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  for (std::size_t i = 0; i < grade.criteria.size(); ++i) {
    const double lost = lost_points(grade, grade.criteria[i]);
    if (lost >= kLeastShownLoss) out.push_back({{}, i, lost});
  }
  const auto follows = [&](const LossReason& r) { return grade.criteria[r.criterion].reason_code == "little_drilled"; };
  std::stable_sort(out.begin() + first, out.end(), [&](const LossReason& a, const LossReason& b) {
    if (follows(a) != follows(b)) return follows(b);
    return a.lost > b.lost;
  });
  return out;
}

}  // namespace cusp::scenarios
