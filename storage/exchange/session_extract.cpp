#include "storage/exchange/session_extract.h"

#include <array>

#include "storage/repositories/assignments.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

/// Of the attached database `source` to the new one, in an order that keeps every reference whole. ?1: the session.
constexpr std::array kCopies = {
    "INSERT INTO station_keys SELECT * FROM source.station_keys WHERE id IN (SELECT key FROM source.session_heads WHERE session = ?1 "
    "UNION SELECT key FROM source.statements WHERE session = ?1)",
    "INSERT INTO people SELECT id, number, name, role, '', '', 1, guest, 0, 0, created_at FROM source.people WHERE id IN ("
    "SELECT student FROM source.sessions WHERE id = ?1 UNION SELECT grader FROM source.grades WHERE session = ?1 "
    "UNION SELECT d.author FROM source.adjustments d JOIN source.sessions s ON s.assignment = d.assignment AND s.student = d.student WHERE s.id = ?1 "
    "UNION SELECT author FROM source.statements WHERE session = ?1 UNION SELECT author FROM source.comments WHERE session = ?1 "
    "UNION SELECT a.author FROM source.assignments a JOIN source.sessions s ON s.assignment = a.id WHERE s.id = ?1 "
    "UNION SELECT v.author FROM source.scenario_versions v JOIN source.sessions s ON s.version = v.id WHERE s.id = ?1)",
    "INSERT INTO cohorts SELECT * FROM source.cohorts WHERE id IN (SELECT a.cohort FROM source.assignments a "
    "JOIN source.sessions s ON s.assignment = a.id WHERE s.id = ?1)",
    "INSERT INTO blobs SELECT * FROM source.blobs WHERE hash IN (SELECT specimen_blob FROM source.sessions WHERE id = ?1 "
    "UNION SELECT f.blob FROM source.version_files f JOIN source.sessions s ON s.version = f.version WHERE s.id = ?1)",
    "INSERT INTO scenario_versions SELECT * FROM source.scenario_versions WHERE id = (SELECT version FROM source.sessions WHERE id = ?1)",
    "INSERT INTO version_files SELECT * FROM source.version_files WHERE version = (SELECT version FROM source.sessions WHERE id = ?1)",
    "INSERT INTO assignments SELECT * FROM source.assignments WHERE id = (SELECT assignment FROM source.sessions WHERE id = ?1)",
    "INSERT INTO sessions SELECT * FROM source.sessions WHERE id = ?1",
    "INSERT INTO adjustments SELECT d.* FROM source.adjustments d JOIN source.sessions s ON s.assignment = d.assignment AND s.student = d.student "
    "WHERE s.id = ?1",
    "INSERT INTO session_events SELECT * FROM source.session_events WHERE session = ?1",
    "INSERT INTO trace_chunks SELECT * FROM source.trace_chunks WHERE session = ?1",
    "INSERT INTO key_states SELECT * FROM source.key_states WHERE session = ?1",
    "INSERT INTO metrics SELECT * FROM source.metrics WHERE session = ?1",
    "INSERT INTO removed_tissues SELECT * FROM source.removed_tissues WHERE session = ?1",
    "INSERT INTO final_volumes SELECT * FROM source.final_volumes WHERE session = ?1",
    "INSERT INTO grades SELECT * FROM source.grades WHERE session = ?1",
    "INSERT INTO criteria SELECT * FROM source.criteria WHERE session = ?1",
    "INSERT INTO session_chain SELECT * FROM source.session_chain WHERE session = ?1",
    "INSERT INTO session_heads SELECT * FROM source.session_heads WHERE session = ?1",
    "INSERT INTO comments SELECT * FROM source.comments WHERE session = ?1",
    "INSERT INTO statements SELECT * FROM source.statements WHERE session = ?1 ORDER BY sequence",
    "INSERT INTO statement_texts SELECT t.* FROM source.statement_texts t JOIN source.statements s ON s.id = t.statement WHERE s.session = ?1",
    "INSERT INTO session_summaries SELECT * FROM source.session_summaries WHERE session = ?1",
};

void hide_name(Transaction& transaction, const Session& session) {
  const std::string number = session.assignment ? candidate_number(*session.assignment, session.student) : session.student.text();
  transaction.run("UPDATE people SET number = ?2, name = ?2 WHERE id = ?1", session.student, number);
}

Stored<void> copy_rows(Database& to, const Session& session, StudentNamed named) {
  Transaction transaction(to);
  transaction.run("INSERT INTO station SELECT * FROM source.station");
  for (const char* copy : kCopies) transaction.run(copy, session.id);
  if (named == StudentNamed::by_candidate_number) hide_name(transaction, session);
  return transaction.commit();
}

/// In the older journal mode the file needs no log beside it.
Stored<void> fill(const fs::path& file, const fs::path& from, const Session& session, StudentNamed named) {
  auto to = Database::open(file);
  if (!to) return std::unexpected(to.error());
  if (auto done = to->run("ATTACH ?1 AS source", from.string()); !done) return done;
  if (auto done = copy_rows(*to, session, named); !done) return done;
  if (auto done = to->run("DETACH source"); !done) return done;
  return to->run("PRAGMA journal_mode = DELETE");
}

Stored<Session> exportable(StorageContext& context, const Actor& actor, SessionId id) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  Sessions sessions(context);
  const auto session = sessions.find(id);
  if (!session) return session;
  const auto state = sessions.state(id);
  if (!state) return std::unexpected(state.error());
  if (*state == SessionState::running) return fail(StorageError::wrong_state, "session");
  return session;
}

}  // namespace

Stored<void> extract_session(StorageContext& context, const Actor& actor, SessionId id, StudentNamed named, const fs::path& file) {
  const auto session = exportable(context, actor, id);
  if (!session) return std::unexpected(session.error());
  std::error_code error;
  if (fs::exists(file, error)) return fail(StorageError::duplicate, file.string());
  auto done = fill(file, context.db.file(), *session, named);
  if (!done) {
    for (const char* beside : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + beside, error);
  }
  return done;
}

Stored<std::vector<AuditEntry>> log_about(StorageContext& context, const Actor& actor, SessionId session) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  return context.db.all(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE subject IN (SELECT ?1 "
      "UNION SELECT id FROM statements WHERE session = ?1 UNION SELECT version FROM sessions WHERE id = ?1 "
      "UNION SELECT assignment FROM sessions WHERE id = ?1 AND assignment IS NOT NULL) ORDER BY number",
      [](Row row) {
        return AuditEntry{row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3), row.text(4), row.uuid(5), row.text(6)};
      },
      session);
}

}  // namespace cusp::storage
