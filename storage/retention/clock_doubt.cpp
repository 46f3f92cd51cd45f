#include "storage/retention/clock_doubt.h"

#include <string>

namespace cusp::storage {

Stored<std::optional<StorageFailure>> clock_doubt(StorageContext& context) {
  const std::int64_t now = context.clock();
  const auto newest = context.db.first(
      "SELECT max(coalesce((SELECT max(started_at) FROM sessions WHERE started_at <= ?1), 0), "
      "coalesce((SELECT max(created_at) FROM people WHERE created_at <= ?1), 0))",
      [](Row row) { return row.integer(0); }, now);
  if (!newest) return std::unexpected(newest.error());
  const std::int64_t before = newest->value_or(0);
  if (before == 0 || now - before <= kLongestPause_us) return std::optional<StorageFailure>{};
  return std::optional(StorageFailure{StorageError::clock_ahead, "clock", std::to_string(before) + ' ' + std::to_string(now)});
}

}  // namespace cusp::storage
