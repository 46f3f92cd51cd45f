/// One row a session with what lists and charts need: the table session_summaries. It is derived: each row follows from
/// the records, is written in the transaction of the row that it follows, and can be rebuilt. Verification compares both.
/// packed_attempts.h follows the summaries in the same way, by these functions.
/// Thread: the database's own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "storage/base/rights.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// After the row of `sessions` and its event "started". Attempts that started later count one more.
void add_summary(Transaction& transaction, SessionId session);
/// After a row of `trace_chunks`. `elapsed_us`: of the whole trace.
void follow_second(Transaction& transaction, SessionId session, std::uint64_t elapsed_us);
/// After an event, a grade or a statement: state and result as they count (effective_grade.h).
void follow_event(Transaction& transaction, SessionId session);
/// The same without the packed attempts: follow_graded() follows many sessions at once. False if the summary stays as it was.
bool follow_result(Transaction& transaction, SessionId session);

struct SummaryDifference {
  enum class Kind : std::uint8_t {
    missing,  // a session without a summary
    added,    // a summary without a session
    column,   // `column` differs from the records
  };
  Kind kind = Kind::column;
  SessionId session;
  std::string_view column{};  // a column's name, valid for good; empty unless kind is column
};

/// Calls `each` for every difference between summaries and records, by session. A session whose scenario version is missing
/// is passed over: the verifier names the version.
Stored<void> compare_summaries(Database& db, const std::function<void(const SummaryDifference&)>& each);

/// Writes every summary and the packed attempts anew from the records and adds an entry to the audit log. Needs manage_station, also as the
/// records have it now.
/// Returns how many differences there were.
Stored<std::uint64_t> rebuild_summaries(StorageContext& context, const Actor& actor);

}  // namespace cusp::storage
