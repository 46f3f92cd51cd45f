#include "storage/retention/clock_doubt.h"

#include <string>

namespace cusp::storage {

namespace {

struct AroundPause {
  std::optional<std::int64_t> before, after;
};

std::optional<StorageFailure> doubt_since(const char* where, std::int64_t before, std::int64_t now) {
  return StorageFailure{StorageError::clock_ahead, where, std::to_string(before) + ' ' + std::to_string(now)};
}

}  // namespace

Stored<std::optional<StorageFailure>> clock_doubt(StorageContext& context) {
  const std::int64_t now = context.clock();
  const auto newest = context.db.first(
      "SELECT max(coalesce((SELECT max(started_at) FROM sessions WHERE started_at <= ?1), 0), "
      "coalesce((SELECT max(created_at) FROM people WHERE created_at <= ?1), 0))",
      [](Row row) { return row.integer(0); }, now);
  if (!newest) return std::unexpected(newest.error());
  const std::int64_t last = newest->value_or(0);
  if (last == 0) return std::optional<StorageFailure>{};
  if (now - last > kLongestPause_us) return doubt_since("clock", last, now);
  const auto found = context.db.first(
      "SELECT max(at) FILTER (WHERE at <= ?2), min(at) FILTER (WHERE at > ?2) FROM "
      "(SELECT started_at AS at FROM sessions UNION ALL SELECT created_at FROM people) WHERE at > 0 AND at <= ?1",
      [](Row row) { return AroundPause{row.maybe_integer(0), row.maybe_integer(1)}; }, now, last - kShortestUse_us);
  if (!found) return std::unexpected(found.error());
  const AroundPause around = found->value_or(AroundPause{});
  if (!around.before || !around.after || *around.after - *around.before <= kLongestPause_us) return std::optional<StorageFailure>{};
  return doubt_since("pause", *around.before, now);
}

}  // namespace cusp::storage
