#include "storage/records/session_summary.h"

#include <array>
#include <utility>

#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

/// Columns of session_summaries, in the order of the table and of kFromRecords.
constexpr std::array<std::string_view, 21> kColumns = {
    "session",        "student",    "scenario", "version", "version_number", "kind",    "operator",
    "device",         "device_class", "engine_version", "started_at", "sequence", "listed",  "attempt",
    "state",          "elapsed_us", "score",    "score_max", "pass_mark",    "passed",  "critical"};

/// State and result of the session s.id, and where they come from.
constexpr std::string_view kResult = R"(
       CASE WHEN e.kind IN ('started', 'resumed') THEN 'running'
            WHEN e.kind IN ('interrupted', 'finished', 'graded') THEN e.kind
            ELSE iif(g.session IS NULL, 'closed', 'graded') END)";
constexpr std::string_view kGrade = "g.score, g.score_max, g.pass_mark, g.passed, coalesce(g.critical, '[]')";
constexpr std::string_view kResultFrom = R"(
LEFT JOIN session_events e ON e.session = s.id AND e.row = (SELECT max(row) FROM session_events WHERE session = s.id)
LEFT JOIN grades g ON g.session = s.id AND g.row = (SELECT max(row) FROM grades WHERE session = s.id))";

/// A list omits guests and try-outs.
constexpr std::string_view kListed = "(s.kind IN ('practice', 'assessment') AND coalesce(p.guest, 0) = 0)";

/// Every summary as the records give it, by session.
std::string from_records() {
  const std::string listed(kListed);
  return "SELECT s.id, s.student, v.scenario, s.version, v.number, s.kind, s.hand, s.device, s.device_class, "
         "s.engine_version, s.started_at, s.sequence, " +
         listed + ", row_number() OVER (PARTITION BY s.student, v.scenario, " + listed +
         " ORDER BY s.started_at, s.sequence), " + std::string(kResult) +
         ", coalesce((SELECT elapsed_us FROM trace_chunks WHERE session = s.id ORDER BY row DESC LIMIT 1), 0), " +
         std::string(kGrade) +
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

/// One stream of rows by session; both streams have the columns of kColumns.
class Rows {
 public:
  Rows(Database& db, std::string_view sql) : statement_{db.prepare(sql)} {}
  Stored<void> next() {
    auto more = statement_.step();
    if (!more) return std::unexpected(more.error());
    there_ = *more;
    if (there_) session_ = row().id<SessionId>(0);
    return {};
  }
  bool there() const noexcept { return there_; }
  SessionId session() const noexcept { return session_; }
  Row row() const noexcept { return statement_.row(); }

 private:
  Statement statement_;
  bool there_ = false;
  SessionId session_;
};

void compare_columns(const Rows& records, const Rows& stored, const std::function<void(const SummaryDifference&)>& each) {
  for (std::size_t i = 1; i < kColumns.size(); ++i) {
    const int column = static_cast<int>(i);
    if (records.row().same_value(column, stored.row())) continue;
    each({SummaryDifference::Kind::column, records.session(), kColumns[i]});
  }
}

Stored<void> report_added(Database& db, SessionId session, const std::function<void(const SummaryDifference&)>& each) {
  const auto known = db.first("SELECT 1 FROM sessions WHERE id = ?1", [](Row) { return true; }, session);
  if (!known) return std::unexpected(known.error());
  if (!*known) each({SummaryDifference::Kind::added, session});
  return {};
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
  // Only a clock that was set back makes a later start of the same student.
  transaction.run(
      "UPDATE session_summaries INDEXED BY summaries_of_student SET attempt = attempt + 1 WHERE student = ?1 "
      "AND listed = ?2 AND scenario = ?3 AND (started_at, sequence) > (?4, ?5)",
      place->student, place->listed, place->scenario, place->started_utc_us, place->sequence);
  transaction.run(
      "INSERT INTO session_summaries SELECT s.id, s.student, v.scenario, s.version, v.number, s.kind, s.hand, s.device, "
      "s.device_class, s.engine_version, s.started_at, s.sequence, ?2, ?3, 'running', 0, NULL, NULL, NULL, NULL, '[]' "
      "FROM sessions s JOIN scenario_versions v ON v.id = s.version WHERE s.id = ?1",
      session, place->listed, before.value_or(0) + 1);
}

void follow_second(Transaction& transaction, SessionId session, std::uint64_t elapsed_us) {
  transaction.run("UPDATE session_summaries SET elapsed_us = ?2 WHERE session = ?1", session, elapsed_us);
}

void follow_event(Transaction& transaction, SessionId session) {
  transaction.run("UPDATE session_summaries SET (state, score, score_max, pass_mark, passed, critical) = (SELECT " +
                      std::string(kResult) + ", " + std::string(kGrade) + " FROM sessions s" + std::string(kResultFrom) +
                      " WHERE s.id = ?1) WHERE session = ?1",
                  session);
}

Stored<void> compare_summaries(Database& db, const std::function<void(const SummaryDifference&)>& each) {
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
      compare_columns(records, stored, each);
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
  log_event(context, transaction,
            {.actor = actor.id, .action = "summaries_rebuilt", .subject = context.station,
             .detail = std::to_string(differences)});
  if (auto done = commit_sealed(context, transaction); !done) return std::unexpected(done.error());
  return differences;
}

}  // namespace cusp::storage
