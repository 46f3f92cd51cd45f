#include "storage/repositories/grades.h"

#include <nlohmann/json.hpp>

#include "storage/records/chain_writer.h"
#include "storage/records/session_summary.h"
#include "storage/records/thinned_traces.h"
#include "storage/repositories/session_state.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

using nlohmann::json;

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

}  // namespace

Stored<StoredGrade> Grades::save(SessionId session, const Grade& grade, const Hash256& rubric_hash,
                                 const std::optional<Actor>& grader) {
  if (grader) {
    if (auto allowed = require(*grader, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  }
  Transaction transaction(c_.db);
  require_state(transaction, session, Need::not_running);
  // Nobody could compute the new grade again.
  const auto thinned = thinned_at(c_.db, session);
  if (!thinned) transaction.refuse(thinned.error());
  if (thinned && *thinned) transaction.refuse(thinned_failure(**thinned));
  const TraceEnd end = trace_end(transaction, session);
  const std::uint64_t number = next_row(transaction, SessionTable::grades, session);
  const std::int64_t sequence = c_.next_sequence(transaction);
  ChainWriter chain(c_, transaction, session);
  transaction.run(
      "INSERT INTO grades (session, row, at, sequence, grader, score, score_max, pass_mark, passed, critical, "
      "rubric_hash, evaluator, engine_version, device_class, calibration) "
      "SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, engine_version, device_class, "
      "coalesce(json_extract(header, '$.calibration'), '') FROM sessions WHERE id = ?1",
      session, number, c_.clock(), sequence, grader ? grader->id : UserId{}, grade.score, grade.score_max,
      grade.pass_mark, grade.passed, dump(json(grade.critical)), rubric_hash, grade.evaluator);
  chain.add(SessionTable::grades, number, -1);
  std::uint64_t row = next_row(transaction, SessionTable::criteria, session);
  for (const CriterionGrade& c : grade.criteria) {
    std::optional<double> x, y, z;
    if (c.measure.where_mm) {
      x = c.measure.where_mm->x;
      y = c.measure.where_mm->y;
      z = c.measure.where_mm->z;
    }
    transaction.run(
        "INSERT INTO criteria (session, row, grade, id, metric, measured, value, uncertainty, unit, where_x_mm, "
        "where_y_mm, where_z_mm, band, points, points_max, reason_code, reason_args) "
        "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17)",
        session, row, number, c.id, c.measure.metric, c.measure.measured, c.measure.value, c.measure.uncertainty,
        c.measure.unit, x, y, z, c.band, c.points, c.points_max, c.reason_code, dump(json(c.reason_args)));
    chain.add(SessionTable::criteria, row++, -1);
  }
  chain.add(SessionTable::session_events, insert_event(c_, transaction, session, EventKind::graded, "", end),
            end.second());
  chain.finish();
  follow_event(transaction, session);
  log_session(c_, transaction, grader ? grader->id : UserId{}, session, key_of(EventKind::graded));
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  auto saved = newest(session);
  if (!saved) return std::unexpected(saved.error());
  return std::move(**saved);
}

Stored<std::vector<StoredGrade>> Grades::all(SessionId session) { return grades_of(c_.db, session); }

Stored<std::optional<StoredGrade>> Grades::newest(SessionId session) {
  auto grades = all(session);
  if (!grades) return std::unexpected(grades.error());
  if (grades->empty()) return std::optional<StoredGrade>{};
  return std::move(grades->back());
}

}  // namespace cusp::storage
