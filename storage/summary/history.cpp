#include "storage/summary/history.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "storage/repositories/session_state.h"
#include "storage/repositories/title.h"

namespace cusp::storage {
namespace {

/// ?1 session, ?2 student, ?3 scenario, ?4 cohort, ?5 device class, ?6 from, ?7 to, ?8 passed, ?9 search, ?10 scripted,
/// ?11 most rows, ?12 guests and try-outs too. A null parameter filters nothing. Attempts are counted before filtering.
constexpr const char* kRows = R"(
WITH counted AS (
  SELECT s.id, s.student, p.number AS student_number, p.name AS student_name, v.scenario, s.version,
         v.number AS version_number, v.key, v.title, s.kind, s.hand, s.device, s.device_class, s.started_at, s.sequence,
         s.engine_version, row_number() OVER (PARTITION BY s.student, v.scenario, s.kind IN ('practice', 'assessment')
                            ORDER BY s.started_at, s.sequence) AS attempt
  FROM sessions s
  JOIN people p ON p.id = s.student
  JOIN scenario_versions v ON v.id = s.version
  WHERE (?2 IS NULL OR s.student = ?2)
    AND (?12 OR (s.kind IN ('practice', 'assessment') AND p.guest = 0))
)
SELECT c.id, c.student, c.student_number, c.student_name, c.scenario, c.version, c.version_number, c.key, c.title,
       c.kind, c.hand, c.device, c.device_class, c.started_at,
       coalesce((SELECT elapsed_us FROM trace_chunks WHERE session = c.id ORDER BY row DESC LIMIT 1), 0),
       (SELECT kind FROM session_events WHERE session = c.id ORDER BY row DESC LIMIT 1),
       c.attempt, g.score, g.score_max, g.pass_mark, g.passed, g.critical, c.engine_version
FROM counted c
LEFT JOIN grades g ON g.session = c.id AND g.row = (SELECT max(row) FROM grades WHERE session = c.id)
WHERE (?1 IS NULL OR c.id = ?1)
  AND (?3 IS NULL OR c.scenario = ?3)
  AND (?4 IS NULL OR EXISTS (SELECT 1 FROM cohort_students WHERE cohort = ?4 AND student = c.student))
  AND (?5 IS NULL OR c.device_class = ?5)
  AND (?6 IS NULL OR c.started_at >= ?6)
  AND (?7 IS NULL OR c.started_at < ?7)
  AND (?8 IS NULL OR g.passed = ?8)
  AND (?9 = '' OR instr(lower(c.student_name), lower(?9)) > 0 OR instr(lower(c.student_number), lower(?9)) > 0)
  AND (?10 IS NULL OR (c.hand <> 'person') = ?10)
ORDER BY c.started_at DESC, c.sequence DESC
LIMIT ?11)";

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
  h.elapsed_us = row.u64(14);
  const auto last = event_kind_from_key(row.text(15)).value_or(EventKind::closed);
  h.attempt = static_cast<int>(row.integer(16));
  h.score = row.maybe_real(17);
  h.score_max = row.maybe_real(18);
  h.pass_mark = row.maybe_real(19);
  if (!row.is_null(20)) h.passed = row.flag(20);
  h.engine_version = static_cast<int>(row.integer(22));
  const auto critical = nlohmann::json::parse(row.text(21), nullptr, false);
  if (critical.is_array()) {
    for (const auto& item : critical) {
      if (item.is_string()) h.critical.push_back(item.get<std::string>());
    }
  }
  h.state = state_after({SessionEvent{.kind = last}});
  if (h.state == SessionState::closed && h.passed) h.state = SessionState::graded;
  return h;
}

Stored<std::vector<HistoryRow>> rows(Database& db, const HistoryFilter& f, std::optional<SessionId> session) {
  return db.all(kRows, row_of, session, f.student, f.scenario, f.cohort, f.device_class, f.from_utc_us, f.to_utc_us,
                f.passed, f.search, f.scripted, f.limit, session.has_value());
}

Stored<UserId> owner_of(Database& db, SessionId session) {
  const auto student =
      db.first("SELECT student FROM sessions WHERE id = ?1", [](Row row) { return row.id<UserId>(0); }, session);
  if (!student) return std::unexpected(student.error());
  if (!*student) return fail(StorageError::not_found, "sessions", session.text());
  return **student;
}

/// One session of any kind.
Stored<HistoryRow> one(Database& db, const Actor& actor, SessionId session) {
  const auto owner = owner_of(db, session);
  if (!owner) return std::unexpected(owner.error());
  if (auto allowed = require_reading(actor, *owner); !allowed) return std::unexpected(allowed.error());
  HistoryFilter filter;
  filter.student = *owner;
  auto found = rows(db, filter, session);
  if (!found) return std::unexpected(found.error());
  if (found->empty()) return fail(StorageError::not_found, "sessions", session.text());
  return std::move(found->front());
}

/// Best by score, the earlier of two equal ones. Pre: rows come newest first.
void keep_best(std::optional<HistoryRow>& best, const HistoryRow& row) {
  if (row.score && (!best || *row.score >= *best->score)) best = row;
}

}  // namespace

Stored<std::vector<HistoryRow>> History::list(const Actor& actor, const HistoryFilter& filter) {
  HistoryFilter narrowed = filter;
  if (!may(actor.role, Action::see_all_results)) {
    if (filter.student && *filter.student != actor.id) {
      return fail(StorageError::not_allowed, std::string(key_of(Action::see_all_results)));
    }
    narrowed.student = actor.id;
  }
  return rows(c_.db, narrowed, std::nullopt);
}

Stored<SessionDetails> History::details(const Actor& actor, SessionId id) {
  const auto row = one(c_.db, actor, id);
  if (!row) return std::unexpected(row.error());
  auto session = Sessions(c_).find(id);
  if (!session) return std::unexpected(session.error());
  auto events = Sessions(c_).events(id);
  if (!events) return std::unexpected(events.error());
  auto grade = Grades(c_).newest(id);
  if (!grade) return std::unexpected(grade.error());
  auto removed = Metrics(c_).removed(id);
  if (!removed) return std::unexpected(removed.error());
  auto comments = Comments(c_).of(id);
  if (!comments) return std::unexpected(comments.error());
  return SessionDetails{
      *row, std::move(*session), std::move(*events), std::move(*grade), std::move(*removed), std::move(*comments)};
}

Stored<std::optional<HistoryRow>> History::best_before(const Actor& actor, SessionId session) {
  const auto row = one(c_.db, actor, session);
  if (!row) return std::unexpected(row.error());
  HistoryFilter filter;
  filter.student = row->student;
  filter.scenario = row->scenario;
  filter.device_class = row->device_class;
  const auto all = rows(c_.db, filter, std::nullopt);
  if (!all) return std::unexpected(all.error());
  std::optional<HistoryRow> best;
  // A try-out or a guest's attempt is in no list: every attempt that started before it counts.
  const bool listed = std::ranges::any_of(*all, [&](const HistoryRow& other) { return other.session == session; });
  for (const HistoryRow& other : *all) {
    if (listed ? other.attempt < row->attempt : other.started_utc_us < row->started_utc_us) keep_best(best, other);
  }
  return best;
}

Stored<int> History::attempts(const Actor& actor, UserId student, ScenarioId scenario) {
  HistoryFilter filter;
  filter.student = student;
  filter.scenario = scenario;
  const auto all = list(actor, filter);
  if (!all) return std::unexpected(all.error());
  return static_cast<int>(all->size());
}

Stored<std::vector<HistoryRow>> History::interrupted(const Actor& actor, UserId student) {
  HistoryFilter filter;
  filter.student = student;
  auto all = list(actor, filter);
  if (!all) return all;
  std::erase_if(*all, [](const HistoryRow& row) {
    return row.state != SessionState::interrupted || row.engine_version != kEngineVersion;
  });
  return all;
}

Stored<std::vector<ExerciseStanding>> History::standings(const Actor& actor, UserId student) {
  HistoryFilter filter;
  filter.student = student;
  const auto all = list(actor, filter);
  if (!all) return std::unexpected(all.error());
  std::vector<ExerciseStanding> out;
  for (const HistoryRow& row : *all) {
    auto at = std::ranges::find(out, row.scenario, &ExerciseStanding::scenario);
    if (at == out.end()) at = out.insert(at, ExerciseStanding{row.scenario, 0, std::nullopt, std::nullopt});
    ++at->attempts;
    keep_best(at->best, row);
    if (row.score && !at->last) at->last = row;
  }
  return out;
}

}  // namespace cusp::storage
