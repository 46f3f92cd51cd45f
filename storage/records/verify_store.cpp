#include <algorithm>
#include <set>
#include <utility>

#include "storage/records/seal_index.h"
#include "storage/records/packed_attempts.h"
#include "storage/records/rollback_counter.h"
#include "storage/records/session_summary.h"
#include "storage/records/session_tables.h"
#include "storage/records/statement_rows.h"
#include "storage/records/trace_codec.h"
#include "storage/records/verify_log.h"

namespace cusp::storage {
namespace {

class StoreVerifier {
 public:
  StoreVerifier(StorageContext& context, const WorkWatch& watch) : context_{context}, db_{context.db}, steps_{watch} {}

  Stored<StoreVerification> verify() {
    const Snapshot snapshot(db_);
    const auto counter = check_counter(context_);  // before the snapshot: the log then holds what the counter saw
    if (auto done = read_log(); !done) return std::unexpected(done.error());
    if (steps_.stopped()) return verified();
    check_schema();
    check_single_row("audit_head");
    report_counter(counter);
    check_station();
    check_keys();
    if (auto done = check_sessions(); !done) return std::unexpected(done.error());
    for (const auto check : {&StoreVerifier::check_summaries, &StoreVerifier::check_packed, &StoreVerifier::check_accounts,
                             &StoreVerifier::check_comments}) {
      if (steps_.go_on()) (this->*check)();
    }
    if (steps_.go_on()) {
      if (auto done = add_statement_findings(); !done) return std::unexpected(done.error());
    }
    if (steps_.go_on()) check_members();
    for (const SealedTable table : kSealedTables) {
      if (steps_.go_on()) check_rows(table);
    }
    if (steps_.go_on()) check_blobs();
    return verified();
  }

 private:
  StoreVerification verified() {
    out_.stopped = steps_.stopped();
    return std::move(out_);
  }
  /// One statement may take seconds: the watch ends it, too.
  template <class Read>
  auto watched(Read read) {
    const StatementWatch watch(db_, [this] { return steps_.go_on(); });
    return read();
  }
  void find(FindingCode code, std::string_view table, const Uuid& owner = {}, std::string what = {},
            std::int64_t at_utc_us = 0) {
    out_.findings.push_back({code, std::string(table), -1, -1, owner, std::move(what), at_utc_us});
  }
  /// False, and a finding, if the table cannot be read.
  template <class T>
  bool readable(const Stored<T>& rows, std::string_view table) {
    if (!rows) find(FindingCode::unreadable, table);
    return rows.has_value();
  }
  bool sealed() const { return log_.began_utc_us.has_value(); }

  Stored<void> read_log() {
    // The log's own first entry names its station: the row of `station` could have been changed.
    const auto named = db_.first("SELECT subject FROM audit_log WHERE action = 'station_key_added' ORDER BY number LIMIT 1",
                                 [](Row row) { return row.uuid(0); });
    if (!named) return std::unexpected(named.error());
    station_ = named->value_or(context_.station);
    auto followed = watched([this] { return follow_audit_log(context_, station_, [this](const AuditEntry& e) { log_.add(e); }); });
    // Part of a log proves nothing.
    if (steps_.stopped()) return {};
    if (!followed) return std::unexpected(followed.error());
    out_.findings = std::move(followed->findings);
    out_.entries = followed->links;
    out_.findings.insert(out_.findings.end(), log_.incidents.begin(), log_.incidents.end());
    out_.sealed_since_utc_us = log_.began_utc_us;
    out_.sealed_later = log_.sealed_later;
    return {};
  }

  /// The schema has no trigger and no view: either would change what another program writes or reads.
  void check_schema() {
    const auto names = db_.all("SELECT name FROM sqlite_schema WHERE type IN ('trigger', 'view')",
                               [](Row row) { return row.text(0); });
    if (!readable(names, "sqlite_schema")) return;
    for (const std::string& name : *names) find(FindingCode::row_added, "sqlite_schema", {}, name);
  }

  /// A table of one row holds no second row.
  void check_single_row(const std::string& table) {
    const auto rows = db_.first("SELECT count(*) FROM " + table, [](Row row) { return row.integer(0); });
    if (rows && rows->value_or(0) > 1) find(FindingCode::row_added, table);
  }

  void report_counter(const Stored<CounterCheck>& check) {
    if (!check) return find(FindingCode::counter_missing, "audit_log", {}, context_.counter_file.string());
    switch (check->state) {
      case CounterState::good:
        out_.uncounted = check->log.links - check->counted;
        return;
      case CounterState::missing:
        if (sealed()) find(FindingCode::counter_missing, "audit_log");
        return;
      case CounterState::broken:
        return find(FindingCode::counter_broken, "audit_log");
      case CounterState::rolled_back:
        return find(FindingCode::rolled_back, "audit_log", {},
                    std::to_string(check->counted) + ' ' + std::to_string(check->log.links));
    }
  }

  void check_station() {
    const auto station = db_.first("SELECT id, next_sequence FROM station", [](Row row) {
      return std::pair{row.uuid(0), row.integer(1)};
    });
    if (!readable(station, "station")) return;
    if (!*station) return find(FindingCode::row_missing, "station", station_);
    if ((*station)->first != station_) find(FindingCode::row_changed, "station", station_, "id");
    const auto used = db_.first(
        "SELECT max(n) FROM (SELECT max(sequence) n FROM audit_log UNION ALL SELECT max(sequence) FROM sessions "
        "UNION ALL SELECT max(sequence) FROM session_events UNION ALL SELECT max(sequence) FROM grades "
        "UNION ALL SELECT max(sequence) FROM scenario_versions UNION ALL SELECT max(sequence) FROM assignments "
        "UNION ALL SELECT max(sequence) FROM comments UNION ALL SELECT max(sequence) FROM statements "
        "UNION ALL SELECT max(sequence) FROM version_withdrawals UNION ALL SELECT max(sequence) FROM adjustments "
        "UNION ALL SELECT max(sequence) FROM assignment_withdrawals)",
        [](Row row) { return row.integer(0); });
    check_single_row("station");
    const bool given_twice = used && used->value_or(0) >= (*station)->second;
    if (given_twice || log_.sequence_fell) find(FindingCode::count_wrong, "station", station_, "next_sequence");
  }

  void check_keys() {
    const auto keys = db_.all("SELECT id, public_key FROM station_keys", [](Row row) {
      return std::pair{row.hash(0), row.hash(1)};
    });
    if (!readable(keys, "station_keys")) return;
    std::set<std::string> there;
    for (const auto& [id, key] : *keys) {
      there.insert(hex(id));
      if (key_id(key) != id) find(FindingCode::key_changed, "station_keys", {}, hex(id));
      if (!log_.keys.contains(hex(id))) find(FindingCode::row_added, "station_keys", {}, hex(id));
    }
    for (const auto& [name, added] : log_.keys) {
      // A key that was added twice had been deleted in between.
      if (!there.contains(name) || added.size() > 1) {
        find(FindingCode::row_missing, "station_keys", {}, name, added.back());
      }
    }
  }

  Stored<void> check_sessions() {
    const auto ids = watched([this] { return sessions_to_verify(context_); });
    if (steps_.stopped()) return {};
    if (!ids) return std::unexpected(ids.error());
    steps_.begin(ids->size());
    std::set<Uuid> there;
    for (const SessionId id : *ids) {
      if (!steps_.go_on()) return {};
      there.insert(id.uuid);
      const auto proof = verify_session(context_, id);
      if (!proof) return std::unexpected(proof.error());
      for (ChainFinding finding : proof->findings) {
        finding.owner = id.uuid;
        out_.findings.push_back(std::move(finding));
      }
      check_seals(id, *proof);
      steps_.add_done();
      out_.sessions = steps_.done();
    }
    for (const auto& [id, seals] : log_.sessions) {
      if (there.contains(id)) continue;
      find(FindingCode::row_missing, "sessions", id, {}, seals.back().at_utc_us);
      gone_.insert(id);
    }
    return {};
  }

  /// The log has seals of the session; if its own chain holds, every seal matches a link of the chain.
  void check_seals(SessionId id, const Verification& proof) {
    const auto seals = log_.sessions.find(id.uuid);
    if (seals == log_.sessions.end()) {
      if (sealed()) find(FindingCode::row_added, "sessions", id.uuid);
      return;
    }
    if (!proof.intact()) return;
    for (const SessionSeal& seal : seals->second) {
      const auto same = db_.first(
          "SELECT link = ?3 FROM session_chain WHERE session = ?1 AND position = ?2",
          [](Row row) { return row.flag(0); }, id, seal.head.links - 1, seal.head.link);
      if (same && same->value_or(false)) continue;
      const auto row = static_cast<std::int64_t>(std::min(proof.links, seal.head.links));
      out_.findings.push_back({FindingCode::seal_broken, "session_chain", row, -1, id.uuid, {}, seal.at_utc_us});
      return;
    }
  }

  /// A session with findings of its own gives none here: its records decide.
  void check_summaries() {
    std::set<Uuid> named;
    for (const ChainFinding& finding : out_.findings) named.insert(finding.owner);
    const auto report = [&](const SummaryDifference& difference) {
      const Uuid& id = difference.session.uuid;
      if (named.contains(id)) return;
      switch (difference.kind) {
        case SummaryDifference::Kind::missing:
          return find(FindingCode::row_missing, "session_summaries", id);
        case SummaryDifference::Kind::added:
          return find(FindingCode::row_added, "session_summaries", id);
        case SummaryDifference::Kind::column:
          return find(FindingCode::summary_differs, "session_summaries", id, std::string(difference.column));
      }
    };
    if (!compare_summaries(db_, report)) find(FindingCode::unreadable, "session_summaries");
  }

  /// Where a summary differs from its records, it is the finding: what follows from it would differ too.
  void check_packed() {
    if (std::ranges::any_of(out_.findings, [](const ChainFinding& f) { return f.table == "session_summaries"; })) return;
    const auto report = [&](const PackedDifference& difference) {
      const Uuid& id = difference.scenario.uuid;
      switch (difference.kind) {
        case PackedDifference::Kind::missing:
          return find(FindingCode::row_missing, "packed_attempts", id);
        case PackedDifference::Kind::added:
          return find(FindingCode::row_added, "packed_attempts", id);
        case PackedDifference::Kind::changed:
          return find(FindingCode::summary_differs, "packed_attempts", id);
      }
    };
    if (!compare_packed(db_, report)) find(FindingCode::unreadable, "packed_attempts");
  }

  void check_accounts() {
    const auto accounts =
        db_.all(kSelectSealedAccounts, [](Row row) { return std::pair{row.uuid(0), account_seal(row)}; });
    if (!readable(accounts, "people")) return;
    std::set<Uuid> there;
    for (const auto& [id, seal] : *accounts) {
      there.insert(id);
      const auto last = log_.accounts.find(id);
      if (!log_.accounts_created.contains(id) || (sealed() && last == log_.accounts.end())) {
        find(FindingCode::row_added, "people", id);
        continue;
      }
      if (last == log_.accounts.end()) continue;
      const AccountSeal& logged = last->second.seal;
      // A secret salts the hash of number and name: if a secret was changed, those two cannot be compared.
      const bool same_secrets = seal[3] == logged[3] && seal[4] == logged[4];
      for (std::size_t i = 0; i < seal.size(); ++i) {
        if (seal[i] == logged[i] || (i == 5 && !same_secrets)) continue;
        find(FindingCode::row_changed, "people", id, std::string(kAccountSealFields[i]), last->second.at_utc_us);
      }
    }
    for (const auto& [id, last] : log_.accounts) {
      if (!there.contains(id)) find(FindingCode::row_missing, "people", id, {}, last.at_utc_us);
    }
  }

  void check_comments() {
    auto left = log_.comments;
    const auto rows = row_seals(db_, SealedTable::comments);
    if (!readable(rows, "comments")) return;
    for (const auto& [session, seal] : *rows) {
      const auto last = left.find({session, seal});
      if (last != left.end() && last->second.seal > 0) {
        --last->second.seal;
      } else if (sealed()) {
        find(FindingCode::row_added, "comments", session);
      }
    }
    for (const auto& [key, last] : left) {
      // If the session is gone, that finding covers its comments.
      if (last.seal > 0 && !gone_.contains(key.first)) {
        find(FindingCode::row_missing, "comments", key.first, {}, last.at_utc_us);
      }
    }
  }

  Stored<void> add_statement_findings() {
    auto found = check_statements(db_);
    if (!found) return std::unexpected(found.error());
    std::erase_if(*found, [this](const ChainFinding& finding) {
      const auto statement = Uuid::parse(finding.what);
      return finding.code == FindingCode::row_missing && finding.table == "statement_texts" && statement &&
             log_.statements_erased.contains(*statement);
    });
    out_.findings.insert(out_.findings.end(), found->begin(), found->end());
    return {};
  }

  void check_members() {
    const auto rows = db_.all("SELECT cohort, student FROM cohort_students", [](Row row) {
      return std::pair{row.uuid(0), row.uuid(1)};
    });
    if (!readable(rows, "cohort_students")) return;
    const std::set<std::pair<Uuid, Uuid>> there(rows->begin(), rows->end());
    for (const auto& member : there) {
      const auto last = log_.members.find(member);
      if (last == log_.members.end() || !last->second.seal) {
        find(FindingCode::row_added, "cohort_students", member.first, member.second.text());
      }
    }
    for (const auto& [member, last] : log_.members) {
      if (last.seal && !there.contains(member)) {
        find(FindingCode::row_missing, "cohort_students", member.first, member.second.text(), last.at_utc_us);
      }
    }
  }

  void check_rows(SealedTable table) {
    if (table == SealedTable::comments) return;  // by session, in check_comments()
    const auto& logged = log_.rows[static_cast<std::size_t>(table)];
    const auto rows = row_seals(db_, table);
    if (!readable(rows, name_of(table))) return;
    std::set<Uuid> there;
    for (const auto& [id, seal] : *rows) {
      there.insert(id);
      const auto last = logged.find(id);
      if (last == logged.end()) {
        if (sealed()) find(FindingCode::row_added, name_of(table), id);
      } else if (last->second.seal != seal) {
        find(FindingCode::row_changed, name_of(table), id, {}, last->second.at_utc_us);
      }
    }
    for (const auto& [id, last] : logged) {
      if (!there.contains(id)) find(FindingCode::row_missing, name_of(table), id, {}, last.at_utc_us);
    }
  }

  /// A blob's id is its content hash. A blob that no row names affects no result: it gives no finding if it is gone.
  void check_blobs() {
    const auto blobs = db_.all("SELECT hash, packed FROM blobs", [](Row row) {
      const auto bytes = unpack(row.bytes(1));
      return std::pair{row.hash(0), bytes && blake2b_256(*bytes) == row.hash(0)};
    });
    if (!readable(blobs, "blobs")) return;
    for (const auto& [hash, good] : *blobs) {
      if (!good) find(FindingCode::row_changed, "blobs", {}, hex(hash));
    }
    const auto lost = db_.all(
        "SELECT f.version, f.blob FROM version_files f LEFT JOIN blobs b ON b.hash = f.blob WHERE b.hash IS NULL",
        [](Row row) {
          return std::pair{row.uuid(0), row.hash(1)};
        });
    if (!readable(lost, "version_files")) return;
    for (const auto& [version, hash] : *lost) find(FindingCode::row_missing, "blobs", version, hex(hash));
  }

  StorageContext& context_;
  Database& db_;
  Uuid station_;
  SealIndex log_;
  std::set<Uuid> gone_;  // sessions that the log has and no table has
  WorkSteps steps_;
  StoreVerification out_;
};

}  // namespace

Stored<StoreVerification> verify_store(StorageContext& context, const WorkWatch& watch) { return StoreVerifier(context, watch).verify(); }

}  // namespace cusp::storage
