/// Graded attempts as figures read them: the table packed_attempts. A row holds the listed, graded attempts of one scenario and
/// device class that started within one period. It is derived from session_summaries, written in the transaction of the
/// summary that it follows, and can be rebuilt. Verification compares both. Thread: the database's own.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string_view>

#include "storage/records/context.h"
#include "storage/sqlite/packed_attempt.h"

namespace cusp::storage {

/// The period of a moment; one lasts 2^39 µs, 6.4 days. Of a busy school a row then holds some hundred attempts: enough that a
/// million attempts are few rows, and few enough to write them anew with each grade.
constexpr std::int64_t period_of(std::int64_t utc_us) noexcept { return utc_us >> 39; }

/// Writes the row anew that the session's attempt belongs to. After a change of its summary that has a score.
void follow_graded(Transaction& transaction, SessionId session);
/// The same for many sessions: each row once.
void follow_graded(Transaction& transaction, const std::set<SessionId>& sessions);
/// Writes every row anew.
void rebuild_packed(Transaction& transaction);

struct PackedDifference {
  enum class Kind : std::uint8_t { missing, added, changed };
  Kind kind = Kind::changed;
  ScenarioId scenario;
};
/// Calls `each` for every row that differs from the summaries, by scenario.
Stored<void> compare_packed(Database& db, const std::function<void(const PackedDifference&)>& each);

}  // namespace cusp::storage
