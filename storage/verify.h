/// Proves that what is stored of a session is what was recorded: every row's hash, the order of the chain, the
/// signature over its head, counts and ticks, and the scenario version and specimen it names. One byte changed anywhere
/// is found and named.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/context.h"

namespace cusp {

enum class FindingCode : std::uint8_t {
  row_changed,  // its content is not what the chain says
  row_missing,  // the chain has it, the table has not
  row_added,    // the table has it, the chain has not
  link_broken,  // an entry of the chain itself was changed
  head_broken,  // count, link or signature of the head do not hold: changed, or a tail was cut off
  key_changed,  // the public key that the head names is not there or is another
  unreadable,   // SQLite cannot read the table, or a blob cannot be unfolded
  count_wrong,  // ticks do not follow each other, or a chunk holds another number of inputs than it says
};
std::string_view key_of(FindingCode code) noexcept;

/// Not "Finding": scenarios/format has one of its own in this namespace.
struct ChainFinding {
  FindingCode code = FindingCode::row_changed;
  std::string table;         // "trace_chunks", "criteria", "session_chain", ...
  std::int64_t row = -1;     // number within the session (chunk number, position in the chain); -1 = none
  std::int64_t second = -1;  // second of the session; -1 = not of one moment
};

struct Verification {
  std::vector<ChainFinding> findings;  // empty = intact; the first is the one to tell
  std::uint64_t links = 0, chunks = 0, inputs = 0;
  bool intact() const noexcept { return findings.empty(); }
};

/// not_found when nothing at all is stored of this session. Works read-only. Does not look at names or comments.
Stored<Verification> verify_session(StorageContext& context, SessionId session);

/// The audit log: its chain and head. table = "audit_log", row = entry number.
Stored<Verification> verify_audit_log(StorageContext& context);

/// Every session that any table mentions.
Stored<std::vector<SessionId>> sessions_to_verify(StorageContext& context);

}  // namespace cusp
