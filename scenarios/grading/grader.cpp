#include "scenarios/grading/grader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "scenarios/grading/bands.h"

namespace cusp::scenarios {

namespace {

const Measure* find(const std::vector<Measure>& measures, std::string_view metric) {
  const auto it = std::find_if(measures.begin(), measures.end(), [&](const Measure& m) { return m.metric == metric; });
  return it == measures.end() ? nullptr : &*it;
}

/// Form is the bur's own after one plunge: its width, its taper, its level end (scenarios/metrics/form.h).
bool is_of_form(std::string_view metric) {
  constexpr std::array<std::string_view, 5> kForms = {"wall_angle_", "convergence_", "floor_", "isthmus_width", "ridge_"};
  return std::ranges::any_of(kForms, [metric](std::string_view form) { return metric.starts_with(form); });
}

/// Whether a tooth that nobody touched, or touched once, earns points here: the bur went nowhere it should not, because it went nowhere.
/// Of an untouched tooth depth, excess, push and time are 0, and the dentine over the pulp is whole.
bool earned_by_doing_nothing(const Criterion& criterion) {
  const std::string_view metric = criterion.metric;
  if (metric == "remaining_over_pulp" || is_of_form(metric)) return true;
  if (metric == "target_removed" || metric == "uncut_remainder") return false;
  return share_of_points(criterion.bands, 0.0) > 0.0;
}

/// How much of the target that earns full points was drilled, 0 to 1; 1 where the rubric does not ask for it.
double share_drilled(const Rubric& rubric, const std::vector<Measure>& measures) {
  const auto asked = std::find_if(rubric.criteria.begin(), rubric.criteria.end(),
                                  [](const Criterion& c) { return c.metric == "target_removed"; });
  const Measure* removed = find(measures, "target_removed");
  if (asked == rubric.criteria.end() || removed == nullptr || !removed->measured) return 1.0;
  if (!(removed->value < asked->bands.ideal_lo)) return std::isfinite(removed->value) ? 1.0 : 0.0;
  return std::max(0.0, removed->value) / asked->bands.ideal_lo;
}

bool asks_for_target(const Rubric& rubric) {
  return std::ranges::any_of(rubric.criteria, [](const Criterion& c) { return c.metric == "target_removed"; });
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

CriterionGrade grade_one(const Criterion& criterion, const Measure* measure, double share, int device_dof) {
  CriterionGrade out;
  out.id = criterion.metric;
  if (measure == nullptr || !measure->measured) {
    if (measure != nullptr) out.measure = *measure;
    out.measure.metric = criterion.metric;
    out.measure.measured = false;
    out.band = "not_measured";
    out.reason_code = "not_measured";
    return out;
  }
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
  out.points = earned_by_doing_nothing(criterion) ? within_bands * share : within_bands;
  out.band = band_of(bands, value, measure->uncertainty);
  if (out.points == out.points_max) {
    out.reason_code = "full";
    out.reason_args = {{"value", value}};
    return out;
  }
  const double lost = out.points_max - out.points;
  if (within_bands - out.points > out.points_max - within_bands) {
    out.reason_code = "little_drilled";
    out.reason_args = {{"share", share}, {"lost", lost}};
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
  const bool asked = asks_for_target(rubric);
  for (CriterionGrade& c : grade.criteria) {
    const auto own = std::ranges::find_if(rubric.criteria, [&](const Criterion& r) { return r.metric == c.id; });
    c.counts_with_target = asked && own != rubric.criteria.end() && earned_by_doing_nothing(*own);
  }
}

Grade grade(const Scenario& scenario, const std::vector<Measure>& measures, int device_dof) {
  Grade out;
  out.pass_mark = scenario.rubric.pass;
  const double share = share_drilled(scenario.rubric, measures);
  double points = 0, most = 0;
  for (const Criterion& criterion : scenario.rubric.criteria) {
    out.criteria.push_back(grade_one(criterion, find(measures, criterion.metric), share, device_dof));
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
  out.passed = most > 0 && out.score >= out.pass_mark && out.critical.empty();
  return out;
}

}  // namespace cusp::scenarios
