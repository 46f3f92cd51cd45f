/// Proves that what is stored of a session is what was recorded: every row's hash, the order of the chain, the
/// signature over its head, counts and ticks, and the scenario version and specimen it names. One byte changed anywhere
/// is found and named.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/context.h"

namespace cusp::storage {

enum class FindingCode : std::uint8_t {
  row_changed,      // its content is not what the chain says
  row_missing,      // the chain has it, the table has not
  row_added,        // the table has it, the chain has not
  link_broken,      // an entry of the chain itself was changed
  head_broken,      // count, link or signature of the head do not hold: changed, or a tail was cut off
  key_changed,      // the public key that the head names is not there or is another
  unreadable,       // SQLite cannot read the table, or a blob cannot be unfolded
  count_wrong,      // ticks or numbers do not follow each other, or a chunk holds another number of inputs than it says
  seal_broken,      // sound in itself, but not what the audit log sealed: put back as it was before, or made anew
  rolled_back,      // the log lacks what the rollback counter saw: an older file, or a log that was cut or replaced
  counter_missing,  // the counter's file is gone although entries were counted
  counter_broken,   // it is no counter, of another station, or its signature does not hold
  log_damaged,      // the log's head did not hold when the program wanted to go on from it
};
std::string_view key_of(FindingCode code) noexcept;

/// Not "Finding": scenarios/format has one of its own in this namespace.
struct ChainFinding {
  FindingCode code = FindingCode::row_changed;
  std::string table{};         // "trace_chunks", "criteria", "session_chain", "people", ...
  std::int64_t row = -1;       // number within the session or the log (chunk, position, entry); -1 = none
  std::int64_t second = -1;    // second of the session; -1 = not of one moment
  Uuid owner{};                // the session, person, cohort, assignment or version; nil = none
  std::string what{};          // code of what differs: "role", "password", a hash, a name in the schema; empty = all
  std::int64_t at_utc_us = 0;  // of the log's last word on it; 0 = not known
};

struct Verification {
  std::vector<ChainFinding> findings;  // empty = intact; the first is the one to tell
  std::uint64_t links = 0, chunks = 0, inputs = 0;
  bool intact() const noexcept { return findings.empty(); }
};

/// not_found when nothing at all is stored of this session. Works read-only. Does not look at names or comments.
Stored<Verification> verify_session(StorageContext& context, SessionId session);

/// The audit log alone: its chain and head. table = "audit_log", row = entry number.
Stored<Verification> verify_audit_log(StorageContext& context);

struct StoreVerification {
  std::vector<ChainFinding> findings;  // the log's own first
  std::uint64_t sessions = 0, entries = 0;
  std::optional<std::int64_t> sealed_since_utc_us;  // none: not yet, the file was never opened for writing since
  std::uint64_t sealed_later = 0;  // rows that were there before: held against what they were at that moment
  std::uint64_t uncounted = 0;     // entries that the rollback counter has not seen yet
  bool intact() const noexcept { return findings.empty(); }
};

/// Everything: the log, its counter, every session, and what the log says of people, cohorts, assignments, comments,
/// versions, blobs and keys. Works read-only. What it cannot find stands in tests/storage/harmless.cpp.
Stored<StoreVerification> verify_store(StorageContext& context);

/// Every session that any table mentions.
Stored<std::vector<SessionId>> sessions_to_verify(StorageContext& context);

}  // namespace cusp::storage
