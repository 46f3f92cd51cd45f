#include "storage/records/effective_grade.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cusp::storage {
namespace {

bool overrides(const SignedStatement& s) noexcept {
  return s.kind == StatementKind::override_points || s.kind == StatementKind::override_critical;
}

/// Of each criterion and critical event the newest.
std::vector<SignedStatement> newest_overrides(const std::vector<SignedStatement>& standing, int grade) {
  std::vector<SignedStatement> out;
  for (const SignedStatement& s : standing) {
    if (!overrides(s) || s.grade != grade) continue;
    std::erase_if(out, [&](const SignedStatement& o) { return o.kind == s.kind && o.criterion == s.criterion; });
    out.push_back(s);
  }
  return out;
}

/// Whether the statement changed the result: an override, or the withdrawal of one.
bool changes_result(const SignedStatement& s, const std::vector<SignedStatement>& all) {
  return overrides(s) || (s.kind == StatementKind::withdrawal &&
                          std::ranges::any_of(all, [&](const SignedStatement& o) { return o.id == s.withdraws && overrides(o); }));
}

/// Whether the examiner saw this result. A greater sequence alone does not tell: another station's numbers may run ahead of a change
/// that nobody there has read. Older programs kept no score, or the score alone.
bool is_of_result(const SignedStatement& confirmation, const Grade& result) {
  const bool of_score = !confirmation.points || std::abs(*confirmation.points - result.score) <= scenarios::kScoreSlack;
  return of_score && (!confirmation.shown || *confirmation.shown == shown_hash(result));
}

/// The newest one in force of this grade and its result that follows each change of the result, with a greater sequence.
std::optional<SignedStatement> confirmation_of(const std::vector<SignedStatement>& all, const std::vector<SignedStatement>& standing, int grade,
                                               const Grade& result) {
  std::optional<SignedStatement> out;
  std::int64_t changed = -1;
  for (const SignedStatement& s : all) {
    if (changes_result(s, all)) {
      changed = std::max(changed, s.sequence);
      out.reset();
    }
    const bool confirms = s.kind == StatementKind::confirmation && s.grade == grade && s.sequence > changed && is_of_result(s, result);
    if (confirms && std::ranges::find(standing, s.id, &SignedStatement::id) != standing.end()) out = s;
  }
  return out;
}

void apply(const SignedStatement& s, Grade& grade) {
  if (s.kind == StatementKind::override_critical) {
    std::erase(grade.critical, s.criterion);
    return;
  }
  const auto criterion = std::ranges::find(grade.criteria, s.criterion, &CriterionGrade::id);
  if (criterion == grade.criteria.end() || !s.points) return;
  criterion->points = std::clamp(*s.points, 0.0, criterion->points_max);
  if (criterion->points >= criterion->points_max) criterion->reason_code = "full";
}

double sum_of(const Grade& grade, double CriterionGrade::* points) {
  double sum = 0;
  for (const CriterionGrade& c : grade.criteria) sum += c.*points;
  return sum;
}

/// The criteria's sum, which no order of the overrides changes. Criteria of evaluator 2 have points of their weights, and the score is
/// their share of these. Where it is neither, the change of the sum counts.
double score_of(const Grade& stored, const Grade& changed) {
  const double before = sum_of(stored, &CriterionGrade::points), now = sum_of(changed, &CriterionGrade::points);
  const double weights = sum_of(stored, &CriterionGrade::points_max);
  const auto is_score = [&](double score) { return std::abs(stored.score - score) <= scenarios::kScoreSlack; };
  double score = stored.score + (now - before);
  if (before > 0 && is_score(before)) {
    score = now;
  } else if (weights > 0 && is_score(stored.score_max * before / weights)) {
    score = stored.score_max * now / weights;
  }
  return std::clamp(score, 0.0, stored.score_max);
}

}  // namespace

std::optional<EffectiveGrade> effective_grade(const std::vector<StoredGrade>& grades,
                                              const std::vector<SignedStatement>& statements) {
  if (grades.empty()) return std::nullopt;
  EffectiveGrade out{.stored = grades.back(), .grade = grades.back().grade};
  const std::vector<SignedStatement> standing = in_force(statements);
  out.overrides = newest_overrides(standing, out.stored.number);
  for (const SignedStatement& s : out.overrides) apply(s, out.grade);
  if (!out.overrides.empty()) {
    out.grade.score = score_of(out.stored.grade, out.grade);
    out.grade.passed = scenarios::reaches(out.grade.score, out.grade.pass_mark) && out.grade.critical.empty();
  }
  out.confirmation = confirmation_of(statements, standing, out.stored.number, out.grade);
  out.release = release_of(statements);
  return out;
}

Hash256 shown_hash(const Grade& grade) {
  Blake2b hash;
  hash.add_text("cusp shown result 1").add_u64(grade.passed ? 1 : 0).add_u64(grade.critical.size());
  for (const std::string& event : grade.critical) hash.add_text(event);
  for (const CriterionGrade& c : grade.criteria) hash.add_text(c.id).add_u64(std::bit_cast<std::uint64_t>(c.points));
  return hash.finish();
}

std::optional<SignedStatement> release_of(const std::vector<SignedStatement>& statements) {
  std::optional<SignedStatement> release;
  for (const SignedStatement& s : in_force(statements)) {
    if (s.kind == StatementKind::release) release = s;
  }
  return release;
}

}  // namespace cusp::storage
