#include "storage/records/session_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "storage/records/audit_writer.h"
#include "storage/records/current_rights.h"
#include "storage/records/effective_grade.h"
#include "storage/records/packed_attempts.h"
#include "storage/records/sealing.h"
#include "storage/sqlite/row_stream.h"

namespace cusp::storage {
namespace {

/// Columns of session_summaries, in the order of the table and of kFromRecords.
constexpr std::array<std::string_view, 23> kColumns = {
    "session",        "student",    "scenario", "version", "version_number", "kind",    "operator",
    "device",         "device_class", "engine_version", "started_at", "sequence", "listed",  "attempt",
    "state",          "elapsed_us", "score",    "score_max", "pass_mark",    "passed",  "critical", "assignment",
    "released"};
constexpr std::array<std::string_view, 3> kChangedByStatements = {"score", "passed", "critical"};

/// State and result of the session s.id, and where they come from.
constexpr std::string_view kResult = R"(
       CASE WHEN e.kind IN ('started', 'resumed') THEN 'running'
            WHEN e.kind IN ('interrupted', 'finished', 'graded') THEN e.kind
            ELSE iif(g.session IS NULL, 'closed', 'graded') END)";
constexpr std::string_view kGrade = "g.score, g.score_max, g.pass_mark, g.passed, coalesce(g.critical, '[]')";
constexpr std::string_view kResultFrom = R"(
LEFT JOIN session_events e ON e.session = s.id AND e.row = (SELECT max(row) FROM session_events WHERE session = s.id)
LEFT JOIN grades g ON g.session = s.id AND g.row = (SELECT max(row) FROM grades WHERE session = s.id))";

/// Of an assessment a release, and no withdrawal of it; without what an unconfirmed fail withholds (StatedResult).
constexpr std::string_view kReleased = R"((s.kind <> 'assessment' OR EXISTS (
  SELECT 1 FROM statements t INDEXED BY statements_of_session WHERE t.session = s.id AND t.kind = 'release' AND NOT EXISTS (
    SELECT 1 FROM statements w INDEXED BY statements_of_session
    WHERE w.session = s.id AND w.kind = 'withdrawal' AND w.withdraws = t.id))))";

/// A list omits guests and try-outs.
constexpr std::string_view kListed = "(s.kind IN ('practice', 'assessment') AND coalesce(p.guest, 0) = 0)";

/// Every summary as the records give it, by session; without StatedResult.
std::string from_records() {
  const std::string listed(kListed);
  return "SELECT s.id, s.student, v.scenario, s.version, v.number, s.kind, s.hand, s.device, s.device_class, "
         "s.engine_version, s.started_at, s.sequence, " +
         listed + ", row_number() OVER (PARTITION BY s.student, v.scenario, " + listed +
         " ORDER BY s.started_at, s.sequence), " + std::string(kResult) +
         ", coalesce((SELECT elapsed_us FROM trace_chunks WHERE session = s.id ORDER BY row DESC LIMIT 1), "
         "(SELECT elapsed_us FROM metrics WHERE session = s.id ORDER BY row DESC LIMIT 1), 0), " +
         std::string(kGrade) + ", s.assignment, " + std::string(kReleased) +
         " FROM sessions s JOIN scenario_versions v ON v.id = s.version LEFT JOIN people p ON p.id = s.student" +
         std::string(kResultFrom) + " ORDER BY s.id";
}

/// Which attempts are counted together with a session, and its place among them.
struct Place {
  UserId student;
  ScenarioId scenario;
  bool listed = false;
  std::int64_t started_utc_us = 0, sequence = 0;
};

/// Columns of kChangedByStatements.
struct OverriddenResult {
  double score = 0;
  bool passed = false;
  std::string critical;  // JSON
};

/// What statements change of a summary.
struct StatedResult {
  std::optional<OverriddenResult> overridden{};  // nullopt: no override is in force
  bool release_waits = false;                    // then `released` is 0
};

Stored<StatedResult> stated_result(Database& db, SessionId session) {
  const auto statements = statements_of(db, session);
  if (!statements) return std::unexpected(statements.error());
  StatedResult out;
  if (statements->empty()) return out;
  const auto grades = grades_of(db, session);
  if (!grades) return std::unexpected(grades.error());
  const auto counts = effective_grade(*grades, *statements);
  if (!counts) return out;
  const Grade& grade = counts->grade;
  if (!counts->overrides.empty()) out.overridden.emplace(grade.score, grade.passed, nlohmann::json(grade.critical).dump());
  out.release_waits = counts->release_waits();
  return out;
}

/// Sessions whose summary a statement may change.
Stored<std::vector<SessionId>> stated_sessions(Database& db) {
  return db.all("SELECT DISTINCT session FROM statements WHERE kind IN ('override_points', 'override_critical', 'release')",
                [](Row row) { return row.id<SessionId>(0); });
}

Stored<void> write_stated_result(Database& db, SessionId session) {
  const auto stated = stated_result(db, session);
  if (!stated) return std::unexpected(stated.error());
  if (const auto& overridden = stated->overridden) {
    auto done = db.run("UPDATE session_summaries SET score = ?2, passed = ?3, critical = ?4 WHERE session = ?1", session,
                       overridden->score, overridden->passed, overridden->critical);
    if (!done) return done;
  }
  if (!stated->release_waits) return {};
  return db.run("UPDATE session_summaries SET released = 0 WHERE session = ?1", session);
}

/// By session; both streams have the columns of kColumns.
class Rows : public RowStream {
 public:
  using RowStream::RowStream;
  SessionId session() const { return row().id<SessionId>(0); }
};

int column_of(std::string_view name) {
  return static_cast<int>(std::ranges::find(kColumns, name) - kColumns.begin());
}

void compare_columns(const Rows& records, const Rows& stored, const StatedResult& stated,
                     const std::function<void(const SummaryDifference&)>& each) {
  const auto differs = [&](std::string_view column) {
    each({SummaryDifference::Kind::column, records.session(), column});
  };
  for (std::size_t i = 1; i < kColumns.size(); ++i) {
    if (stated.overridden && std::ranges::find(kChangedByStatements, kColumns[i]) != kChangedByStatements.end()) continue;
    if (stated.release_waits && kColumns[i] == "released") continue;
    const int column = static_cast<int>(i);
    if (!records.row().same_value(column, stored.row())) differs(kColumns[i]);
  }
  const Row row = stored.row();
  if (stated.release_waits && row.maybe_integer(column_of("released")) != 0) differs("released");
  if (!stated.overridden) return;
  // A summary of an older program may hold the sum with another rounding.
  const auto score = row.maybe_real(column_of("score"));
  if (!score || !(std::abs(*score - stated.overridden->score) <= scenarios::kScoreSlack)) differs("score");
  if (row.maybe_integer(column_of("passed")) != (stated.overridden->passed ? 1 : 0)) differs("passed");
  if (row.text(column_of("critical")) != stated.overridden->critical) differs("critical");
}

Stored<void> report_added(Database& db, SessionId session, const std::function<void(const SummaryDifference&)>& each) {
  const auto known = db.first("SELECT 1 FROM sessions WHERE id = ?1", [](Row) { return true; }, session);
  if (!known) return std::unexpected(known.error());
  if (!*known) each({SummaryDifference::Kind::added, session});
  return {};
}

/// A clock that was set back, or a file of another station, makes later starts of the same student.
void count_later_ones_up(Transaction& transaction, const Place& place) {
  const auto later = transaction.database().all(
      "SELECT session FROM session_summaries INDEXED BY summaries_of_student WHERE student = ?1 AND listed = ?2 AND scenario = ?3 "
      "AND (started_at, sequence) > (?4, ?5)",
      [](Row row) { return row.id<SessionId>(0); }, place.student, place.listed, place.scenario, place.started_utc_us,
      place.sequence);
  if (!later) return transaction.refuse(later.error());
  for (const SessionId session : *later) {
    transaction.run("UPDATE session_summaries SET attempt = attempt + 1 WHERE session = ?1", session);
    follow_graded(transaction, session);
  }
}

}  // namespace

void add_summary(Transaction& transaction, SessionId session) {
  const auto place = transaction.first(
      "SELECT s.student, v.scenario, " + std::string(kListed) +
          ", s.started_at, s.sequence FROM sessions s JOIN scenario_versions v ON v.id = s.version "
          "LEFT JOIN people p ON p.id = s.student WHERE s.id = ?1",
      [](Row row) {
        return Place{row.id<UserId>(0), row.id<ScenarioId>(1), row.flag(2), row.integer(3), row.integer(4)};
      },
      session);
  if (!place) return transaction.refuse({StorageError::not_found, "sessions", session.text()});
  const auto before = transaction.first(
      "SELECT count(*) FROM session_summaries INDEXED BY summaries_of_student WHERE student = ?1 AND listed = ?2 "
      "AND scenario = ?3 AND (started_at, sequence) < (?4, ?5)",
      [](Row row) { return row.integer(0); }, place->student, place->listed, place->scenario, place->started_utc_us,
      place->sequence);
  count_later_ones_up(transaction, *place);
  transaction.run(
      "INSERT INTO session_summaries SELECT s.id, s.student, v.scenario, s.version, v.number, s.kind, s.hand, s.device, "
      "s.device_class, s.engine_version, s.started_at, s.sequence, ?2, ?3, 'running', 0, NULL, NULL, NULL, NULL, '[]', "
      "s.assignment, s.kind <> 'assessment' FROM sessions s JOIN scenario_versions v ON v.id = s.version WHERE s.id = ?1",
      session, place->listed, before.value_or(0) + 1);
}

void follow_second(Transaction& transaction, SessionId session, std::uint64_t elapsed_us) {
  transaction.run("UPDATE session_summaries SET elapsed_us = ?2 WHERE session = ?1", session, elapsed_us);
}

bool follow_result(Transaction& transaction, SessionId session) {
  const auto content = [&] {
    return transaction.first("SELECT * FROM session_summaries WHERE session = ?1", [](Row row) { return row.content_hash(); }, session);
  };
  const auto before = content();
  transaction.run("UPDATE session_summaries SET (state, score, score_max, pass_mark, passed, critical, released) = "
                  "(SELECT " +
                      std::string(kResult) + ", " + std::string(kGrade) + ", " + std::string(kReleased) +
                      " FROM sessions s" + std::string(kResultFrom) + " WHERE s.id = ?1) WHERE session = ?1",
                  session);
  if (!transaction.ok()) return false;
  if (auto done = write_stated_result(transaction.database(), session); !done) transaction.refuse(std::move(done.error()));
  return content() != before;
}

void follow_event(Transaction& transaction, SessionId session) {
  static_cast<void>(follow_result(transaction, session));  // an event may follow seconds, which the packed attempts have too
  follow_graded(transaction, session);
}

Stored<void> compare_summaries(Database& db, const std::function<void(const SummaryDifference&)>& each) {
  const auto with_statements = stated_sessions(db);
  if (!with_statements) return std::unexpected(with_statements.error());
  const std::set<SessionId> changed(with_statements->begin(), with_statements->end());
  Rows records(db, from_records()), stored(db, "SELECT * FROM session_summaries ORDER BY session");
  auto done = records.next();
  if (done) done = stored.next();
  while (done && (records.there() || stored.there())) {
    const bool only_records = !stored.there() || (records.there() && records.session() < stored.session());
    const bool only_stored = !only_records && (!records.there() || stored.session() < records.session());
    if (only_records) {
      each({SummaryDifference::Kind::missing, records.session()});
    } else if (only_stored) {
      done = report_added(db, stored.session(), each);
    } else {
      Stored<StatedResult> stated;
      if (changed.contains(records.session())) stated = stated_result(db, records.session());
      if (!stated) return std::unexpected(stated.error());
      compare_columns(records, stored, *stated, each);
    }
    if (done && !only_stored) done = records.next();
    if (done && !only_records) done = stored.next();
  }
  return done;
}

Stored<std::uint64_t> rebuild_summaries(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  std::uint64_t differences = 0;
  if (transaction.ok()) {
    auto compared = compare_summaries(context.db, [&](const SummaryDifference&) { ++differences; });
    if (!compared) transaction.refuse(std::move(compared.error()));
  }
  transaction.run("DELETE FROM session_summaries");
  transaction.run("INSERT INTO session_summaries " + from_records());
  if (transaction.ok()) {
    const auto stated = stated_sessions(context.db);
    if (!stated) transaction.refuse(stated.error());
    for (const SessionId session : stated ? *stated : std::vector<SessionId>{}) {
      if (auto done = write_stated_result(context.db, session); !done) transaction.refuse(std::move(done.error()));
    }
  }
  if (transaction.ok()) {
    auto compared = compare_packed(context.db, [&](const PackedDifference&) { ++differences; });
    if (!compared) transaction.refuse(std::move(compared.error()));
  }
  rebuild_packed(transaction);
  log_event(context, transaction,
            {.actor = actor.id, .action = "summaries_rebuilt", .subject = context.station,
             .detail = std::to_string(differences)});
  if (auto done = commit_sealed(context, transaction); !done) return std::unexpected(done.error());
  return differences;
}

}  // namespace cusp::storage
