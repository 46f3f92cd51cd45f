/// Attempts as a CSV file, on a thread of its own with a store of its own (storage/export/csv.h).
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "storage/export/csv.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

/// How far an export has come, written by the task; `stop`, written by the window, ends it before the next rows.
struct ExportProgress {
  std::atomic<std::size_t> done{0}, all{0};
  std::atomic<bool> stop{false};
};

struct AttemptsFile {
  std::filesystem::path file;
  HistoryFilter filter;
  CsvOptions options;
};

/// export_rows() to a WholeFile: what was there before stays unless all rows are written. How many; nullopt: stopped. `then` is called
/// on the task's thread.
BackgroundTask export_in_background(RecordsBeside records, const Actor& actor, AttemptsFile wanted, std::shared_ptr<ExportProgress> progress,
                                    std::function<void(Stored<std::optional<std::size_t>>)> then);

}  // namespace cusp::ui
