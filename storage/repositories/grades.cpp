#include "storage/repositories/grades.h"

#include <nlohmann/json.hpp>

#include "storage/records/chain_writer.h"
#include "storage/records/session_summary.h"
#include "storage/records/thinned_traces.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/session_header.h"
#include "storage/repositories/session_state.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

using nlohmann::json;

/// The calibration of the session's device.
std::string calibration_of(Transaction& transaction, SessionId session) {
  const auto column = transaction.first("SELECT header FROM sessions WHERE id = ?1", [](Row row) { return row.text(0); }, session);
  if (!column || !transaction.ok()) return {};
  const auto header = read_header(transaction.database(), *column);
  if (header) return header->calibration;
  transaction.refuse(header.error());
  return {};
}

/// Links the volume, unless the session has one. Refuses the grade of a tooth that was drilled on meanwhile.
void keep_volume(Transaction& transaction, ChainWriter& chain, SessionId session, const FinalVolume& volume, const TraceEnd& end) {
  if (!transaction.ok()) return;
  if (volume.tick != end.tick) return transaction.refuse({StorageError::wrong_state, "final_volumes", session.text()});
  if (keeps_volume(transaction, session)) return;
  insert_final_volume(transaction, session, volume);
  chain.add(SessionTable::final_volumes, 0, end.second());
}

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

}  // namespace

Stored<StoredGrade> Grades::save(SessionId session, const Grade& grade, const Hash256& rubric_hash,
                                 const std::optional<Actor>& grader, const FinalVolume* volume,
                                 const std::optional<std::size_t>& before) {
  if (grader) {
    if (auto allowed = require(*grader, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  }
  Transaction transaction(c_.db);
  if (grader) require_now(transaction, grader->id, Action::grade_again);
  require_state(transaction, session, Need::not_running);
  // Nobody could compute the new grade again.
  const auto thinned = thinned_at(c_.db, session);
  if (!thinned) transaction.refuse(thinned.error());
  if (thinned && *thinned) transaction.refuse(thinned_failure(**thinned));
  const TraceEnd end = trace_end(transaction, session);
  const std::uint64_t number = next_row(transaction, SessionTable::grades, session);
  if (before && *before != number) transaction.refuse({StorageError::wrong_state, "graded", session.text()});
  const std::int64_t sequence = c_.next_sequence(transaction);
  ChainWriter chain(c_, transaction, session);
  if (volume != nullptr) keep_volume(transaction, chain, session, *volume, end);
  transaction.run(
      "INSERT INTO grades (session, row, at, sequence, grader, score, score_max, pass_mark, passed, critical, "
      "rubric_hash, evaluator, engine_version, device_class, calibration) "
      "SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, engine_version, device_class, ?13 "
      "FROM sessions WHERE id = ?1",
      session, number, c_.clock(), sequence, grader ? grader->id : UserId{}, grade.score, grade.score_max,
      grade.pass_mark, grade.passed, dump(json(grade.critical)), rubric_hash, grade.evaluator,
      calibration_of(transaction, session));
  chain.add(SessionTable::grades, number, -1);
  transaction.run("INSERT INTO graded_criteria (session, row, packed) VALUES (?1, ?2, ?3)", session, number, packed_criteria(grade.criteria));
  chain.add(SessionTable::graded_criteria, number, -1);
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
