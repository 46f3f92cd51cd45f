#include "scenarios/grading/grader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scenarios/format/keys.h"
#include "scenarios/grading/bands.h"

namespace cusp::scenarios {

namespace {

const Measure* find(const std::vector<Measure>& measures, std::string_view metric) {
  const auto it = std::find_if(measures.begin(), measures.end(), [&](const Measure& m) { return m.metric == metric; });
  return it == measures.end() ? nullptr : &*it;
}

Possible possible_values(std::string_view criterion) {
  const std::string_view metric = split_metric(criterion).metric;
  const auto known = std::ranges::find(kMetricKeys, metric, &MetricKey::key);
  if (known != kMetricKeys.end()) return {known->least, known->most};
  return metric.starts_with("removed_") ? Possible{0.0} : Possible{};
}

/// Measured over the whole target or the whole lesion: a small hole lowers them by itself.
bool is_of_the_whole(std::string_view metric) {
  constexpr std::array<std::string_view, 4> kWhole = {"target_removed", "uncut_remainder", "surface_within_", "caries_left_"};
  return std::ranges::any_of(kWhole, [metric](std::string_view key) { return metric.starts_with(key); });
}

/// Whether a tooth that nobody touched, or touched once, earns points here. A single plunge has a depth, the bur's own width
/// and taper, its push and its time; and it spoiled nothing. Tissue that the bands ask to be removed is earned by removing it.
bool counts_with_target(const Criterion& criterion) {
  const std::string_view metric = split_metric(criterion.metric).metric;
  if (is_of_the_whole(metric)) return false;
  return !metric.starts_with("removed_") || share_of_points(criterion.bands, 0.0) > 0.0;
}

/// The rule of evaluators 2 and 3: what a tooth earns that nobody touched.
bool counted_with_target_before_4(const Criterion& criterion) {
  constexpr std::array<std::string_view, 5> kForms = {"wall_angle_", "convergence_", "floor_", "isthmus_width", "ridge_"};
  const std::string_view metric = criterion.metric;
  if (metric == "remaining_over_pulp") return true;
  if (std::ranges::any_of(kForms, [metric](std::string_view form) { return metric.starts_with(form); })) return true;
  if (metric == "target_removed" || metric == "uncut_remainder") return false;
  return share_of_points(criterion.bands, 0.0) > 0.0;
}

bool is_before_4(std::string_view evaluator) { return evaluator == "2" || evaluator == "3"; }

/// Share of their points that the criteria have which count with the target. Up to half of its ideal_lo it is the removed
/// share itself, so that a twentieth of the target earns a twentieth of the points. From there it rises in a straight line
/// to 1 at ideal_lo.
double share_drilled(const Bands& asked, double removed) {
  const double ideal = asked.ideal_lo, half = 0.5 * ideal;
  if (!(removed < ideal)) return std::isfinite(removed) ? 1.0 : 0.0;
  if (removed <= half) return std::max(0.0, removed) / 100.0;
  return half / 100.0 + (1.0 - half / 100.0) * ((removed - half) / (ideal - half));
}

/// What asks how much of a criterion's target was removed: of its own one of several targets, else of the whole target, else of each of
/// the several. Empty where the rubric asks for none of them.
std::vector<const Criterion*> target_criteria(const Rubric& rubric, std::string_view criterion) {
  constexpr std::string_view kRemoved = "target_removed";
  for (const std::string& key : {metric_key(kRemoved, split_metric(criterion).target), std::string(kRemoved)}) {
    const auto it = std::ranges::find(rubric.criteria, key, &Criterion::metric);
    if (it != rubric.criteria.end()) return {&*it};
  }
  std::vector<const Criterion*> out;
  for (const Criterion& c : rubric.criteria)
    if (split_metric(c.metric).metric == kRemoved) out.push_back(&c);
  return out;
}

/// The share of the points that a criterion has which counts with its target; of several targets the mean.
/// `removed_of(key)`: the measure, nullptr for none.
template <class RemovedOf, class ShareOf>
double share_of_targets(const Rubric& rubric, std::string_view criterion, RemovedOf removed_of, ShareOf share_of) {
  double sum = 0;
  int measured = 0;
  for (const Criterion* asked : target_criteria(rubric, criterion)) {
    const Measure* removed = removed_of(asked->metric);
    if (removed == nullptr || !removed->measured) continue;
    sum += share_of(asked->bands, removed->value);
    ++measured;
  }
  return measured > 0 ? sum / measured : 1.0;
}

/// Weights to points of the score's maximum, over what was measured.
void scale_to_maximum(Grade& grade, double most) {
  if (!(most > 0.0)) return;
  const double factor = grade.score_max / most;
  for (CriterionGrade& c : grade.criteria) {
    c.points *= factor;
    c.points_max *= factor;
    if (const auto lost = c.reason_args.find("lost"); lost != c.reason_args.end()) lost->second = c.points_max - c.points;
  }
}

/// Of a criterion's target, 0 to 1: what its points are scaled by, and what was removed of it.
struct Shares {
  double counted = 1, removed = 1;
};

/// Whether one of several targets was left out. What was not measured of it costs its points: else fewer points would be graded.
bool is_left_out(const Criterion& criterion, double removed) {
  constexpr double kHardly = 0.5;  // of the target [M]: of one that was cut, voxels may hide a measure
  return !split_metric(criterion.metric).target.empty() && counts_with_target(criterion) && removed < kHardly;
}

CriterionGrade not_measured(const Criterion& criterion, const Measure* measure, Shares shares, int device_dof) {
  CriterionGrade out;
  out.id = criterion.metric;
  if (measure != nullptr) out.measure = *measure;
  out.measure.metric = criterion.metric;
  out.measure.measured = false;
  out.band = out.reason_code = "not_measured";
  if (criterion.needs_dof > device_dof || !is_left_out(criterion, shares.removed)) return out;
  out.points_max = criterion.weight;
  out.reason_code = "little_drilled";
  out.reason_args = {{"share", shares.removed}, {"lost", criterion.weight}};
  return out;
}

CriterionGrade grade_one(const Criterion& criterion, const Measure* measure, Shares shares, int device_dof) {
  if (measure == nullptr || !measure->measured) return not_measured(criterion, measure, shares, device_dof);
  CriterionGrade out;
  out.id = criterion.metric;
  out.measure = *measure;
  if (criterion.needs_dof > device_dof) {
    out.band = "not_expressible";
    out.reason_code = "needs_dof";
    out.reason_args = {{"value", criterion.needs_dof}, {"limit", device_dof}};
    return out;
  }
  const Bands& bands = criterion.bands;
  const double value = measure->value;
  out.points_max = criterion.weight;
  const double within_bands = criterion.weight * share_of_points(bands, value);
  out.points = counts_with_target(criterion) ? within_bands * shares.counted : within_bands;
  out.band = band_of(bands, value, measure->uncertainty, possible_values(criterion.metric));
  if (out.points == out.points_max) {
    out.reason_code = "full";
    out.reason_args = {{"value", value}};
    return out;
  }
  const double lost = out.points_max - out.points;
  if (within_bands - out.points > out.points_max - within_bands) {
    out.reason_code = "little_drilled";
    out.reason_args = {{"share", shares.counted}, {"lost", lost}};
    return out;
  }
  const bool depth = criterion.metric.starts_with("depth_");
  const bool above = value > bands.ideal_hi;
  const char* much = depth                                          ? "too_deep"
                     : criterion.metric == "dry_cutting_time"       ? "too_dry"
                     : criterion.metric == "temperature_rise_peak" ? "too_warm"
                                                                    : "too_much";
  out.reason_code = above ? much : depth ? "too_shallow" : "too_little";
  out.reason_args = {{"value", value}, {"limit", above ? bands.ideal_hi : bands.ideal_lo}, {"lost", lost}};
  return out;
}

}  // namespace

void mark_counted_with_target(Grade& grade, const Rubric& rubric) {
  const bool before_4 = is_before_4(grade.evaluator);
  for (CriterionGrade& c : grade.criteria) {
    const auto own = std::ranges::find_if(rubric.criteria, [&](const Criterion& r) { return r.metric == c.id; });
    const bool asked = !target_criteria(rubric, c.id).empty();
    c.counts_with_target = asked && own != rubric.criteria.end() && (before_4 ? counted_with_target_before_4(*own) : counts_with_target(*own));
  }
}

double share_counted(const Grade& grade, const Rubric& rubric, std::string_view criterion) {
  const auto removed_of = [&](const std::string& key) -> const Measure* {
    const auto it = std::ranges::find(grade.criteria, key, &CriterionGrade::id);
    return it == grade.criteria.end() ? nullptr : &it->measure;
  };
  const bool before_4 = is_before_4(grade.evaluator);
  return share_of_targets(rubric, criterion, removed_of, [before_4](const Bands& asked, double removed) {
    return before_4 ? std::clamp(removed / asked.ideal_lo, 0.0, 1.0) : share_drilled(asked, removed);
  });
}

Grade grade(const Scenario& scenario, const std::vector<Measure>& measures, int device_dof) {
  Grade out;
  out.pass_mark = scenario.rubric.pass;
  double points = 0, most = 0;
  for (const Criterion& criterion : scenario.rubric.criteria) {
    const auto removed_of = [&](const std::string& key) { return find(measures, key); };
    const double share = share_of_targets(scenario.rubric, criterion.metric, removed_of, share_drilled);
    const Measure* own = find(measures, metric_key("target_removed", split_metric(criterion.metric).target));
    const Shares shares{share, own != nullptr && own->measured ? own->value / 100.0 : share};
    out.criteria.push_back(grade_one(criterion, find(measures, criterion.metric), shares, device_dof));
    points += out.criteria.back().points;
    most += out.criteria.back().points_max;
  }
  out.score = most > 0 ? out.score_max * points / most : 0.0;
  scale_to_maximum(out, most);
  mark_counted_with_target(out, scenario.rubric);
  for (const std::string& key : scenario.rubric.critical) {
    const Measure* m = find(measures, key);
    if (m != nullptr && m->measured && m->value > m->uncertainty) out.critical.push_back(key);
  }
  out.passed = most > 0 && reaches(out.score, out.pass_mark) && out.critical.empty();
  return out;
}

}  // namespace cusp::scenarios
