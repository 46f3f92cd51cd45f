#include "ui/admin/backup_work.h"

#include <utility>

#include "storage/backup/young_backup.h"
#include "storage/base/clock.h"
#include "storage/base/locked_folder.h"
#include "storage/store.h"
#include "ui/session/records_task.h"

namespace cusp::ui {
namespace {

Stored<BackedUp> back_up_and_thin(StorageContext& context, const std::filesystem::path& into, const std::optional<Actor>& actor,
                                  const WorkWatch& watch) {
  auto backup = make_backup(context, actor, into, watch);
  if (!backup) return std::unexpected(backup.error());
  BackedUp out{std::move(*backup)};
  if (auto thinned = thin_backups(into, out.backup.station, out.backup.kind, kBackupsKept, out.backup.made_utc_us); !thinned) out.not_removed = std::move(thinned.error());
  return out;
}

Stored<BackedUp> back_up_on_demand(const RecordsBeside& records, const std::filesystem::path& into, const Actor& actor, const WorkWatch& watch) {
  const auto store = open_beside(records);
  if (!store) return std::unexpected(store.error());
  return back_up_and_thin((*store)->context(), into, actor, watch);
}

/// nullopt: one is due.
Stored<std::optional<Backup>> backup_of_today(const OwnStore& store, const std::filesystem::path& into) {
  if (!store) return std::unexpected(store.error());
  return young_daily_backup((*store)->context(), into, kBackupEveryUs);
}

Stored<BackedUp> back_up_if_due(const OwnStore& store, const std::filesystem::path& into, const WorkWatch& watch) {
  auto today = backup_of_today(store, into);
  if (!today) return std::unexpected(today.error());
  if (*today) return BackedUp{std::move(**today), std::nullopt, BackedUp::By::earlier};
  return back_up_and_thin((*store)->context(), into, std::nullopt, watch);
}

Stored<BackedUp> back_up_daily(const RecordsBeside& records, const std::filesystem::path& into, const WorkWatch& watch) {
  auto today = backup_of_today(open_beside(records.for_reading()), into);
  if (!today) return std::unexpected(today.error());
  if (*today) return BackedUp{std::move(**today), std::nullopt, BackedUp::By::earlier};
  if (watch && !watch(0, 1)) return fail(StorageError::stopped, into.string());
  std::error_code ignored;  // make_backup() reports it
  const bool is_new = std::filesystem::create_directories(into, ignored);  // only a folder that is there can be locked
  // Of two programs that find it due, the second waits, and takes that of the first: two a day would halve the days that are kept.
  const LockedFolder alone(into, FolderLock::alone);
  auto made = back_up_if_due(open_beside(records), into, watch);
  if (!made && is_new) std::filesystem::remove(into, ignored);  // only if it is empty
  return made;
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
  const auto holds = actor ? BackgroundTask::Holds::change : BackgroundTask::Holds::nothing;  // the next start makes the daily one
  return BackgroundTask([records = std::move(records), into = std::move(into), actor, then = std::move(then), watch = watch_of(std::move(progress))] {
    then(actor ? back_up_on_demand(records, into, *actor, watch) : back_up_daily(records, into, watch));
  }, holds);
}

BackgroundTask find_backups(std::filesystem::path into, std::optional<Uuid> station, int asked, std::function<void(FoundBackups)> then) {
  return BackgroundTask([into = std::move(into), station, asked, then = std::move(then)] { then({asked, backups_in(into, station)}); },
                        BackgroundTask::Holds::nothing);
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
  }, BackgroundTask::Holds::nothing);
}

}  // namespace cusp::ui
