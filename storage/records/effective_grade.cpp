#include "storage/records/effective_grade.h"

#include <algorithm>
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

/// Sequence of the last statement that changed the result: an override, or the withdrawal of one.
std::int64_t last_change(const std::vector<SignedStatement>& statements) {
  std::int64_t last = -1;
  for (const SignedStatement& s : statements) {
    const bool takes_back = s.kind == StatementKind::withdrawal && std::ranges::any_of(statements, [&](const SignedStatement& o) {
                              return o.id == s.withdraws && overrides(o);
                            });
    if (overrides(s) || takes_back) last = std::max(last, s.sequence);
  }
  return last;
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

double points_of(const Grade& grade) {
  double sum = 0;
  for (const CriterionGrade& c : grade.criteria) sum += c.points;
  return sum;
}

/// The criteria's sum, which no order of the overrides changes. Criteria of evaluator 2 have points of their weights and
/// another sum than the score: there the change of the sum counts.
double score_of(const Grade& stored, const Grade& changed) {
  const double before = points_of(stored), now = points_of(changed);
  const bool is_sum = std::abs(stored.score - before) <= scenarios::kScoreSlack;
  return std::clamp(is_sum ? now : stored.score + (now - before), 0.0, stored.score_max);
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
  const std::int64_t changed = last_change(statements);
  for (const SignedStatement& s : standing) {
    if (s.kind == StatementKind::confirmation && s.grade == out.stored.number && s.sequence > changed) out.confirmation = s;
  }
  out.release = release_of(statements);
  return out;
}

std::optional<SignedStatement> release_of(const std::vector<SignedStatement>& statements) {
  std::optional<SignedStatement> release;
  for (const SignedStatement& s : in_force(statements)) {
    if (s.kind == StatementKind::release) release = s;
  }
  return release;
}

}  // namespace cusp::storage
