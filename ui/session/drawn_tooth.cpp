#include "ui/session/drawn_tooth.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/checks/checks.h"
#include "scenarios/templates/other_tooth.h"
#include "storage/base/hash.h"

namespace cusp::ui {

namespace {

bool is_of_rubric(const Finding& f) { return f.code == "criterion_unmeasured" || f.code == "target_fails"; }
bool is_refused(const Finding& f) { return f.severity == Severity::error && !is_of_rubric(f); }

/// Criteria that drop out of every grade on this tooth, and whether the target itself fails.
std::set<std::string> lacks_in(const std::vector<Finding>& findings) {
  std::set<std::string> out;
  for (const Finding& f : findings)
    if (is_of_rubric(f)) out.insert(f.code + ' ' + f.detail);
  return out;
}

}  // namespace

std::uint64_t drawn_seed(AssignmentId assignment, UserId student, int draw) {
  constexpr std::uint64_t kMost = (std::uint64_t{1} << 53) - 1;
  const Hash256 hash = Blake2b{}
                           .add_text("cusp tooth 1")
                           .add_uuid(assignment.uuid)
                           .add_uuid(student.uuid)
                           .add_u64(static_cast<std::uint64_t>(draw))
                           .finish();
  std::uint64_t seed = 0;
  for (std::size_t i = 0; i < sizeof seed; ++i) seed = seed << 8 | hash[i];
  return std::max<std::uint64_t>(1, seed & kMost);
}

Outcome<Scenario> draw_tooth(const Scenario& exercise, AssignmentId assignment, UserId student, const GrowSpecimen& grow) {
  if (const auto bound = bound_to_its_tooth(exercise)) return session_fail(SessionError::no_tooth, bound->where);
  std::optional<std::set<std::string>> lacks;  // what the exercise's own tooth lacks is no reason to refuse another
  for (int draw = 0; draw < kMostDraws; ++draw) {
    auto drawn = on_other_tooth(exercise, drawn_seed(assignment, student, draw));
    if (!drawn) continue;
    const auto specimen = grow(*drawn);
    if (!specimen) return std::unexpected(specimen.error());
    const std::vector<Finding> findings = check_exercise(*drawn, *specimen);
    if (std::ranges::any_of(findings, is_refused)) continue;
    const std::set<std::string> here = lacks_in(findings);
    if (here.empty()) return std::move(*drawn);
    if (!lacks) {
      const auto own = grow(exercise);
      if (!own) return std::unexpected(own.error());
      lacks = lacks_in(check_attempts(exercise, *own));
    }
    if (std::ranges::includes(*lacks, here)) return std::move(*drawn);
  }
  return session_fail(SessionError::no_tooth, "/specimen/seed");
}

}  // namespace cusp::ui
