#include "storage/records/session_summary.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "storage/records/audit_writer.h"
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

/// Of an assessment a release, and no withdrawal of it.
constexpr std::string_view kReleased = R"((s.kind <> 'assessment' OR EXISTS (
  SELECT 1 FROM statements t INDEXED BY statements_of_session WHERE t.session = s.id AND t.kind = 'release' AND NOT EXISTS (
    SELECT 1 FROM statements w INDEXED BY statements_of_session
    WHERE w.session = s.id AND w.kind = 'withdrawal' AND w.withdraws = t.id))))";

/// A list omits guests and try-outs.
constexpr std::string_view kListed = "(s.kind IN ('practice', 'assessment') AND coalesce(p.guest, 0) = 0)";

/// Every summary as the records give it, by session; without what statements change of a score.
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

/// A result in the columns of kChangedByStatements.
struct CountedResult {
  double score = 0;
  bool passed = false;
  std::string critical;  // JSON
};

/// nullopt unless an override is in force.
Stored<std::optional<CountedResult>> counted_result(Database& db, SessionId session) {
  const auto statements = statements_of(db, session);
  if (!statements) return std::unexpected(statements.error());
  std::optional<CountedResult> out;
  if (statements->empty()) return out;
  const auto grades = grades_of(db, session);
  if (!grades) return std::unexpected(grades.error());
  const auto counts = effective_grade(*grades, *statements);
  if (!counts || counts->overrides.empty()) return out;
  out.emplace(counts->grade.score, counts->grade.passed, nlohmann::json(counts->grade.critical).dump());
  return out;
}

/// Sessions whose result a statement may change.
Stored<std::vector<SessionId>> overridden_sessions(Database& db) {
  return db.all("SELECT DISTINCT session FROM statements WHERE kind IN ('override_points', 'override_critical')",
                [](Row row) { return row.id<SessionId>(0); });
}

Stored<void> write_counted_result(Database& db, SessionId session) {
  const auto counted = counted_result(db, session);
  if (!counted) return std::unexpected(counted.error());
  if (!*counted) return {};
  return db.run("UPDATE session_summaries SET score = ?2, passed = ?3, critical = ?4 WHERE session = ?1", session,
                (*counted)->score, (*counted)->passed, (*counted)->critical);
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

/// `counted`: what statements make of the result; nullopt: nothing.
void compare_columns(const Rows& records, const Rows& stored, const std::optional<CountedResult>& counted,
                     const std::function<void(const SummaryDifference&)>& each) {
  const auto differs = [&](std::string_view column) {
    each({SummaryDifference::Kind::column, records.session(), column});
  };
  for (std::size_t i = 1; i < kColumns.size(); ++i) {
    if (counted && std::ranges::find(kChangedByStatements, kColumns[i]) != kChangedByStatements.end()) continue;
    const int column = static_cast<int>(i);
    if (!records.row().same_value(column, stored.row())) differs(kColumns[i]);
  }
  if (!counted) return;
  const Row row = stored.row();
  if (row.maybe_real(column_of("score")) != counted->score) differs("score");
  if (row.maybe_integer(column_of("passed")) != (counted->passed ? 1 : 0)) differs("passed");
  if (row.text(column_of("critical")) != counted->critical) differs("critical");
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

void follow_event(Transaction& transaction, SessionId session) {
  transaction.run("UPDATE session_summaries SET (state, score, score_max, pass_mark, passed, critical, released) = "
                  "(SELECT " +
                      std::string(kResult) + ", " + std::string(kGrade) + ", " + std::string(kReleased) +
                      " FROM sessions s" + std::string(kResultFrom) + " WHERE s.id = ?1) WHERE session = ?1",
                  session);
  if (!transaction.ok()) return;
  if (auto done = write_counted_result(transaction.database(), session); !done) transaction.refuse(std::move(done.error()));
  follow_graded(transaction, session);
}

Stored<void> compare_summaries(Database& db, const std::function<void(const SummaryDifference&)>& each) {
  const auto overridden = overridden_sessions(db);
  if (!overridden) return std::unexpected(overridden.error());
  const std::set<SessionId> changed(overridden->begin(), overridden->end());
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
      Stored<std::optional<CountedResult>> counted;
      if (changed.contains(records.session())) counted = counted_result(db, records.session());
      if (!counted) return std::unexpected(counted.error());
      compare_columns(records, stored, *counted, each);
    }
    if (done && !only_stored) done = records.next();
    if (done && !only_records) done = stored.next();
  }
  return done;
}

Stored<std::uint64_t> rebuild_summaries(StorageContext& context, const Actor& actor) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  Transaction transaction(context.db);
  std::uint64_t differences = 0;
  if (transaction.ok()) {
    auto compared = compare_summaries(context.db, [&](const SummaryDifference&) { ++differences; });
    if (!compared) transaction.refuse(std::move(compared.error()));
  }
  transaction.run("DELETE FROM session_summaries");
  transaction.run("INSERT INTO session_summaries " + from_records());
  if (transaction.ok()) {
    const auto overridden = overridden_sessions(context.db);
    if (!overridden) transaction.refuse(overridden.error());
    for (const SessionId session : overridden ? *overridden : std::vector<SessionId>{}) {
      if (auto done = write_counted_result(context.db, session); !done) transaction.refuse(std::move(done.error()));
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
