#include "storage/repositories/sessions.h"

#include "storage/records/chain_writer.h"
#include "storage/records/session_summary.h"
#include "storage/base/process.h"
#include "storage/repositories/assignments.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/device_tests.h"
#include "storage/repositories/key_list.h"
#include "storage/repositories/session_header.h"
#include "storage/repositories/session_state.h"
#include "storage/records/sealing.h"
#include "storage/records/trace_codec.h"

namespace cusp::storage {
namespace {

/// What an assignment asks of an attempt that begins now.
struct AssignedRules {
  SessionKind kind = SessionKind::practice;
  VersionId version;
  std::optional<std::int64_t> opens_utc_us, due_utc_us, attempts_allowed;
  std::string start_code;
  std::int64_t attempts = 0;  // of this student so far
  Adjustment adjustment;
  std::string device_classes;
  std::optional<std::int64_t> self_test_days;
  bool drawn_tooth = false;
  bool withdrawn = false;
};

std::optional<AssignedRules> assigned_rules(Transaction& transaction, AssignmentId assignment, UserId student) {
  return transaction.first(
      "SELECT a.kind, a.version, a.opens_at, a.due_at, a.goes_allowed, coalesce(x.start_code, ''), "
      "(SELECT count(*) FROM session_summaries INDEXED BY summaries_of_assignment WHERE assignment = a.id AND student = ?2), "
      "coalesce(d.extra_time_percent, 0), coalesce(d.large_text, 0), coalesce(a.device_classes, ''), a.self_test_days, coalesce(a.drawn_tooth, 0), "
      "EXISTS (SELECT 1 FROM assignment_withdrawals w WHERE w.assignment = a.id) "
      "FROM assignments a JOIN cohort_students m ON m.cohort = a.cohort AND m.student = ?2 "
      "LEFT JOIN adjustments d ON d.id = (SELECT id FROM adjustments INDEXED BY adjustments_of_assignment WHERE assignment = a.id "
      "AND student = ?2 ORDER BY at DESC, sequence DESC, id DESC LIMIT 1) "
      "LEFT JOIN assessments x ON x.assignment = a.id WHERE a.id = ?1 "
      "AND NOT EXISTS (SELECT 1 FROM referred r WHERE r.id = a.id AND r.here = 0)",
      [](Row row) {
        return AssignedRules{session_kind_from_key(row.text(0)).value_or(SessionKind::practice),
                             row.id<VersionId>(1),
                             row.maybe_integer(2),
                             row.maybe_integer(3),
                             row.maybe_integer(4),
                             row.text(5),
                             row.integer(6),
                             {static_cast<int>(row.integer(7)), row.flag(8)},
                             row.text(9),
                             row.maybe_integer(10),
                             row.flag(11),
                             row.flag(12)};
      },
      assignment, student);
}

/// What the session then is.
struct Admission {
  SessionKind kind = SessionKind::practice;
  Adjustment adjustment{};
  bool drawn_tooth = false;
};

void require_self_test(Transaction& transaction, const std::string& device_class, int days, std::int64_t now) {
  const auto newest = newest_device_test(transaction.database(), device_class, now);
  if (!newest) return transaction.refuse(newest.error());
  if (!is_recent(*newest, days, now)) transaction.refuse({StorageError::self_test_due, device_class, std::to_string(days)});
}

/// Refuses the transaction if the assignment does not admit the session.
Admission admission(Transaction& transaction, const NewSession& wanted, std::int64_t now) {
  const auto refuse = [&](StorageError code, const char* where) {
    transaction.refuse({code, where, wanted.assignment ? wanted.assignment->text() : std::string()});
    return Admission{wanted.kind};
  };
  if (!wanted.assignment) {
    return wanted.kind == SessionKind::assessment ? refuse(StorageError::not_allowed, "assignment") : Admission{wanted.kind};
  }
  const auto rules = assigned_rules(transaction, *wanted.assignment, wanted.student);
  if (!rules || rules->version != wanted.version) return refuse(StorageError::not_allowed, "assignment");
  if (rules->start_code != wanted.start_code) return refuse(StorageError::not_allowed, "start_code");
  if (rules->withdrawn) return refuse(StorageError::wrong_state, "withdrawn");
  if (rules->opens_utc_us && now < *rules->opens_utc_us) return refuse(StorageError::wrong_state, "not_open");
  if (rules->due_utc_us && now >= *rules->due_utc_us) return refuse(StorageError::wrong_state, "past_due");
  if (rules->attempts_allowed && rules->attempts >= *rules->attempts_allowed) {
    return refuse(StorageError::wrong_state, "attempts_used");
  }
  const std::string& device_class = wanted.header.device.device_class;
  if (!admits(split_keys(rules->device_classes), device_class)) {
    transaction.refuse({StorageError::other_device, device_class, rules->device_classes});
  }
  if (rules->self_test_days) require_self_test(transaction, device_class, static_cast<int>(*rules->self_test_days), now);
  return {rules->kind, rules->adjustment, rules->drawn_tooth};
}

/// The student whose attempt goes on has signed in, maybe before an administrator switched the account off or erased it.
void require_enabled(Transaction& transaction, SessionId session) {
  const auto disabled = transaction.first("SELECT p.disabled FROM sessions s JOIN people p ON p.id = s.student WHERE s.id = ?1",
                                          [](Row row) { return row.flag(0); }, session);
  if (disabled.value_or(false)) transaction.refuse({StorageError::disabled, "actor"});
}

}  // namespace

Stored<Session> Sessions::start(const Actor& actor, const NewSession& wanted) {
  if (auto allowed = require(actor, Action::drill); !allowed) return std::unexpected(allowed.error());
  if (wanted.student != actor.id) return fail(StorageError::not_allowed, std::string(key_of(Action::drill)));
  SessionHeader h = wanted.header;
  // JSON cannot hold a number that is not finite: nobody could open the session.
  if (!header_from_json(header_to_json(h))) return fail(StorageError::bad_value, "header");
  const SessionId id = SessionId::make();
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::drill);
  const auto guest = transaction.first(
      "SELECT guest FROM people WHERE id = ?1 AND disabled = 0", [](Row row) { return row.flag(0); }, wanted.student);
  if (!guest) transaction.refuse({StorageError::not_found, "people", wanted.student.text()});
  const auto hashes = transaction.first(
      "SELECT content_hash, json FROM scenario_versions WHERE id = ?1",
      [](Row row) {
        return std::pair{row.hash(0), blake2b_256(row.bytes(1))};
      },
      wanted.version);
  if (!hashes) transaction.refuse({StorageError::not_found, "scenario_versions", wanted.version.text()});
  const std::int64_t now = c_.clock();
  const Admission admitted = admission(transaction, wanted, now);
  if (admitted.drawn_tooth == h.exercise.empty()) transaction.refuse({StorageError::bad_value, "exercise"});
  if (!transaction.ok()) return std::unexpected(transaction.commit().error());

  const SessionKind kind = *guest ? SessionKind::try_it : admitted.kind;
  h.extra_time_percent = admitted.adjustment.extra_time_percent;
  h.large_text = admitted.adjustment.large_text;
  const std::int64_t sequence = c_.next_sequence(transaction);
  transaction.run(
      "INSERT INTO sessions (id, station, student, version, version_hash, json_hash, kind, assignment, hand, device, "
      "device_class, engine_version, specimen_blob, header, started_at, sequence) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16)",
      id, c_.station, wanted.student, wanted.version, hashes->first, hashes->second, key_of(kind), wanted.assignment,
      wanted.operator_name, h.device.name, h.device.device_class, h.engine_version, h.specimen_blob, keep_header(transaction, h), now,
      sequence);
  const std::uint64_t event = insert_event(c_, transaction, id, EventKind::started, wanted.operator_name, {});
  ChainWriter chain(c_, transaction, id);
  chain.add(SessionTable::sessions, 0, -1);
  chain.add(SessionTable::session_events, event, 0);
  chain.finish();
  add_summary(transaction, id);
  log_session(c_, transaction, actor.id, id, key_of(EventKind::started));
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return find(id);
}

Stored<void> Sessions::admit(const Actor& actor, const NewSession& wanted) {
  if (auto allowed = require(actor, Action::drill); !allowed) return allowed;
  if (wanted.student != actor.id) return fail(StorageError::not_allowed, std::string(key_of(Action::drill)));
  Transaction transaction(c_.db);
  admission(transaction, wanted, c_.clock());
  return transaction.commit();
}

Stored<void> Sessions::add_event(SessionId session, EventKind kind, const std::string& reason,
                                 const FinalVolume* volume) {
  Transaction transaction(c_.db);
  require_state(transaction, session,
                kind == EventKind::resumed  ? Need::interrupted
                : kind == EventKind::closed ? Need::not_running
                                            : Need::running);
  if (kind == EventKind::resumed) require_enabled(transaction, session);
  if (kind == EventKind::resumed && keeps_volume(transaction, session)) {
    transaction.refuse({StorageError::wrong_state, "volume_kept", session.text()});
  }
  const TraceEnd end = trace_end(transaction, session);
  ChainWriter chain(c_, transaction, session);
  if (volume != nullptr) {
    if (volume->tick != end.tick) transaction.refuse({StorageError::wrong_state, "final_volumes", session.text()});
    insert_final_volume(transaction, session, *volume);
    chain.add(SessionTable::final_volumes, 0, end.second());
  }
  chain.add(SessionTable::session_events, insert_event(c_, transaction, session, kind, reason, end), end.second());
  chain.finish();
  follow_event(transaction, session);
  log_session(c_, transaction, UserId{}, session, key_of(kind));
  return commit_sealed(c_, transaction);
}

Stored<void> Sessions::resume(SessionId session, const std::string& reason) {
  return add_event(session, EventKind::resumed, reason, nullptr);
}
Stored<void> Sessions::interrupt(SessionId session, const std::string& reason) {
  return add_event(session, EventKind::interrupted, reason, nullptr);
}
Stored<void> Sessions::finish(SessionId session, const FinalVolume& volume, const std::string& reason) {
  return add_event(session, EventKind::finished, reason, &volume);
}
Stored<void> Sessions::close(SessionId session, const std::string& reason) {
  return add_event(session, EventKind::closed, reason, nullptr);
}

Stored<std::vector<SessionId>> Sessions::mark_interrupted() {
  const auto running = c_.db.all(
      "SELECT m.session, e.process FROM session_summaries m INDEXED BY running_summaries "
      "JOIN sessions s ON s.id = m.session JOIN session_events e ON e.session = m.session "
      "AND e.row = (SELECT max(row) FROM session_events WHERE session = m.session) "
      "WHERE m.state = 'running' AND s.station = ?1 AND e.kind IN ('started', 'resumed')",
      [](Row row) { return std::pair{row.id<SessionId>(0), row.text(1)}; }, c_.station);
  if (!running) return std::unexpected(running.error());
  std::vector<SessionId> marked;
  for (const auto& [session, process] : *running) {
    if (process_runs(process, c_.lock_file())) continue;
    auto done = interrupt(session, "process_gone");
    // Another process may have marked it first. A session with damaged rows takes no event: the verifier reports it, and
    // the other sessions stay usable.
    const bool passed_over =
        !done && (done.error().code == StorageError::wrong_state || done.error().code == StorageError::duplicate ||
                  done.error().code == StorageError::not_found || done.error().code == StorageError::bad_value);
    if (!done && !passed_over) return std::unexpected(done.error());
    if (done) marked.push_back(session);
  }
  return marked;
}

Stored<Session> Sessions::find(SessionId id) {
  struct Found {
    Session session;
    std::optional<SessionKind> kind;
    std::string header;
  };
  const auto found = c_.db.first(
      "SELECT id, student, version, version_hash, kind, assignment, hand, started_at, header FROM sessions WHERE id = "
      "?1",
      [](Row row) {
        Found f;
        f.session.id = row.id<SessionId>(0);
        f.session.student = row.id<UserId>(1);
        f.session.version = row.id<VersionId>(2);
        f.session.version_hash = row.hash(3);
        f.kind = session_kind_from_key(row.text(4));
        if (!row.is_null(5)) f.session.assignment = row.id<AssignmentId>(5);
        f.session.operator_name = row.text(6);
        f.session.started_utc_us = row.integer(7);
        f.header = row.text(8);
        return f;
      },
      id);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "sessions", id.text());
  auto header = read_header(c_.db, (*found)->header);
  if (!(*found)->kind || (!header && header.error().code == StorageError::corrupt)) return fail(StorageError::corrupt, "sessions", id.text());
  if (!header) return std::unexpected(header.error());
  Session session = (*found)->session;
  session.kind = *(*found)->kind;
  session.header = std::move(*header);
  return session;
}

Stored<std::vector<SessionEvent>> Sessions::events(SessionId session) {
  return c_.db.all(
      "SELECT kind, at, sequence, tick, reason FROM session_events WHERE session = ?1 ORDER BY row",
      [](Row row) {
        // A kind that the schema does not admit is damage: the verifier reports it, and the session counts as closed.
        return SessionEvent{event_kind_from_key(row.text(0)).value_or(EventKind::closed), row.integer(1),
                            row.integer(2), row.u64(3), row.text(4)};
      },
      session);
}

Stored<SessionState> Sessions::state(SessionId session) {
  const auto all = events(session);
  if (!all) return std::unexpected(all.error());
  if (all->empty()) return fail(StorageError::not_found, "sessions", session.text());
  return state_after(*all);
}

}  // namespace cusp::storage
