/// Backups of a station's records and their verification, on a thread of their own with a store of their own.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "storage/backup/backup.h"
#include "storage/records/verify.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

inline constexpr std::size_t kBackupsKept = 14;  // of each kind
inline constexpr std::int64_t kBackupEveryUs = 86'400'000'000;  // a day

struct BackedUp {
  enum class By : std::uint8_t { this_call, earlier };
  Backup backup;
  std::optional<StorageFailure> not_removed{};  // an old backup: where = its folder, detail = the system's reason
  By by = By::this_call;  // earlier: a daily one of less than a day ago was there
};
/// Makes a backup in `into` and removes the oldest of its kind beyond kBackupsKept. `then` is called on the task's thread.
/// Without an actor it is the program's own daily one, made if young_daily_backup() finds none younger than kBackupEveryUs; `progress->all` is
/// 0 until that is known. Without progress nothing stops it.
BackgroundTask back_up(RecordsBeside records, std::filesystem::path into, std::optional<Actor> actor,
                       std::function<void(Stored<BackedUp>)> then, std::shared_ptr<WorkProgress> progress = {});
struct FoundBackups {
  int asked = 0;
  Stored<std::vector<Backup>> all;
};
/// backups_in(), whose drive may not answer for minutes. `then` is called on the task's thread; with `asked` a page knows the answer to its
/// latest question.
BackgroundTask find_backups(std::filesystem::path into, std::optional<Uuid> station, int asked, std::function<void(FoundBackups)> then);
struct WentBack {
  Backup backup;
  std::filesystem::path aside;  // where the records from before are
};
/// restore_in_place() and log_restored(). Pre: nothing has `database` open. After a failure it is as it was. `then` is
/// called on the task's thread.
BackgroundTask go_back(std::filesystem::path database, Backup backup, std::function<void(Stored<WentBack>)> then);
/// verify_store(); `then` is called on the task's thread.
BackgroundTask verify_records(RecordsBeside records, std::function<void(Stored<StoreVerification>)> then,
                              std::shared_ptr<WorkProgress> progress);

/// How far a verification of the audit log has come. Written by the task, read by the window.
struct LogProgress {
  std::atomic<std::int64_t> holding{0};  // entries, from the first one on
};
/// AuditLog::verify() over a store that only reads; `then` is called on the task's thread. Whoever drops the task continues at
/// once, and ignores the answer.
BackgroundTask verify_log(RecordsBeside records, const Actor& actor, std::shared_ptr<LogProgress> progress,
                          std::function<void(Stored<Verification>)> then);

}  // namespace cusp::ui
