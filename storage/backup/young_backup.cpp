#include "storage/backup/young_backup.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace cusp::storage {
namespace {

constexpr std::int64_t kSetBack_us = 3'600'000'000;       // an hour: a clock that is corrected, or knows no summer time, goes back by no more
constexpr std::int64_t kHalfDay_us = 12 * kSetBack_us;     // that a clock without a battery is used before it is set, at most
constexpr std::int64_t kMonth_us = 30 * 2 * kHalfDay_us;  // by which such a clock is behind, at least

/// The date in the log of the newest daily backup, if it is younger than the age. It goes by the order of the log: its dates alone would take a
/// backup of an earlier start for one of today.
Stored<std::optional<std::int64_t>> young_in_log(StorageContext& context, std::int64_t now_utc_us, std::int64_t age_us) {
  Statement newest_first = context.db.prepare("SELECT at, action = 'backed_up' AND actor = ?1 FROM audit_log ORDER BY number DESC");
  newest_first.bind(UserId{});
  std::int64_t earliest = now_utc_us;           // of what follows the entry
  std::optional<std::int64_t> behind, backup;  // the newest date of a clock that was months behind; that of a backup under this clock
  while (true) {
    const auto more = newest_first.step();
    if (!more) return std::unexpected(more.error());
    if (!*more) return std::optional<std::int64_t>{};
    const std::int64_t at = newest_first.row().integer(0);
    const bool is_backup = newest_first.row().flag(1);
    if (at < now_utc_us - kMonth_us) {
      if (behind && (at > *behind + kSetBack_us || at < *behind - kHalfDay_us)) return std::optional<std::int64_t>{};
      if (!behind) behind = at;
      if (is_backup && !backup) backup = at;
      continue;
    }
    if (at <= now_utc_us - age_us || at - earliest > kSetBack_us) return std::optional<std::int64_t>{};
    if (backup) return backup;  // made after this entry, whatever its date
    if (is_backup) return std::optional(at);
    earliest = std::min(earliest, at);
    behind.reset();
  }
}

}  // namespace

Stored<std::optional<Backup>> young_daily_backup(StorageContext& context, const std::filesystem::path& into, std::int64_t age_us) {
  const auto logged = young_in_log(context, context.clock(), age_us);
  if (!logged) return std::unexpected(logged.error());
  if (!*logged) return std::optional<Backup>{};
  auto all = backups_in(into, context.station);
  if (!all) return std::optional<Backup>{};
  const auto young = std::ranges::find_if(*all, [&](const Backup& one) { return one.kind == BackupKind::daily && std::abs(**logged - one.made_utc_us) < age_us; });
  return young == all->end() ? std::optional<Backup>{} : std::optional(std::move(*young));
}

}  // namespace cusp::storage
