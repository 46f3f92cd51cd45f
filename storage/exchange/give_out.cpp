#include <array>

#include "storage/exchange/exchange.h"
#include "storage/exchange/logged_files.h"
#include "storage/exchange/session_copies.h"
#include "storage/records/sealing.h"
#include "storage/records/audit_writer.h"
#include "storage/records/current_rights.h"

namespace cusp::storage {
namespace {

/// Statements of this station, with keys and authors. ?1: the station. Authors go by name alone (`referred`). An own assessment goes
/// with its session.
constexpr std::array kStatementCopies = {
    "INSERT OR IGNORE INTO station_keys SELECT * FROM source.station_keys WHERE id IN (SELECT key FROM source.statements WHERE station = ?1 AND kind <> 'self_assessment')",
    "INSERT OR IGNORE INTO people SELECT id, number, name, role, '', '', 1, guest, 0, 0, created_at FROM source.people "
    "WHERE id IN (SELECT author FROM source.statements WHERE station = ?1 AND kind <> 'self_assessment')",
    "INSERT OR IGNORE INTO statements SELECT * FROM source.statements WHERE station = ?1 AND kind <> 'self_assessment' ORDER BY sequence",
    "INSERT OR IGNORE INTO statement_texts SELECT * FROM source.statement_texts WHERE statement IN (SELECT id FROM source.statements WHERE station = ?1 AND kind <> 'self_assessment')",
};

constexpr std::array kOfficeCopies = {
    "INSERT INTO people SELECT id, number, name, role, password, pin, disabled, guest, 0, 0, created_at FROM source.people "
    "WHERE guest = 0 AND number <> 'demo' AND id NOT IN (SELECT id FROM source.referred WHERE here = 0)",
    "INSERT INTO cohorts SELECT * FROM source.cohorts",
    "INSERT INTO cohort_students SELECT * FROM source.cohort_students",
    "INSERT INTO scenario_versions SELECT * FROM source.scenario_versions WHERE id NOT IN (SELECT id FROM source.referred WHERE here = 0) "
    "OR id IN (SELECT version FROM source.assignments)",
    "INSERT INTO blobs SELECT * FROM source.blobs WHERE hash IN (SELECT f.blob FROM source.version_files f JOIN scenario_versions v ON v.id = f.version)",
    "INSERT INTO version_files SELECT * FROM source.version_files WHERE version IN (SELECT id FROM scenario_versions)",
    "INSERT INTO version_withdrawals SELECT * FROM source.version_withdrawals WHERE version IN (SELECT id FROM scenario_versions)",
    "INSERT INTO assignments SELECT * FROM source.assignments WHERE id NOT IN (SELECT id FROM source.referred WHERE here = 0)",
    "INSERT INTO assessments SELECT * FROM source.assessments WHERE assignment IN (SELECT id FROM assignments)",
    "INSERT INTO assignment_withdrawals SELECT * FROM source.assignment_withdrawals WHERE assignment IN (SELECT id FROM assignments)",
    "INSERT INTO adjustments SELECT * FROM source.adjustments WHERE assignment IN (SELECT id FROM assignments)",
    // Whom these name and the office knows by name alone.
    "INSERT OR IGNORE INTO people SELECT id, number, name, role, '', '', 1, guest, 0, 0, created_at FROM source.people WHERE id IN ("
    "SELECT student FROM cohort_students UNION SELECT author FROM assignments UNION SELECT author FROM adjustments UNION SELECT student FROM adjustments)",
};

Stored<std::vector<SessionId>> ended_sessions(StorageContext& context) {
  return context.db.all(
      "SELECT m.session FROM session_summaries m JOIN sessions s ON s.id = m.session "
      "WHERE m.listed = 1 AND m.state <> 'running' AND s.station = ?1 ORDER BY m.session",
      [](Row row) { return row.id<SessionId>(0); }, context.station);
}

/// Marks the accounts, and of results the versions and assignments, that the file's records refer to without bringing them.
void mark_referred(Transaction& transaction, ExchangeKind kind) {
  if (kind == ExchangeKind::results) {
    transaction.run("INSERT INTO referred SELECT id, 0 FROM people UNION SELECT id, 0 FROM scenario_versions "
                    "UNION SELECT id, 0 FROM assignments");
  } else {
    transaction.run("INSERT INTO referred SELECT id, 0 FROM people WHERE id IN (SELECT id FROM source.referred WHERE here = 0) "
                    "OR number = 'demo'");
  }
}

/// A session is copied in a transaction of its own: each holds the station's records for a moment.
Stored<void> copy_sessions(StorageContext& context, Database& to, WorkSteps& steps) {
  const auto sessions = ended_sessions(context);
  if (!sessions) return std::unexpected(sessions.error());
  steps.begin(sessions->size());
  for (const SessionId session : *sessions) {
    if (!steps.go_on()) return fail(StorageError::stopped, to.file().string());
    Transaction transaction(to);
    // One that runs again goes out with the next file.
    static_cast<void>(copy_session(transaction, session));
    if (auto done = transaction.commit(); !done) return done;
    steps.add_done();
  }
  return {};
}

Stored<void> fill_exchange(StorageContext& context, Database& to, ExchangeKind kind, WorkSteps& steps) {
  // A statement goes out without the session that it speaks of.
  if (auto done = to.run("PRAGMA foreign_keys = OFF"); !done) return done;
  const StatementWatch watch(to, [&steps] { return steps.go_on(); });
  if (kind == ExchangeKind::results) {
    if (auto done = copy_sessions(context, to, steps); !done) return done;
  }
  Transaction transaction(to);
  transaction.run("INSERT INTO station SELECT * FROM source.station");
  if (kind == ExchangeKind::office) {
    for (const char* copy : kOfficeCopies) transaction.run(copy);
  }
  for (const char* copy : kStatementCopies) transaction.run(copy, context.station);
  mark_referred(transaction, kind);
  return transaction.commit();
}

/// Descriptions of the files that this key has signed so far, from the log.
std::vector<Hash256> earlier_files(StorageContext& context, Transaction& transaction) {
  std::vector<Hash256> out;
  if (!transaction.ok()) return out;
  const std::string key = hex(context.key->id());
  const auto details = context.db.all(
      "SELECT detail FROM audit_log INDEXED BY audit_by_subject WHERE subject = ?1 AND action = 'exchange_given_out' "
      "AND action <> 'session_sealed' ORDER BY number",
      [](Row row) { return row.text(0); }, context.station);
  if (!details) transaction.refuse(details.error());
  for (const std::string& detail : details ? *details : std::vector<std::string>{}) {
    const auto hash = hash_from_hex(std::string_view(detail).substr(detail.rfind(' ') + 1));
    if (detail.starts_with(key) && hash) out.push_back(*hash);
  }
  return out;
}

/// Counts and hashes what the file carries: the last that can be stopped.
Stored<void> sum_up(Database& to, GivenOut& out, WorkSteps& steps) {
  const auto counts = counts_of(to);
  if (!counts) return std::unexpected(counts.error());
  out.counts = *counts;
  if (out.description.kind == ExchangeKind::office) steps.begin(counts->accounts);
  steps.end();
  const StatementWatch watch(to, [&steps] { return steps.go_on(); });
  auto tables = table_hashes(to, steps);
  if (!tables) return std::unexpected(tables.error());
  out.description.tables = std::move(*tables);
  return {};
}

/// Number, description and entry in the log, in one transaction: no two files have one number. The file has its description before the
/// entry is written: none is of a file that the disk had no room for.
Stored<void> sign_given_out(StorageContext& context, const Actor& actor, Database& to, ExchangeDescription& description) {
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  description.earlier = earlier_files(context, transaction);
  description.log = transaction.first("SELECT entries, link FROM audit_head", [](Row row) { return ChainHead{row.u64(0), row.hash(1)}; }).value_or(ChainHead{});
  const SignedText text = sign_exchange(*context.key, description);
  if (auto added = transaction.ok() ? add_description(to, text) : Stored<void>{}; !added) transaction.refuse(std::move(added.error()));
  log_event(context, transaction,
            {.actor = actor.id, .action = "exchange_given_out", .subject = context.station,
             .detail = given_out_detail(context.key->id(), description.kind, description_hash(text))});
  return commit_sealed(context, transaction);
}

}  // namespace

Stored<GivenOut> give_out(StorageContext& context, const Actor& actor, ExchangeKind kind, const std::filesystem::path& file, const WorkWatch& watch) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  if (!context.key) return std::unexpected(context.db.unwritable());
  if (name_earlier_files(context, file)) return fail(StorageError::duplicate, file.filename().string(), "finished");
  GivenOut out{.description = {.station = context.station, .kind = kind, .maker = actor.id, .made_utc_us = context.clock()},
               .key = context.key->id()};
  WorkSteps steps(watch);
  const auto fill = [&](Database& to) { return fill_exchange(context, to, kind, steps); };
  const auto sign = [&](Database& to) -> Stored<void> {
    auto summed = sum_up(to, out, steps);
    return summed ? sign_given_out(context, actor, to, out.description) : summed;
  };
  const auto made = make_copy(file, context.db.file(), fill, sign);
  if (!made && steps.stopped()) return fail(StorageError::stopped, file.string());
  if (!made) return std::unexpected(made.error());
  return out;
}

}  // namespace cusp::storage
