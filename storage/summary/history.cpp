#include "storage/summary/history.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "storage/repositories/title.h"
#include "storage/summary/pages.h"

namespace cusp::storage {
namespace {

constexpr int kRowsAtOnce = 1000;  // of list(): one page of many

SessionId session_of(Row row) { return row.id<SessionId>(0); }

bool sees_withheld(const Actor& actor) noexcept { return may(actor.role, Action::see_all_results); }

/// Withholds what is not released from who may see own results alone.
void withhold(const Actor& actor, std::vector<HistoryRow>& rows) {
  if (sees_withheld(actor)) return;
  for (HistoryRow& row : rows) {
    if (row.released) continue;
    row.score = row.score_max = row.pass_mark = std::nullopt;
    row.passed = std::nullopt;
    row.critical.clear();
    if (row.state == SessionState::graded) row.state = SessionState::finished;
  }
}

Stored<std::vector<HistoryRow>> readable_rows(Database& db, const Actor& actor, const std::vector<SessionId>& sessions) {
  auto rows = rows_of(db, sessions);
  if (rows) withhold(actor, *rows);
  return rows;
}

/// One session of any kind.
Stored<HistoryRow> one(Database& db, const Actor& actor, SessionId session) {
  const auto owner =
      db.first("SELECT student FROM sessions WHERE id = ?1", [](Row row) { return row.id<UserId>(0); }, session);
  if (!owner) return std::unexpected(owner.error());
  if (!*owner) return fail(StorageError::not_found, "sessions", session.text());
  if (auto allowed = require_reading(actor, **owner); !allowed) return std::unexpected(allowed.error());
  auto found = readable_rows(db, actor, {session});
  if (!found) return std::unexpected(found.error());
  if (found->empty()) return fail(StorageError::not_found, "session_summaries", session.text());
  return std::move(found->front());
}

/// The scenarios and device classes of one student's listed sessions, or of all: each is found by the one before it.
template <class Value>
Stored<std::vector<Value>> each_value(Database& db, const char* next, const char* first,
                                      const std::function<Value(Row)>& read) {
  std::vector<Value> values;
  const auto take = [&](Row row) {
    if (row.is_null(0)) return false;
    values.push_back(read(row));
    return true;
  };
  auto found = db.first(first, take);
  while (found && found->value_or(false)) {
    const Value before = values.back();
    found = db.first(next, take, before);
  }
  if (!found) return std::unexpected(found.error());
  return values;
}

struct Graded {
  ScenarioId scenario;
  HistoryKey key;
  double score = 0;
  bool passed = false;
};

}  // namespace

Stored<HistoryPage> History::page(const Actor& actor, const HistoryFilter& filter,
                                  const std::optional<HistoryKey>& after, int limit) {
  const auto narrowed = readable(actor, filter);
  if (!narrowed) return std::unexpected(narrowed.error());
  const Snapshot snapshot(c_.db);
  const auto keys = keys_of_page(c_.db, *narrowed, after, limit);
  if (!keys) return std::unexpected(keys.error());
  std::vector<SessionId> sessions;
  for (const HistoryKey& key : *keys) sessions.push_back(key.session);
  auto rows = readable_rows(c_.db, actor, sessions);
  if (!rows) return std::unexpected(rows.error());
  HistoryPage page{std::move(*rows), std::nullopt};
  if (std::ssize(*keys) == limit) page.after = keys->back();
  return page;
}

Stored<std::vector<HistoryRow>> History::list(const Actor& actor, const HistoryFilter& filter) {
  std::vector<HistoryRow> rows;
  std::optional<HistoryKey> after;
  while (true) {
    const int left = filter.limit < 0 ? kRowsAtOnce : filter.limit - static_cast<int>(rows.size());
    if (left <= 0) return rows;
    auto more = page(actor, filter, after, std::min(left, kRowsAtOnce));
    if (!more) return std::unexpected(more.error());
    std::ranges::move(more->rows, std::back_inserter(rows));
    if (!more->after) return rows;
    after = more->after;
  }
}

Stored<std::size_t> History::count(const Actor& actor, const HistoryFilter& filter) {
  const auto narrowed = readable(actor, filter);
  if (!narrowed) return std::unexpected(narrowed.error());
  const auto keys = keys_of_page(c_.db, *narrowed, std::nullopt, filter.limit < 0 ? std::numeric_limits<int>::max() : filter.limit);
  if (!keys) return std::unexpected(keys.error());
  return keys->size();
}

Stored<Figures> History::figures(const Actor& actor, const HistoryFilter& filter) {
  auto narrowed = readable(actor, filter);
  if (!narrowed) return std::unexpected(narrowed.error());
  narrowed->released_alone = narrowed->released_alone || !sees_withheld(actor);
  return read_figures(c_.db, *narrowed);
}

Stored<std::vector<PractisedScenario>> History::scenarios(const Actor& actor, const std::optional<UserId>& student) {
  const auto narrowed = readable(actor, {.student = student});
  if (!narrowed) return std::unexpected(narrowed.error());
  const auto id = [](Row row) { return row.id<ScenarioId>(0); };
  const auto ids =
      narrowed->student
          ? c_.db.all("SELECT DISTINCT scenario FROM session_summaries INDEXED BY summaries_of_student "
                      "WHERE student = ?1 AND listed = 1",
                      id, *narrowed->student)
          : each_value<ScenarioId>(c_.db,
                                   "SELECT min(scenario) FROM session_summaries INDEXED BY summaries_of_scenario "
                                   "WHERE listed = 1 AND scenario > ?1",
                                   "SELECT min(scenario) FROM session_summaries INDEXED BY summaries_of_scenario "
                                   "WHERE listed = 1",
                                   id);
  if (!ids) return std::unexpected(ids.error());
  std::vector<PractisedScenario> found;
  for (const ScenarioId scenario : *ids) {
    const auto title = c_.db.first(
        "SELECT title FROM scenario_versions WHERE scenario = ?1 ORDER BY number DESC LIMIT 1",
        [](Row row) { return row.text(0); }, scenario);
    if (!title) return std::unexpected(title.error());
    found.push_back({scenario, *title ? title_from_json(**title) : LocalText{}});
  }
  return found;
}

Stored<std::vector<std::string>> History::device_classes(const Actor& actor) {
  if (auto allowed = require(actor, Action::see_all_results); !allowed) return std::unexpected(allowed.error());
  return each_value<std::string>(c_.db,
                                 "SELECT min(device_class) FROM session_summaries "
                                 "INDEXED BY summaries_of_device_class WHERE listed = 1 AND device_class > ?1",
                                 "SELECT min(device_class) FROM session_summaries "
                                 "INDEXED BY summaries_of_device_class WHERE listed = 1",
                                 [](Row row) { return row.text(0); });
}

Stored<SessionDetails> History::details(const Actor& actor, SessionId id) {
  const Snapshot snapshot(c_.db);
  const auto row = one(c_.db, actor, id);
  if (!row) return std::unexpected(row.error());
  auto session = Sessions(c_).find(id);
  if (!session) return std::unexpected(session.error());
  auto events = Sessions(c_).events(id);
  if (!events) return std::unexpected(events.error());
  const auto grades = grades_of(c_.db, id);
  if (!grades) return std::unexpected(grades.error());
  const auto statements = statements_of(c_.db, id);
  if (!statements) return std::unexpected(statements.error());
  auto removed = Metrics(c_).removed(id);
  if (!removed) return std::unexpected(removed.error());
  auto comments = Comments(c_).of(id);
  if (!comments) return std::unexpected(comments.error());
  const bool withheld = !row->released && !sees_withheld(actor);
  SessionDetails out{*row, std::move(*session), std::move(*events), std::nullopt, {}, {}};
  if (withheld) return out;
  out.removed = std::move(*removed);
  out.grade = effective_grade(*grades, *statements);
  out.comments = std::move(*comments);
  return out;
}

Stored<std::optional<HistoryRow>> History::best_before(const Actor& actor, SessionId session) {
  const auto row = one(c_.db, actor, session);
  if (!row) return std::unexpected(row.error());
  const auto best = c_.db.first(
      "SELECT session FROM session_summaries INDEXED BY graded_of_student WHERE student = ?1 AND listed = 1 "
      "AND scenario = ?2 AND device_class = ?3 AND score IS NOT NULL AND (started_at, sequence) < (?4, ?5) "
      "AND (released OR ?6) ORDER BY score DESC, started_at, sequence LIMIT 1",
      session_of, row->student, row->scenario, row->device_class, row->started_utc_us, row->sequence, sees_withheld(actor));
  if (!best) return std::unexpected(best.error());
  if (!*best) return std::optional<HistoryRow>{};
  auto rows = readable_rows(c_.db, actor, {**best});
  if (!rows) return std::unexpected(rows.error());
  if (rows->empty()) return std::optional<HistoryRow>{};
  return std::move(rows->front());
}

Stored<int> History::attempts(const Actor& actor, UserId student, ScenarioId scenario) {
  if (auto allowed = require_reading(actor, student); !allowed) return std::unexpected(allowed.error());
  const auto count = c_.db.first(
      "SELECT count(*) FROM session_summaries INDEXED BY summaries_of_student WHERE student = ?1 AND listed = 1 "
      "AND scenario = ?2",
      [](Row row) { return static_cast<int>(row.integer(0)); }, student, scenario);
  if (!count) return std::unexpected(count.error());
  return count->value_or(0);
}

Stored<std::vector<HistoryRow>> History::of_assignment(const Actor& actor, AssignmentId assignment) {
  const Snapshot snapshot(c_.db);
  const auto sessions =
      sees_withheld(actor)
          ? c_.db.all("SELECT session FROM session_summaries INDEXED BY summaries_of_assignment WHERE assignment = ?1 "
                      "ORDER BY student, started_at, sequence",
                      session_of, assignment)
          : c_.db.all("SELECT session FROM session_summaries INDEXED BY summaries_of_assignment WHERE assignment = ?1 "
                      "AND student = ?2 ORDER BY started_at, sequence",
                      session_of, assignment, actor.id);
  if (!sessions) return std::unexpected(sessions.error());
  return readable_rows(c_.db, actor, *sessions);
}

Stored<void> History::may_read_result(const Actor& actor, SessionId session) {
  const auto found = c_.db.first(
      "SELECT s.student, coalesce(m.released, 1) FROM sessions s LEFT JOIN session_summaries m ON m.session = s.id "
      "WHERE s.id = ?1",
      [](Row row) { return std::pair{row.id<UserId>(0), row.flag(1)}; }, session);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "sessions", session.text());
  if (auto allowed = require_reading(actor, (*found)->first); !allowed) return allowed;
  if (!(*found)->second && !sees_withheld(actor)) return fail(StorageError::not_allowed, "withheld", session.text());
  return {};
}

Stored<std::vector<HistoryRow>> History::interrupted(const Actor& actor, UserId student) {
  if (auto allowed = require_reading(actor, student); !allowed) return std::unexpected(allowed.error());
  const auto sessions = c_.db.all(
      "SELECT session FROM session_summaries INDEXED BY interrupted_summaries WHERE student = ?1 "
      "AND state = 'interrupted' AND listed = 1 AND engine_version = ?2 "
      "AND (SELECT station FROM sessions WHERE id = session) = ?3 ORDER BY started_at DESC, sequence DESC",
      session_of, student, kEngineVersion, c_.station);
  if (!sessions) return std::unexpected(sessions.error());
  return readable_rows(c_.db, actor, *sessions);
}

Stored<bool> History::lacks_grade(const Actor& actor, SessionId session) {
  const auto student = c_.db.first(
      "SELECT m.student FROM session_summaries m JOIN sessions s ON s.id = m.session WHERE m.session = ?1 AND m.state = 'finished' "
      "AND m.listed = 1 AND m.engine_version = ?2 AND s.station = ?3",
      [](Row row) { return row.id<UserId>(0); }, session, kEngineVersion, c_.station);
  if (!student) return std::unexpected(student.error());
  return *student && (**student == actor.id || may(actor.role, Action::grade_again));
}

Stored<std::vector<ExerciseStanding>> History::standings(const Actor& actor, UserId student) {
  if (auto allowed = require_reading(actor, student); !allowed) return std::unexpected(allowed.error());
  const Snapshot snapshot(c_.db);
  auto standings = c_.db.all(
      "SELECT scenario, count(*) FROM session_summaries INDEXED BY summaries_of_student "
      "WHERE student = ?1 AND listed = 1 AND operator = 'person' GROUP BY scenario",
      [](Row row) {
        return ExerciseStanding{row.id<ScenarioId>(0), static_cast<int>(row.integer(1)), std::nullopt, std::nullopt, false};
      },
      student);
  if (!standings) return standings;
  // In the order of the index: by scenario, the oldest first.
  const auto graded = c_.db.all(
      "SELECT scenario, started_at, sequence, session, score, passed FROM session_summaries INDEXED BY graded_of_student "
      "WHERE student = ?1 AND listed = 1 AND operator = 'person' AND score IS NOT NULL AND (released OR ?2) "
      "ORDER BY scenario, started_at, sequence",
      [](Row row) {
        return Graded{row.id<ScenarioId>(0), {row.integer(1), row.integer(2), row.id<SessionId>(3)}, row.real(4), row.flag(5)};
      },
      student, sees_withheld(actor));
  if (!graded) return std::unexpected(graded.error());
  for (ExerciseStanding& standing : *standings) {
    const auto of_scenario = std::ranges::equal_range(*graded, standing.scenario, {}, &Graded::scenario);
    if (of_scenario.empty()) continue;
    standing.passed = std::ranges::any_of(of_scenario, &Graded::passed);
    const Graded& best = *std::ranges::max_element(of_scenario, {}, &Graded::score);
    auto rows = readable_rows(c_.db, actor, {best.key.session, of_scenario.back().key.session});
    if (!rows) return std::unexpected(rows.error());
    if (rows->size() != 2) continue;
    standing.best = std::move(rows->front());
    standing.last = std::move(rows->back());
  }
  return standings;
}

Stored<std::optional<NewestComment>> History::newest_comment(const Actor& actor, UserId student) {
  if (auto allowed = require_reading(actor, student); !allowed) return std::unexpected(allowed.error());
  const auto session = c_.db.first(
      "SELECT m.session, m.started_at FROM session_summaries m INDEXED BY summaries_of_student "
      "WHERE m.student = ?1 AND m.listed = 1 AND (m.released OR ?2) AND (EXISTS (SELECT 1 FROM comments c "
      "WHERE c.session = m.session) OR EXISTS (SELECT 1 FROM statements t WHERE t.session = m.session "
      "AND t.kind = 'comment' AND NOT EXISTS (SELECT 1 FROM statements w WHERE w.session = m.session "
      "AND w.kind = 'withdrawal' AND w.withdraws = t.id))) ORDER BY m.started_at DESC, m.sequence DESC LIMIT 1",
      [](Row row) { return std::pair{row.id<SessionId>(0), row.integer(1)}; }, student, sees_withheld(actor));
  if (!session) return std::unexpected(session.error());
  if (!*session) return std::optional<NewestComment>{};
  auto comments = Comments(c_).of((*session)->first);
  if (!comments) return std::unexpected(comments.error());
  if (comments->empty()) return std::optional<NewestComment>{};  // its text was erased
  return NewestComment{std::move(comments->back()), (*session)->second};
}

}  // namespace cusp::storage
