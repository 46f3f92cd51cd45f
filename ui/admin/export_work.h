/// Attempts, or the audit log, as a CSV file, on a thread of its own with a store of its own (storage/export/csv.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "storage/export/csv.h"
#include "storage/repositories/audit_log.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

struct AttemptsFile {
  std::filesystem::path file;
  HistoryFilter filter;
  CsvOptions options;
};

/// export_rows() to a WholeFile (scenarios/import/whole_file.h): what was there before stays unless all rows are written. How many;
/// nullopt: stopped. `then` is called on the task's thread. The entry in the audit log comes once the file is written and before it
/// has its name: none of a file that failed, and no file without one.
BackgroundTask export_in_background(RecordsBeside records, const Actor& actor, AttemptsFile wanted, std::shared_ptr<WorkProgress> progress,
                                    std::function<void(Stored<std::optional<std::size_t>>)> then);

struct LogFile {
  std::filesystem::path file;
  AuditFilter filter;
  std::map<Uuid, std::string> names;  // of what the log names by id
};
inline constexpr int kLogEntriesAtOnce = 5'000;  // read before the next look at `stop`

/// The same of the audit log, with an entry about it; without one if the records are read-only. `done` and `all`
/// count every entry that was looked through, those that the filter leaves out too.
BackgroundTask export_log_in_background(RecordsBeside records, const Actor& actor, LogFile wanted, std::shared_ptr<WorkProgress> progress,
                                        std::function<void(Stored<std::optional<std::size_t>>)> then);

}  // namespace cusp::ui
