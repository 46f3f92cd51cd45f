#include "ui/admin/export_work.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "scenarios/import/whole_file.h"
#include "storage/base/files.h"

namespace cusp::ui {
namespace {

Stored<std::optional<std::size_t>> export_to_file(StorageContext& context, const Actor& actor, const AttemptsFile& wanted, WorkProgress& progress) {
  WholeFile file(wanted.file);
  CsvPart part = CsvPart::beginning;
  const auto take = [&](std::span<const ExportRow> some, std::size_t all) -> Stored<bool> {
    progress.all = all;
    if (auto done = file.write(history_csv(some, std::exchange(part, CsvPart::further), wanted.options)); !done) {
      return std::unexpected(failure_from(done.error(), wanted.file));
    }
    progress.done += some.size();
    return !progress.stop;
  };
  const auto close = [&]() -> Stored<void> {
    if (auto done = file.close(); !done) return std::unexpected(failure_from(done.error(), wanted.file));
    return {};
  };
  const auto rows = export_rows(context, actor, wanted.filter, take, close);
  if (!rows || !*rows) return rows;
  if (auto done = file.finish(); !done) return std::unexpected(failure_from(done.error(), wanted.file));
  return rows;
}

/// All entries, newest first. How many; nullopt: stopped.
Stored<std::optional<std::size_t>> write_entries(Store& store, const Actor& actor, const LogFile& wanted, WholeFile& file, WorkProgress& progress) {
  const NameOf name_of = [&wanted](const Uuid& id) {
    const auto found = wanted.names.find(id);
    return found == wanted.names.end() ? std::string() : found->second;
  };
  if (auto done = file.write(std::string(kByteOrderMark) + audit_csv_head()); !done) return std::unexpected(failure_from(done.error(), wanted.file));
  std::size_t entries = 0;
  for (std::int64_t before = INT64_MAX; !progress.stop;) {
    const auto some = store.audit.list(actor, kLogEntriesAtOnce, before, wanted.filter);
    if (!some) return std::unexpected(some.error());
    if (some->empty()) return std::optional(entries);
    if (progress.all == 0) progress.all = static_cast<std::size_t>(some->front().number + 1);
    std::string text;
    for (const AuditEntry& entry : *some) text += audit_csv_line(entry, name_of);
    if (auto done = file.write(text); !done) return std::unexpected(failure_from(done.error(), wanted.file));
    entries += some->size();
    before = some->back().number;
    progress.done = progress.all - std::min<std::size_t>(progress.all, static_cast<std::size_t>(before));
  }
  return std::optional<std::size_t>{};
}

Stored<std::optional<std::size_t>> export_log_to_file(Store& store, const Actor& actor, const LogFile& wanted, WorkProgress& progress) {
  WholeFile file(wanted.file);
  const auto entries = write_entries(store, actor, wanted, file, progress);
  if (!entries || !*entries) return entries;
  if (auto done = file.close(); !done) return std::unexpected(failure_from(done.error(), wanted.file));
  if (!store.database().read_only()) {
    const auto noted = store.audit.add_if_allowed(
        {.actor = actor.id, .action = "log_exported", .subject = store.context().station, .detail = std::to_string(**entries)}, Action::see_audit_log);
    if (!noted) return std::unexpected(noted.error());
  }
  if (auto done = file.finish(); !done) return std::unexpected(failure_from(done.error(), wanted.file));
  return entries;
}

}  // namespace

BackgroundTask export_in_background(RecordsBeside records, const Actor& actor, AttemptsFile wanted, std::shared_ptr<WorkProgress> progress,
                                    std::function<void(Stored<std::optional<std::size_t>>)> then) {
  return BackgroundTask([records = std::move(records), actor, wanted = std::move(wanted), progress = std::move(progress), then = std::move(then)] {
    const auto store = open_beside(records);
    if (!store) return then(std::unexpected(store.error()));
    then(export_to_file((*store)->context(), actor, wanted, *progress));
  });
}

BackgroundTask export_log_in_background(RecordsBeside records, const Actor& actor, LogFile wanted, std::shared_ptr<WorkProgress> progress,
                                        std::function<void(Stored<std::optional<std::size_t>>)> then) {
  return BackgroundTask([records = std::move(records), actor, wanted = std::move(wanted), progress = std::move(progress), then = std::move(then)] {
    const auto store = open_beside(records);
    if (!store) return then(std::unexpected(store.error()));
    then(export_log_to_file(**store, actor, wanted, *progress));
  });
}

}  // namespace cusp::ui
