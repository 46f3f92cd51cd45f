#include "storage/retention/thinning.h"

#include <string>

#include "storage/cache/key_state_cache.h"
#include "storage/records/current_rights.h"
#include "storage/records/sealing.h"
#include "storage/records/thinned_traces.h"
#include "storage/retention/log_order.h"

namespace cusp::storage {
namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

/// Attempts with a recording. ?1: started at or before; ?2: this station. The session's own rows decide, not its summary.
constexpr std::string_view kSelectOld =
    "SELECT s.id, s.station = ?2, s.kind, "
    "(SELECT max(at) FROM session_events e WHERE e.session = s.id AND e.kind = 'finished'), "
    "(SELECT max(at) FROM session_events e WHERE e.session = s.id), "
    "EXISTS (SELECT 1 FROM grades g WHERE g.session = s.id), "
    "EXISTS (SELECT 1 FROM statements t WHERE t.session = s.id AND t.kind NOT IN ('comment', 'withdrawal', 'self_assessment')), "
    "(SELECT links FROM session_heads h WHERE h.session = s.id), "
    "coalesce((SELECT max(sequence) FROM session_events e WHERE e.session = s.id AND e.kind = 'finished'), s.sequence) "
    "FROM session_summaries m INDEXED BY summaries_by_time JOIN sessions s ON s.id = m.session "
    "WHERE m.listed = 1 AND m.started_at <= ?1 AND EXISTS (SELECT 1 FROM trace_chunks c WHERE c.session = s.id)";

std::string select_old(std::string_view further) {
  std::string sql(kSelectOld);
  sql.append(further);
  return sql;
}

struct OldAttempt {
  SessionId session;
  bool own = false;
  std::string kind;
  std::optional<std::int64_t> finished_utc_us;
  std::int64_t last_utc_us = 0;
  bool graded = false, stated = false;
  std::int64_t links = 0, sequence = 0;  // of its end

  std::int64_t ended_utc_us() const noexcept { return finished_utc_us.value_or(last_utc_us); }
};

OldAttempt old_attempt(Row row) {
  return {row.id<SessionId>(0), row.flag(1), row.text(2), row.maybe_integer(3), row.integer(4),
          row.flag(5),          row.flag(6), row.integer(7), row.integer(8)};
}

std::optional<KeptBecause> reason_to_keep(const OldAttempt& attempt) {
  if (!attempt.own) return KeptBecause::other_station;
  if (attempt.kind != "practice") return KeptBecause::assessment;
  if (!attempt.finished_utc_us) return KeptBecause::unfinished;
  if (!attempt.graded) return KeptBecause::ungraded;
  if (attempt.stated) return KeptBecause::stated;
  return std::nullopt;
}

Stored<std::uint64_t> bytes_of(Database& db, SessionId session) {
  const auto bytes = db.first(
      "SELECT (SELECT coalesce(sum(length(trace)), 0) FROM trace_chunks WHERE session = ?1) + "
      "(SELECT coalesce(sum(length(state)), 0) FROM key_states WHERE session = ?1)",
      [](Row row) { return row.u64(0); }, session);
  if (!bytes) return std::unexpected(bytes.error());
  return bytes->value_or(0);
}

/// Empty where the chain holds and each seal of the log is a link of it. Otherwise the first finding.
Stored<std::vector<ChainFinding>> first_finding(StorageContext& context, SessionId session) {
  const Snapshot snapshot(context.db);
  const auto proof = verify_session(context, session);
  if (!proof) return std::unexpected(proof.error());
  ChainFinding finding = proof->intact() ? ChainFinding{} : proof->findings.front();
  finding.owner = session.uuid;
  if (!proof->intact()) return std::vector{finding};
  const auto lost = context.db.first(
      "SELECT a.at FROM audit_log a INDEXED BY seals_of_session WHERE a.action = 'session_sealed' "
      "AND substr(a.subject, 1, 6) = substr(?1, 1, 6) AND a.subject = ?1 AND NOT EXISTS (SELECT 1 FROM session_chain c WHERE c.session = ?1 AND "
      "substr(a.detail, instr(a.detail, ' ') + 1) = (c.position + 1) || ' ' || lower(hex(c.link))) LIMIT 1",
      [](Row row) { return row.integer(0); }, session);
  if (!lost) return std::unexpected(lost.error());
  if (!*lost) return std::vector<ChainFinding>{};
  finding.code = FindingCode::seal_broken;
  finding.table = "session_chain";
  finding.at_utc_us = **lost;
  return std::vector{finding};
}

/// False if the attempt has changed since it was chosen and verified: a further event, grade or statement.
Stored<bool> thin_one(StorageContext& context, const Actor& actor, const OldAttempt& chosen) {
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  const auto now = transaction.first(select_old(" AND s.id = ?3"), old_attempt, INT64_MAX,
                                     context.station, chosen.session);
  const bool same = now && !reason_to_keep(*now) && now->links == chosen.links;
  if (transaction.ok() && !same) return false;
  transaction.run("DELETE FROM trace_chunks WHERE session = ?1", chosen.session);
  transaction.run("DELETE FROM key_states WHERE session = ?1", chosen.session);
  insert_thinned_trace(context, transaction, actor.id, chosen.session);
  log_row(context, transaction, actor.id, "trace_thinned", SealedTable::thinned_traces, chosen.session.uuid);
  if (auto done = commit_sealed(context, transaction); !done) return std::unexpected(done.error());
  KeyStateCache cache(context);
  for (const std::uint64_t tick : cache.ticks(chosen.session)) cache.drop(chosen.session, tick);
  return true;
}

/// Gives free pages to the disk in slices of 4 MB, so that a recorder waits for one at most. A file that an older program
/// made keeps its size: later recordings take the pages.
void give_back_pages(StorageContext& context) {
  const auto free_pages = [&] {
    const auto count = context.db.first("PRAGMA freelist_count", [](Row row) { return row.integer(0); });
    return count ? count->value_or(0) : 0;
  };
  for (std::int64_t before = free_pages(); before > 0;) {
    if (!context.db.run("PRAGMA incremental_vacuum(512)")) return;
    const std::int64_t after = free_pages();
    if (after >= before) break;
    before = after;
  }
  // Another connection may hold the log open: the next checkpoint takes it.
  static_cast<void>(context.db.run("PRAGMA wal_checkpoint(TRUNCATE)"));
}

struct Chosen {
  std::vector<OldAttempt> thinnable;
  KeptTraces kept{};
};

Stored<Chosen> choose(StorageContext& context, const Actor& actor, int older_than_days) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  if (older_than_days < 1 || older_than_days > kMostThinAfterDays) return fail(StorageError::bad_value, "days");
  const std::int64_t now = context.clock(), before = now - older_than_days * kDay_us;
  const auto young = first_sequence_since(context, before, now);
  if (!young) return std::unexpected(young.error());
  auto old = context.db.all(select_old(" ORDER BY m.started_at, m.sequence"), old_attempt, before,
                            context.station);
  if (!old) return std::unexpected(old.error());
  Chosen out;
  for (OldAttempt& attempt : *old) {
    if (attempt.ended_utc_us() > before) continue;
    if (attempt.own && attempt.sequence > *young) continue;
    if (const auto why = reason_to_keep(attempt)) {
      ++out.kept[static_cast<std::size_t>(*why)];
    } else {
      out.thinnable.push_back(std::move(attempt));
    }
  }
  return out;
}

/// One attempt of a run.
Stored<void> run_one(StorageContext& context, const Actor& actor, const OldAttempt& attempt, ThinningMode mode,
                     ThinningReport& report) {
  const auto finding = first_finding(context, attempt.session);
  if (!finding) return std::unexpected(finding.error());
  if (!finding->empty()) {
    ++report.kept[static_cast<std::size_t>(KeptBecause::broken)];
    report.broken.push_back(finding->front());
    return {};
  }
  const auto bytes = bytes_of(context.db, attempt.session);
  if (!bytes) return std::unexpected(bytes.error());
  if (mode == ThinningMode::carry_out) {
    const auto done = thin_one(context, actor, attempt);
    if (!done) return std::unexpected(done.error());
    if (!*done) return {};
  }
  ++report.attempts;
  report.bytes += *bytes;
  return {};
}

}  // namespace

std::string_view key_of(KeptBecause why) noexcept {
  constexpr std::array<std::string_view, kKeptBecause> keys = {"other_station", "assessment", "unfinished",
                                                               "ungraded",      "stated",     "broken"};
  return keys[static_cast<std::size_t>(why)];
}

Stored<OldTraces> old_traces(StorageContext& context, const Actor& actor, int older_than_days) {
  const auto chosen = choose(context, actor, older_than_days);
  if (!chosen) return std::unexpected(chosen.error());
  OldTraces out;
  out.kept = chosen->kept;
  for (const OldAttempt& attempt : chosen->thinnable) {
    const auto bytes = bytes_of(context.db, attempt.session);
    if (!bytes) return std::unexpected(bytes.error());
    out.thinnable.push_back({attempt.session, attempt.ended_utc_us()});
    out.bytes += *bytes;
  }
  return out;
}

Stored<ThinningReport> thin_traces(StorageContext& context, const Actor& actor, const ThinningOrder& order,
                                   const WorkWatch& watch) {
  const auto chosen = choose(context, actor, order.older_than_days);
  if (!chosen) return std::unexpected(chosen.error());
  const bool carry_out = order.mode == ThinningMode::carry_out;
  if (carry_out && !context.key) return std::unexpected(context.db.unwritable());
  auto doubt = clock_doubt(context, order.older_than_days * kDay_us);
  if (!doubt) return std::unexpected(doubt.error());
  if (carry_out && *doubt && order.trust == ClockTrust::checked) return std::unexpected(**doubt);
  ThinningReport report;
  report.doubt = std::move(*doubt);
  report.kept = chosen->kept;
  for (std::size_t i = 0; i < chosen->thinnable.size(); ++i) {
    if (watch && !watch(i, chosen->thinnable.size())) {
      report.stopped = true;
      report.left = chosen->thinnable.size() - i;
      break;
    }
    if (auto done = run_one(context, actor, chosen->thinnable[i], order.mode, report); !done) {
      if (!carry_out || report.attempts == 0) return std::unexpected(done.error());
      report.failed = std::move(done.error());
      report.left = chosen->thinnable.size() - i - 1;
      break;
    }
  }
  if (carry_out && report.attempts > 0) give_back_pages(context);
  return report;
}

}  // namespace cusp::storage
