#include "tests/storage/old_attempts.h"

#include <algorithm>

#include "storage/records/session_tables.h"

namespace cusp::test {

SessionId OldAttempts::attempt(int days_ago, Upto upto, int seconds) {
  *now = kNow - days_ago * kDay_us;
  if (upto == Upto::graded && seconds == 0) {
    const SessionId session = complete_session(*store, student, version);
    *now = kNow;
    return session;
  }
  const SessionId session = must(store->sessions.start(student.actor(), new_session(student, version))).id;
  std::mt19937 noise(7);
  std::uint64_t tick = 0;
  for (int i = 0; i < std::max(seconds, 1); ++i) {
    RecordedSecond second = second_from(tick + 1, 1000);
    for (StepInput& input : second.inputs) input.x = static_cast<std::int32_t>(noise() % 1'000'000);
    must(store->traces.append(session, second));
    tick += 1000;
  }
  if (upto == Upto::interrupted) {
    must(store->sessions.interrupt(session, "recorder_full"));
  } else {
    must(store->sessions.finish(session, volume_after(tick), "student"));
  }
  if (upto == Upto::graded) must(store->grades.save(session, small_grade(), {}));
  *now = kNow;
  return session;
}

SessionId OldAttempts::assessment(int days_ago) {
  *now = kNow - days_ago * kDay_us;
  const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
  must(store->cohorts.add(instructor, cohort, student.id));
  const Assignment asked = must(store->assignments.create(
      instructor, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment}, "4711"));
  NewSession wanted = new_session(student, version);
  wanted.assignment = asked.id;
  wanted.start_code = "4711";
  const SessionId session = must(store->sessions.start(student.actor(), wanted)).id;
  must(store->traces.append(session, second_from(1)));
  must(store->sessions.finish(session, volume_after(12), "student"));
  must(store->grades.save(session, small_grade(), {}));
  *now = kNow;
  return session;
}

bool OldAttempts::is_thinned(SessionId session) {
  return must(store->database().first("SELECT 1 FROM thinned_traces WHERE session = ?1", [](Row) { return true; }, session)).has_value();
}

std::int64_t OldAttempts::count(const std::string& table) {
  return *must(store->database().first("SELECT count(*) FROM " + table, [](Row row) { return row.integer(0); }));
}

std::map<std::string, std::string> OldAttempts::rows_of(SessionId session) {
  std::map<std::string, std::string> out;
  for (const SessionTable table : kSessionTables) {
    Blake2b hash;
    must(store->database().all(select_rows(table), [&](Row row) {
      hash.add_hash(row.content_hash());
      return true;
    }, session));
    out[std::string(name_of(table))] = hex(hash.finish());
  }
  for (const char* table : {"session_chain", "session_heads", "session_summaries"}) {
    Blake2b hash;
    must(store->database().all(std::string("SELECT * FROM ") + table + " WHERE session = ?1", [&](Row row) {
      hash.add_hash(row.content_hash());
      return true;
    }, session));
    out[table] = hex(hash.finish());
  }
  return out;
}

void OldAttempts::put_back_before_grade(SessionId session) {
  Database& db = store->database();
  // An older head is one that the station signed; a grade of that day stays, so that the attempt is still a candidate.
  const auto end = *must(db.first("SELECT links, link FROM session_heads WHERE session = ?1",
                                  [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; }, session));
  const auto before = *must(db.first("SELECT link FROM session_chain WHERE session = ?1 AND position = ?2",
                                     [](Row row) { return row.hash(0); }, session, end.links - 2));
  must(db.run("DELETE FROM session_chain WHERE session = ?1 AND position = ?2", session, end.links - 1));
  must(db.run("DELETE FROM session_events WHERE session = ?1 AND kind = 'graded'", session));
  const ChainHead older{end.links - 1, before};
  must(db.run("UPDATE session_heads SET links = ?2, link = ?3, signature = ?4 WHERE session = ?1", session, older.links, older.link,
              store->context().key->sign_head(session.uuid, older)));
}

std::string OldAttempts::findings() {
  std::string out;
  for (const ChainFinding& f : must(verify_store(store->context())).findings) out += std::string(key_of(f.code)) + ' ' + f.table + ' ' + f.what + '\n';
  return out;
}

std::string OldAttempts::hex_of(SessionId session) {
  std::string out = session.text();
  std::erase(out, '-');
  return out;
}

}  // namespace cusp::test
