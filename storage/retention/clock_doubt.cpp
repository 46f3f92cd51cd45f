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

namespace {

/// Whether the entries after this number lie so far apart, leaving out those that are dated later than `latest_utc_us`.
Stored<bool> used_since(StorageContext& context, std::int64_t sequence, std::int64_t latest_utc_us) {
  Statement newest_first = context.db.prepare("SELECT at, sequence FROM audit_log ORDER BY number DESC");
  newest_first.bind();
  std::int64_t earliest = INT64_MAX, newest = INT64_MIN;
  while (true) {
    const auto more = newest_first.step();
    if (!more) return std::unexpected(more.error());
    if (!*more || newest_first.row().integer(1) <= sequence) return false;
    const std::int64_t at = newest_first.row().integer(0);
    if (at > latest_utc_us) continue;
    earliest = std::min(earliest, at);
    newest = std::max(newest, at);
    if (newest - earliest >= kShortestUse_us) return true;
  }
}

struct LateAttempt {
  std::int64_t at_utc_us = 0, sequence = 0;
};

}  // namespace

Stored<std::optional<std::int64_t>> clock_behind(StorageContext& context) {
  constexpr std::int64_t kDay = 86'400'000'000;
  const std::int64_t latest = context.clock() + kDay;
  const auto late = context.db.first(
      "SELECT m.started_at, m.sequence FROM session_summaries m INDEXED BY summaries_by_time JOIN sessions s ON s.id = m.session "
      "WHERE m.listed = 1 AND m.started_at > ?1 AND s.station = ?2 ORDER BY m.started_at DESC LIMIT 1",
      [](Row row) { return LateAttempt{row.integer(0), row.integer(1)}; }, latest, context.station);
  if (!late) return std::unexpected(late.error());
  if (!*late) return std::optional<std::int64_t>{};
  const auto used = used_since(context, (*late)->sequence, latest);
  if (!used) return std::unexpected(used.error());
  return *used ? std::optional<std::int64_t>{} : std::optional((*late)->at_utc_us);
}

}  // namespace cusp::storage
