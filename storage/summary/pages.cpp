#include "storage/summary/pages.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <queue>
#include <string>

#include "storage/base/small_letters.h"
#include "storage/repositories/session_state.h"
#include "storage/repositories/title.h"

namespace cusp::storage {
namespace {

constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();

/// Whether the query names one student. Of many students, each is asked for with the same statement.
enum class Whose : std::uint8_t { everybody, one_student };

std::optional<std::string_view> key_of_kind(const HistoryFilter& f) {
  return f.kind.transform([](SessionKind kind) { return key_of(kind); });
}

/// ?1 student, ?2 scenario, ?3 device class, ?4 passed, ?5 scripted, ?6 from, ?10 number of a version, ?11 kind.
std::string conditions(const HistoryFilter& f, Whose whose) {
  std::string sql = " WHERE listed = 1";
  if (whose == Whose::one_student) sql += " AND student = ?1";
  if (f.scenario) sql += " AND scenario = ?2";
  if (f.device_class) sql += " AND device_class = ?3";
  if (f.passed) sql += " AND passed = ?4";
  if (f.scripted) sql += " AND (operator <> 'person') = ?5";
  if (f.released_alone) sql += " AND released = 1";
  if (f.drilled_by == DrilledBy::students) sql += " AND student NOT IN (SELECT id FROM people WHERE role <> 'student')";
  if (f.version_number) sql += " AND version_number = ?10";
  if (f.kind) sql += " AND kind = ?11";
  return sql + " AND started_at >= ?6";
}

/// Without INDEXED BY the planner takes an index of a condition that most rows fit, and sorts them all.
const char* index_of(const HistoryFilter& f, Whose whose) {
  return whose == Whose::one_student ? "summaries_of_student" : f.scenario ? "summaries_of_scenario" : "summaries_by_time";
}

/// Besides the conditions: ?7 to ?9 the key that the rows come after, ?12 most rows.
std::string key_query(const HistoryFilter& f, Whose whose) {
  return "SELECT started_at, sequence, session FROM session_summaries INDEXED BY " + std::string(index_of(f, whose)) +
         conditions(f, whose) +
         " AND (started_at, sequence, session) < (?7, ?8, ?9) "
         "ORDER BY started_at DESC, sequence DESC, session DESC LIMIT ?12";
}

/// Asks one statement again and again.
class KeyQuery {
 public:
  KeyQuery(Database& db, const HistoryFilter& f, Whose whose) : f_{f}, statement_{db.prepare(key_query(f, whose))} {}
  Stored<std::vector<HistoryKey>> after(const HistoryKey& key, int limit, const std::optional<UserId>& student = {}) {
    statement_.bind(student, f_.scenario, f_.device_class, f_.passed, f_.scripted, f_.from_utc_us.value_or(-kEver),
                    key.started_utc_us, key.sequence, key.session, f_.version_number, key_of_kind(f_), limit);
    std::vector<HistoryKey> keys;
    while (true) {
      const auto more = statement_.step();
      if (!more) return std::unexpected(more.error());
      if (!*more) return keys;
      const Row row = statement_.row();
      keys.push_back({row.integer(0), row.integer(1), row.id<SessionId>(2)});
    }
  }

 private:
  const HistoryFilter& f_;
  Statement statement_;
};

/// Merges the students' lists: the newest key of each waits, and the newest of all goes first.
Stored<std::vector<HistoryKey>> merged(KeyQuery& query, const std::vector<UserId>& students, const HistoryKey& after,
                                       int limit) {
  std::priority_queue<std::pair<HistoryKey, UserId>> newest;
  const auto wait_for_next = [&](UserId student, const HistoryKey& before) -> Stored<void> {
    const auto key = query.after(before, 1, student);
    if (!key) return std::unexpected(key.error());
    if (!key->empty()) newest.emplace(key->front(), student);
    return {};
  };
  for (const UserId student : students) {
    if (auto done = wait_for_next(student, after); !done) return std::unexpected(done.error());
  }
  std::vector<HistoryKey> keys;
  while (!newest.empty() && std::ssize(keys) < limit) {
    const auto [key, student] = newest.top();
    newest.pop();
    keys.push_back(key);
    if (auto done = wait_for_next(student, key); !done) return std::unexpected(done.error());
  }
  return keys;
}

HistoryRow row_of(Row row) {
  HistoryRow h;
  h.session = row.id<SessionId>(0);
  h.student = row.id<UserId>(1);
  h.student_number = row.text(2);
  h.student_name = row.text(3);
  h.scenario = row.id<ScenarioId>(4);
  h.version = row.id<VersionId>(5);
  h.version_number = static_cast<int>(row.integer(6));
  h.scenario_key = row.text(7);
  h.title = title_from_json(row.text(8));
  h.kind = session_kind_from_key(row.text(9)).value_or(SessionKind::practice);
  h.operator_name = row.text(10);
  h.device = row.text(11);
  h.device_class = row.text(12);
  h.started_utc_us = row.integer(13);
  h.sequence = row.integer(14);
  h.elapsed_us = row.u64(15);
  h.state = session_state_from_key(row.text(16)).value_or(SessionState::closed);
  h.attempt = static_cast<int>(row.integer(17));
  h.score = row.maybe_real(18);
  h.score_max = row.maybe_real(19);
  h.pass_mark = row.maybe_real(20);
  if (!row.is_null(21)) h.passed = row.flag(21);
  h.engine_version = static_cast<int>(row.integer(23));
  if (!row.is_null(24)) h.assignment = row.id<AssignmentId>(24);
  h.released = row.flag(25);
  const auto critical = nlohmann::json::parse(row.text(22), nullptr, false);
  if (!critical.is_array()) return h;
  for (const auto& item : critical) {
    if (item.is_string()) h.critical.push_back(item.get<std::string>());
  }
  return h;
}

/// Whose name or number has the text. SQLite's lower() knows ASCII alone.
Stored<std::vector<UserId>> found_by(Database& db, const std::string& text) {
  const std::string wanted = small_letters(text);
  const auto people = db.all(
      "SELECT id, name, number FROM people WHERE guest = 0",
      [&wanted](Row row) {
        return std::pair{row.id<UserId>(0), small_letters(row.text(1)).contains(wanted) || small_letters(row.text(2)).contains(wanted)};
      });
  if (!people) return std::unexpected(people.error());
  std::vector<UserId> found;
  for (const auto& [id, fits] : *people)
    if (fits) found.push_back(id);
  return found;
}

}  // namespace

Stored<HistoryFilter> readable(const Actor& actor, const HistoryFilter& filter) {
  HistoryFilter narrowed = filter;
  if (may(actor.role, Action::see_all_results)) return narrowed;
  if (filter.student && *filter.student != actor.id) {
    return fail(StorageError::not_allowed, std::string(key_of(Action::see_all_results)));
  }
  narrowed.student = actor.id;
  // Who passed must not show in what a filter leaves.
  narrowed.released_alone = narrowed.released_alone || narrowed.passed.has_value();
  return narrowed;
}

Stored<std::vector<UserId>> staff_of(Database& db) {
  return db.all("SELECT id FROM people WHERE role <> 'student' AND guest = 0", [](Row row) { return row.id<UserId>(0); });
}

Stored<std::optional<std::vector<UserId>>> students_of(Database& db, const HistoryFilter& f) {
  std::optional<std::vector<UserId>> students;
  if (f.student) students = {*f.student};
  const auto narrow = [&](Stored<std::vector<UserId>> some) -> Stored<void> {
    if (!some) return std::unexpected(some.error());
    if (students) {
      std::erase_if(*students, [&](UserId id) { return std::ranges::find(*some, id) == some->end(); });
    } else {
      students = std::move(*some);
    }
    return {};
  };
  const auto id = [](Row row) { return row.id<UserId>(0); };
  if (!f.search.empty()) {
    if (auto done = narrow(found_by(db, f.search)); !done) return std::unexpected(done.error());
  }
  if (f.cohort) {
    auto done = narrow(db.all("SELECT student FROM cohort_students WHERE cohort = ?1", id, *f.cohort));
    if (!done) return std::unexpected(done.error());
  }
  if (f.drilled_by == DrilledBy::staff) {
    if (auto done = narrow(staff_of(db)); !done) return std::unexpected(done.error());
  }
  return students;
}

Stored<std::vector<HistoryKey>> keys_of_page(Database& db, const HistoryFilter& filter,
                                             const std::optional<HistoryKey>& after, int limit) {
  const auto students = students_of(db, filter);
  if (!students) return std::unexpected(students.error());
  // No key is as small as this one but those that started earlier.
  const HistoryKey end{filter.to_utc_us.value_or(kEver), std::numeric_limits<std::int64_t>::min(), SessionId{}};
  const HistoryKey before = after ? std::min(*after, end) : end;
  KeyQuery query(db, filter, *students ? Whose::one_student : Whose::everybody);
  if (!*students) return query.after(before, limit);
  if ((*students)->size() == 1) return query.after(before, limit, (*students)->front());
  return merged(query, **students, before, limit);
}

Stored<std::vector<HistoryRow>> rows_of(Database& db, const std::vector<SessionId>& sessions) {
  Statement one = db.prepare(
      "SELECT m.session, m.student, p.number, p.name, m.scenario, m.version, m.version_number, v.key, v.title, m.kind, "
      "m.operator, m.device, m.device_class, m.started_at, m.sequence, m.elapsed_us, m.state, m.attempt, m.score, "
      "m.score_max, m.pass_mark, m.passed, m.critical, m.engine_version, m.assignment, m.released FROM session_summaries m "
      "JOIN people p ON p.id = m.student JOIN scenario_versions v ON v.id = m.version WHERE m.session = ?1");
  std::vector<HistoryRow> rows;
  for (const SessionId session : sessions) {
    one.bind(session);
    const auto found = one.step();
    if (!found) return std::unexpected(found.error());
    if (*found) rows.push_back(row_of(one.row()));
  }
  return rows;
}

}  // namespace cusp::storage
