#include "storage/exchange/session_extract.h"

#include "storage/exchange/session_copies.h"
#include "storage/records/thinned_traces.h"
#include "storage/repositories/assignments.h"
#include "storage/repositories/sessions.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

void hide_name(Transaction& transaction, const Session& session) {
  const std::string number = session.assignment ? candidate_number(*session.assignment, session.student) : session.student.text();
  transaction.run("UPDATE people SET number = ?2, name = ?2 WHERE id = ?1", session.student, number);
}

Stored<void> copy_rows(Database& to, const Session& session, StudentNamed named) {
  Transaction transaction(to);
  transaction.run("INSERT INTO station SELECT * FROM source.station");
  if (!copy_session(transaction, session.id)) transaction.refuse({StorageError::wrong_state, "session"});
  if (named == StudentNamed::by_candidate_number) hide_name(transaction, session);
  return transaction.commit();
}

Stored<Session> exportable(StorageContext& context, const Actor& actor, SessionId id) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  Sessions sessions(context);
  const auto session = sessions.find(id);
  if (!session) return session;
  const auto state = sessions.state(id);
  if (!state) return std::unexpected(state.error());
  if (*state == SessionState::running) return fail(StorageError::wrong_state, "session");
  const auto thinned = thinned_at(context.db, id);
  if (!thinned) return std::unexpected(thinned.error());
  if (*thinned) return std::unexpected(thinned_failure(**thinned));
  return session;
}

}  // namespace

Stored<void> extract_session(StorageContext& context, const Actor& actor, SessionId id, StudentNamed named, const fs::path& file) {
  const auto session = exportable(context, actor, id);
  if (!session) return std::unexpected(session.error());
  if (!context.key) return std::unexpected(context.db.unwritable());
  return make_copy(file, context.db.file(), [&](Database& to) { return copy_rows(to, *session, named); });
}

Stored<std::vector<AuditEntry>> log_about(StorageContext& context, const Actor& actor, SessionId session) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  return context.db.all(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log INDEXED BY audit_by_subject "
      "WHERE action <> 'session_sealed' AND subject IN (SELECT ?1 UNION SELECT id FROM statements WHERE session = ?1 "
      "UNION SELECT version FROM sessions WHERE id = ?1 UNION SELECT assignment FROM sessions WHERE id = ?1 AND assignment IS NOT NULL) "
      "UNION ALL SELECT number, at, sequence, actor, action, subject, detail FROM audit_log INDEXED BY seals_of_session "
      "WHERE action = 'session_sealed' AND substr(subject, 1, 6) = substr(?1, 1, 6) AND subject = ?1 ORDER BY number",
      [](Row row) {
        return AuditEntry{row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3), row.text(4), row.uuid(5), row.text(6)};
      },
      session);
}

}  // namespace cusp::storage
