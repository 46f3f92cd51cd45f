#include "scenarios/grading/changes.h"

#include <algorithm>

namespace cusp::scenarios {

namespace {

const CriterionGrade* find(const Grade& grade, const std::string& id) {
  const auto it = std::ranges::find(grade.criteria, id, &CriterionGrade::id);
  return it == grade.criteria.end() ? nullptr : &*it;
}

CriterionChange change_of(const std::string& id, const CriterionGrade* before, const CriterionGrade* after) {
  CriterionChange out{id, {}, {}, {}, {}};
  const auto fill = [](const CriterionGrade* from, std::optional<double>& value, std::optional<double>& points) {
    if (from == nullptr) return;
    if (from->measure.measured) value = from->measure.value;
    if (from->measure.measured || from->points_max > 0.0) points = from->points;
  };
  fill(before, out.value_before, out.points_before);
  fill(after, out.value_after, out.points_after);
  return out;
}

/// Critical events that `one` has and `other` has not.
void add_events_of_one(const Grade& one, const Grade& other, std::vector<std::string>& out) {
  for (const std::string& key : one.critical)
    if (std::ranges::find(other.critical, key) == other.critical.end()) out.push_back(key);
}

}  // namespace

GradeChanges changes(const Grade& before, const Grade& after) {
  GradeChanges out{before.evaluator, after.evaluator, before.score, after.score, before.passed, after.passed, {}, {}};
  const auto add = [&](const std::string& id) {
    const CriterionChange one = change_of(id, find(before, id), find(after, id));
    if (one.value_before != one.value_after || one.points_before != one.points_after) out.criteria.push_back(one);
  };
  for (const CriterionGrade& c : before.criteria) add(c.id);
  for (const CriterionGrade& c : after.criteria)
    if (find(before, c.id) == nullptr) add(c.id);
  add_events_of_one(before, after, out.critical);
  add_events_of_one(after, before, out.critical);
  return out;
}

}  // namespace cusp::scenarios
