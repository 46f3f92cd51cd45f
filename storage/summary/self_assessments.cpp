// How students rate themselves: their own assessments beside what was measured.
#include "storage/summary/history.h"

namespace cusp::storage {

Stored<std::vector<RatedAttempt>> History::rated_attempts(const Actor& actor, UserId student, ScenarioId scenario,
                                                          const std::string& device_class) {
  if (auto allowed = require_reading(actor, student); !allowed) return std::unexpected(allowed.error());
  const Snapshot snapshot(c_.db);
  // An attempt may have been rated at two stations: it is one attempt.
  const auto rated = c_.db.all(
      "SELECT m.session, m.started_at, m.attempt FROM session_summaries m INDEXED BY graded_of_student "
      "WHERE m.student = ?1 AND m.listed = 1 AND m.scenario = ?2 AND m.device_class = ?3 AND m.score IS NOT NULL "
      "AND (m.released OR ?4) AND EXISTS (SELECT 1 FROM statements t INDEXED BY statements_of_session "
      "WHERE t.session = m.session AND t.kind = 'self_assessment') ORDER BY m.started_at, m.sequence",
      [](Row row) { return RatedAttempt{row.id<SessionId>(0), row.integer(1), static_cast<int>(row.integer(2)), {}}; },
      student, scenario, device_class, may(actor.role, Action::see_all_results));
  if (!rated) return std::unexpected(rated.error());
  std::vector<RatedAttempt> out;
  for (const RatedAttempt& one : *rated) {
    const auto statements = statements_of(c_.db, one.session);
    if (!statements) return std::unexpected(statements.error());
    const auto own = self_assessment_of(*statements);
    if (!own || own->skipped()) continue;
    const auto grades = grades_of(c_.db, one.session);
    if (!grades) return std::unexpected(grades.error());
    const auto counts = effective_grade(*grades, *statements);
    if (!counts) continue;
    out.push_back(one);
    out.back().points = rated_points(*own, counts->grade);
  }
  return out;
}

}  // namespace cusp::storage
