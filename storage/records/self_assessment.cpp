#include "storage/records/self_assessment.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "scenarios/grading/maxima.h"

namespace cusp::storage {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kRatings = {"met", "partly", "not_met"};
constexpr std::array<double, 3> kShares = {1.0, 0.5, 0.0};  // of a criterion's points

}  // namespace

std::string_view key_of(OwnRating rating) noexcept { return kRatings[static_cast<std::size_t>(rating)]; }

std::string text_of(const SelfAssessment& own) {
  json out = json::object();
  for (const auto& [criterion, rating] : own.ratings) out[criterion] = key_of(rating);
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<SelfAssessment> self_assessment_from(std::string_view text) {
  const json in = json::parse(text, nullptr, false);
  if (!in.is_object()) return std::nullopt;
  SelfAssessment own;
  for (const auto& [criterion, rating] : in.items()) {
    const auto found = rating.is_string() ? std::ranges::find(kRatings, rating.get_ref<const std::string&>()) : kRatings.end();
    if (found == kRatings.end()) return std::nullopt;
    own.ratings[criterion] = static_cast<OwnRating>(found - kRatings.begin());
  }
  return own;
}

std::optional<SelfAssessment> self_assessment_of(const std::vector<SignedStatement>& statements) {
  const auto found = std::ranges::find(statements, StatementKind::self_assessment, &SignedStatement::kind);
  return found == statements.end() ? std::nullopt : self_assessment_from(found->text);
}

OwnRating measured_rating(const Grade& grade, const CriterionGrade& c) {
  if (scenarios::lost_points(grade, c) < scenarios::kLeastShownLoss) return OwnRating::met;
  return c.points < c.points_max / 2 ? OwnRating::not_met : OwnRating::partly;
}

RatedPoints rated_points(const SelfAssessment& own, const Grade& grade) {
  RatedPoints out;
  double most = 0;
  for (const CriterionGrade& c : grade.criteria) {
    const auto rating = own.ratings.find(c.id);
    if (rating == own.ratings.end() || !c.measure.measured || !(c.points_max > 0)) continue;
    ++out.criteria;
    most += c.points_max;
    out.own += kShares[static_cast<std::size_t>(rating->second)] * c.points_max;
    out.measured += c.points;
  }
  if (most <= 0) return {};
  out.own *= 100 / most;
  out.measured *= 100 / most;
  return out;
}

}  // namespace cusp::storage
