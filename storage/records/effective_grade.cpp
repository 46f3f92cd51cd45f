#include "storage/records/effective_grade.h"

#include <algorithm>

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
  const double points = std::clamp(*s.points, 0.0, criterion->points_max);
  grade.score += points - criterion->points;
  criterion->points = points;
  if (points >= criterion->points_max) criterion->reason_code = "full";
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
    out.grade.score = std::clamp(out.grade.score, 0.0, out.grade.score_max);
    out.grade.passed = out.grade.score >= out.grade.pass_mark && out.grade.critical.empty();
  }
  const std::int64_t changed = last_change(statements);
  for (const SignedStatement& s : standing) {
    if (s.kind == StatementKind::confirmation && s.grade == out.stored.number && s.sequence > changed) out.confirmation = s;
  }
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
