#include "ui/session/drawn_tooth.h"

#include <algorithm>
#include <utility>

#include "scenarios/checks/checks.h"
#include "scenarios/templates/other_tooth.h"
#include "storage/base/hash.h"

namespace cusp::ui {

namespace {

/// What the exercise lacks on every tooth is no reason to refuse one.
bool is_refused(const Finding& f) { return f.severity == Severity::error && f.code != "criterion_unmeasured"; }

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
  for (int draw = 0; draw < kMostDraws; ++draw) {
    auto drawn = on_other_tooth(exercise, drawn_seed(assignment, student, draw));
    if (!drawn) continue;
    const auto specimen = grow(*drawn);
    if (!specimen) return std::unexpected(specimen.error());
    if (std::ranges::none_of(check_exercise(*drawn, *specimen), is_refused)) return std::move(*drawn);
  }
  return session_fail(SessionError::no_tooth, "/specimen/seed");
}

}  // namespace cusp::ui
