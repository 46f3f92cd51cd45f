/// What differs between a stored grade and one of the same attempt that was made anew. Stored grades stay as they are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

/// One criterion that differs. nullopt: that grade has no such criterion, or could not measure it.
struct CriterionChange {
  std::string id;  // metric key
  std::optional<double> value_before, value_after;    // in the metric's unit
  std::optional<double> points_before, points_after;  // of 100
};

struct GradeChanges {
  std::string evaluator_before, evaluator_after;
  double score_before = 0, score_after = 0;
  bool passed_before = false, passed_after = false;
  std::vector<CriterionChange> criteria;  // in the order of the stored grade, then those that it lacks
  std::vector<std::string> critical;      // events that one of the grades has alone, in the same order
  bool none() const noexcept {
    return criteria.empty() && critical.empty() && score_before == score_after && passed_before == passed_after;
  }
};

/// Values and points are compared bit for bit. Any thread.
[[nodiscard]] GradeChanges changes(const Grade& before, const Grade& after);

}  // namespace cusp::scenarios
