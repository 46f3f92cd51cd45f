#include "storage/backup/young_backup.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace cusp::storage {
namespace {

constexpr std::int64_t kSetBack_us = 3'600'000'000;  // an hour: a clock that is corrected, or knows no summer time, goes back by no more

/// By the order of the log: its dates alone would take a backup of an earlier start for one of today.
Stored<bool> young_in_log(StorageContext& context, std::int64_t now_utc_us, std::int64_t age_us) {
  Statement newest_first = context.db.prepare("SELECT at, action = 'backed_up' AND actor = ?1 FROM audit_log ORDER BY number DESC");
  newest_first.bind(UserId{});
  std::int64_t earliest = now_utc_us;  // of what follows the entry
  while (true) {
    const auto more = newest_first.step();
    if (!more) return std::unexpected(more.error());
    if (!*more) return false;
    const std::int64_t at = newest_first.row().integer(0);
    if (at <= now_utc_us - age_us || at - earliest > kSetBack_us) return false;
    if (newest_first.row().flag(1)) return true;
    earliest = std::min(earliest, at);
  }
}

}  // namespace

Stored<std::optional<Backup>> young_daily_backup(StorageContext& context, const std::filesystem::path& into, std::int64_t age_us) {
  const std::int64_t now = context.clock();
  const auto logged = young_in_log(context, now, age_us);
  if (!logged) return std::unexpected(logged.error());
  if (!*logged) return std::optional<Backup>{};
  auto all = backups_in(into, context.station);
  if (!all) return std::optional<Backup>{};
  const auto young = std::ranges::find_if(*all, [&](const Backup& one) { return one.kind == BackupKind::daily && std::abs(now - one.made_utc_us) < age_us; });
  return young == all->end() ? std::optional<Backup>{} : std::optional(std::move(*young));
}

}  // namespace cusp::storage
