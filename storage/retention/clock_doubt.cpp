#include "storage/retention/clock_doubt.h"

#include <algorithm>
#include <string>

namespace cusp::storage {

namespace {

struct AroundPause {
  std::optional<std::int64_t> before, after;

  bool doubts() const noexcept { return before && after && *after - *before > kLongestPause_us; }
};

AroundPause around_pause(Row row) { return {row.maybe_integer(0), row.maybe_integer(1)}; }

std::optional<StorageFailure> doubt_of(const char* where, const std::string& dates) {
  return StorageFailure{StorageError::clock_ahead, where, dates};
}

std::optional<StorageFailure> doubt_of_pause(const AroundPause& around, std::int64_t now) {
  const std::int64_t before = around.before.value_or(0), after = around.after.value_or(0);
  return doubt_of("pause", std::to_string(before) + ' ' + std::to_string(now) + ' ' + std::to_string(after));
}

/// The newest one that ended after `since`. What was read from other stations would fill a gap of the dates: the log has those of this
/// station's clock alone.
Stored<AroundPause> gap_in_log(StorageContext& context, std::int64_t now, std::int64_t since) {
  AroundPause out;
  std::optional<std::int64_t> newest;
  const auto read = context.db.all("SELECT at FROM audit_log WHERE at <= ?1 ORDER BY number", [&](Row row) {
    const AroundPause gap{newest, row.integer(0)};
    if (*gap.after > since && gap.doubts()) out = gap;
    newest = std::max(newest.value_or(*gap.after), *gap.after);
    return true;
  }, now);
  if (!read) return std::unexpected(read.error());
  return out;
}

}  // namespace

Stored<std::optional<StorageFailure>> clock_doubt(StorageContext& context, std::int64_t age_us) {
  const std::int64_t now = context.clock();
  const auto newest = context.db.first(
      "SELECT max(coalesce((SELECT max(started_at) FROM sessions WHERE started_at <= ?1), 0), "
      "coalesce((SELECT max(created_at) FROM people WHERE created_at <= ?1), 0))",
      [](Row row) { return row.integer(0); }, now);
  if (!newest) return std::unexpected(newest.error());
  const std::int64_t last = newest->value_or(0);
  if (last == 0) return std::optional<StorageFailure>{};
  if (now - last > kLongestPause_us) return doubt_of("clock", std::to_string(last) + ' ' + std::to_string(now));
  const auto used = context.db.first(
      "SELECT max(at) FILTER (WHERE at <= ?2), min(at) FILTER (WHERE at > ?2) FROM "
      "(SELECT started_at AS at FROM sessions UNION ALL SELECT created_at FROM people) WHERE at > 0 AND at <= ?1",
      around_pause, now, last - kShortestUse_us);
  if (!used) return std::unexpected(used.error());
  if (const AroundPause around = used->value_or(AroundPause{}); around.doubts()) return doubt_of_pause(around, now);
  const auto logged = gap_in_log(context, now, now - std::max(age_us, kShortestUse_us));
  if (!logged) return std::unexpected(logged.error());
  if (logged->doubts()) return doubt_of_pause(*logged, now);
  return std::optional<StorageFailure>{};
}

}  // namespace cusp::storage
