#include "ui/admin/backup_work.h"

#include <algorithm>
#include <utility>

#include "storage/base/clock.h"
#include "storage/base/locked_folder.h"
#include "storage/store.h"
#include "ui/session/records_task.h"

namespace cusp::ui {
namespace {

/// Of this station in the folder. One that a wrong clock dated in the future does not count.
std::optional<Backup> newest_daily(const std::filesystem::path& into, const Uuid& station, std::int64_t now_utc_us) {
  auto all = backups_in(into, station);
  if (!all) return std::nullopt;
  const auto newest = std::ranges::find_if(*all, [&](const Backup& one) { return one.kind == BackupKind::daily && one.made_utc_us <= now_utc_us; });
  return newest == all->end() ? std::nullopt : std::optional(std::move(*newest));
}

bool is_of_today(const std::optional<Backup>& newest, std::int64_t now_utc_us) { return newest && now_utc_us - newest->made_utc_us < kBackupEveryUs; }

Stored<BackedUp> back_up_and_thin(const RecordsBeside& records, const std::filesystem::path& into, const std::optional<Actor>& actor,
                                  const WorkWatch& watch) {
  const auto store = open_beside(records);
  if (!store) return std::unexpected(store.error());
  StorageContext& context = (*store)->context();
  // Of two programs that find the daily one due, the second waits, and takes that of the first: two a day would halve the days that are kept.
  std::optional<LockedFolder> alone;
  if (!actor) {
    alone.emplace(into, FolderLock::alone);
    const std::int64_t now = context.clock();
    if (auto newest = newest_daily(into, context.station, now); is_of_today(newest, now)) return BackedUp{std::move(*newest), std::nullopt};
  }
  auto backup = make_backup(context, actor, into, watch);
  if (!backup) return std::unexpected(backup.error());
  BackedUp out{std::move(*backup), std::nullopt};
  if (auto thinned = thin_backups(into, out.backup.station, out.backup.kind, kBackupsKept, out.backup.made_utc_us); !thinned) out.not_removed = std::move(thinned.error());
  return out;
}

/// The store is closed before the database gets its name.
Stored<void> log_in_copy(const Backup& backup, const std::filesystem::path& database) {
  StoreOptions options;
  options.database.access = DatabaseOptions::Access::existing;
  const auto store = Store::open(database, options);
  if (!store) return std::unexpected(store.error());
  return log_restored((*store)->context(), backup);
}

Stored<WentBack> put_in_place(const std::filesystem::path& database, const Backup& backup) {
  auto aside = restore_in_place(backup, database, system_utc_us(),
                                [&backup](const std::filesystem::path& copy) { return log_in_copy(backup, copy); });
  if (!aside) return std::unexpected(aside.error());
  return WentBack{backup, std::move(*aside)};
}

}  // namespace

BackgroundTask go_back(std::filesystem::path database, Backup backup, std::function<void(Stored<WentBack>)> then) {
  return BackgroundTask([database = std::move(database), backup = std::move(backup), then = std::move(then)] { then(put_in_place(database, backup)); });
}

BackgroundTask back_up(RecordsBeside records, std::filesystem::path into, std::optional<Actor> actor,
                       std::function<void(Stored<BackedUp>)> then, std::shared_ptr<WorkProgress> progress) {
  return BackgroundTask([records = std::move(records), into = std::move(into), actor, then = std::move(then), watch = watch_of(std::move(progress))] {
    then(back_up_and_thin(records, into, actor, watch));
  });
}

BackgroundTask verify_records(RecordsBeside records, std::function<void(Stored<StoreVerification>)> then,
                              std::shared_ptr<WorkProgress> progress) {
  return BackgroundTask([records = std::move(records), then = std::move(then), watch = watch_of(std::move(progress))] {
    const auto store = open_beside(records);
    then(store ? verify_store((*store)->context(), watch) : Stored<StoreVerification>(std::unexpected(store.error())));
  });
}

BackgroundTask verify_log(RecordsBeside records, const Actor& actor, std::shared_ptr<LogProgress> progress,
                          std::function<void(Stored<Verification>)> then) {
  return BackgroundTask([records = std::move(records), actor, progress = std::move(progress), then = std::move(then)] {
    const auto store = open_beside(records.for_reading());
    if (!store) return then(std::unexpected(store.error()));
    then((*store)->audit.verify(actor, [&progress](std::int64_t number) { progress->holding = number + 1; }));
  });
}

bool backup_is_due(const std::filesystem::path& into, const Uuid& station, std::int64_t now_utc_us) {
  return !is_of_today(newest_daily(into, station, now_utc_us), now_utc_us);
}

}  // namespace cusp::ui
