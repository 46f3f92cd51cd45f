/// Verifies stored sessions: every row's hash, the order of the chain, the signature over its head, counts and ticks, and
/// the scenario version and specimen that the session names. A change of one byte anywhere gives a finding.
/// Thread: the database's own. Works read-only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/base/watch.h"
#include "storage/records/context.h"

namespace cusp::storage {

enum class FindingCode : std::uint8_t {
  row_changed,      // its content differs from its hash in the chain
  row_missing,      // the chain has an entry, the table has no row
  row_added,        // the table has a row, the chain has no entry
  link_broken,      // an entry of the chain itself was changed
  head_broken,      // count, link or signature of the head does not hold: changed, or a tail was cut off
  key_changed,      // the public key that the head names is missing or differs
  unreadable,       // SQLite cannot read the table, or a blob cannot be unpacked
  count_wrong,      // ticks or numbers have gaps, or a chunk holds another number of inputs than its row counts
  seal_broken,      // the chain holds, but differs from the audit log's seal: an old state restored, or a forged one
  rolled_back,      // the log lacks what the rollback counter saw: an older file, or a log cut or replaced
  counter_missing,  // the counter's file is gone, and the log has seals
  counter_broken,   // the file is no counter, of another station, or its signature does not hold
  log_damaged,      // the log's head did not hold when the program appended to it
  summary_differs,  // a column of session_summaries differs from the records, `what` names it; or packed_attempts from these
};
std::string_view key_of(FindingCode code) noexcept;

/// What a verification found. `owner` names the session, user, cohort, assignment or version.
struct ChainFinding {
  FindingCode code = FindingCode::row_changed;
  std::string table{};         // "trace_chunks", "criteria", "session_chain", "people", ...
  std::int64_t row = -1;       // number within the session or the log (chunk, position, entry); -1 = none
  std::int64_t second = -1;    // second of the session; -1 = not of one moment
  Uuid owner{};                // nil = none
  std::string what{};          // code of what differs: "role", "password", a hash, a name in the schema; empty = all
  std::int64_t at_utc_us = 0;  // of its newest seal in the log; 0 = unknown
};

struct Verification {
  std::vector<ChainFinding> findings;  // empty = intact; the first is the one to report
  std::uint64_t links = 0, chunks = 0, inputs = 0;
  bool intact() const noexcept { return findings.empty(); }
};

/// not_found if no table holds a row of this session. Names and comments are not covered.
Stored<Verification> verify_session(StorageContext& context, SessionId session);

/// The audit log alone: its chain and head. table = "audit_log", row = entry number.
Stored<Verification> verify_audit_log(StorageContext& context);

struct StoreVerification {
  std::vector<ChainFinding> findings;  // the log's own first
  std::uint64_t sessions = 0, entries = 0;  // verified
  bool stopped = false;                     // the watch ended it: what was not verified has no findings
  std::optional<std::int64_t> sealed_since_utc_us;  // none: never opened for writing since seals exist
  std::uint64_t sealed_later = 0;  // rows from before, sealed as they stood at that moment
  std::uint64_t uncounted = 0;     // entries that the rollback counter has not seen yet
  bool intact() const noexcept { return findings.empty() && !stopped; }
};

/// Verifies the log, its counter, every session, and all that the log seals: accounts, cohorts, assignments, comments,
/// statements, versions, blobs, keys, and every summary against its records. tests/storage/harmless.cpp lists what it cannot find.
/// `watch`: before each session and after the last; 0 of 0 while the log is read, all of all before each other table.
Stored<StoreVerification> verify_store(StorageContext& context, const WorkWatch& watch = {});

/// Every session that any table names.
Stored<std::vector<SessionId>> sessions_to_verify(StorageContext& context);

}  // namespace cusp::storage
