#include "scenarios/grading/grader.h"

#include <algorithm>
#include <string_view>

#include "scenarios/grading/bands.h"

namespace cusp {

namespace {

const Measure* find(const std::vector<Measure>& measures, std::string_view metric) {
  const auto it = std::find_if(measures.begin(), measures.end(), [&](const Measure& m) { return m.metric == metric; });
  return it == measures.end() ? nullptr : &*it;
}

CriterionGrade grade_one(const Criterion& criterion, const Measure* measure) {
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
  const Bands& bands = criterion.bands;
  const double value = measure->value;
  out.points_max = criterion.weight;
  out.points = criterion.weight * share_of_points(bands, value);
  out.band = band_of(bands, value, measure->uncertainty);
  if (out.points == out.points_max) {
    out.reason_code = "full";
    out.reason_args = {{"value", value}};
    return out;
  }
  const bool depth = criterion.metric.starts_with("depth_");
  const bool above = value > bands.ideal_hi;
  out.reason_code = above ? (depth ? "too_deep" : "too_much") : (depth ? "too_shallow" : "too_little");
  out.reason_args = {
      {"value", value}, {"limit", above ? bands.ideal_hi : bands.ideal_lo}, {"lost", out.points_max - out.points}};
  return out;
}

}  // namespace

Grade grade(const Scenario& scenario, const std::vector<Measure>& measures) {
  Grade out;
  out.pass_mark = scenario.rubric.pass;
  double points = 0, most = 0;
  for (const Criterion& criterion : scenario.rubric.criteria) {
    out.criteria.push_back(grade_one(criterion, find(measures, criterion.metric)));
    points += out.criteria.back().points;
    most += out.criteria.back().points_max;
  }
  out.score = most > 0 ? out.score_max * points / most : 0.0;
  for (const std::string& key : scenario.rubric.critical) {
    const Measure* m = find(measures, key);
    if (m != nullptr && m->measured && m->value > m->uncertainty) out.critical.push_back(key);
  }
  out.passed = most > 0 && out.score >= out.pass_mark && out.critical.empty();
  return out;
}

}  // namespace cusp
