/// A student's own assessment of an attempt: each criterion rated in three steps before the result is shown. The text of a
/// statement (statement_rows.h) holds it, so that it is erased with the student's other texts. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/grading/grade.h"
#include "storage/modules.h"
#include "storage/records/statement_rows.h"

namespace cusp::storage {

enum class OwnRating : std::uint8_t { met, partly, not_met };
std::string_view key_of(OwnRating rating) noexcept;

struct SelfAssessment {
  std::map<std::string, OwnRating> ratings{};  // by the criterion's id; a criterion without one was left open
  bool skipped() const noexcept { return ratings.empty(); }
  friend bool operator==(const SelfAssessment&, const SelfAssessment&) = default;
};

/// JSON: {"depth_mean":"met"}; {} if skipped.
std::string text_of(const SelfAssessment& own);
/// nullopt unless `text` is such JSON.
std::optional<SelfAssessment> self_assessment_from(std::string_view text);

/// nullopt without one, or if its text is erased.
std::optional<SelfAssessment> self_assessment_of(const std::vector<SignedStatement>& statements);

/// The step that the points of a criterion of the grade come to: all of them but for a loss that does not show in the score, at least
/// half, fewer.
OwnRating measured_rating(const Grade& grade, const CriterionGrade& criterion);

/// Of the rated criteria that bring points; met counts whole, partly half. Both of 100.
struct RatedPoints {
  int criteria = 0;
  double own = 0, measured = 0;
};
RatedPoints rated_points(const SelfAssessment& own, const Grade& grade);

}  // namespace cusp::storage
