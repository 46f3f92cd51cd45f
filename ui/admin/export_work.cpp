#include "ui/admin/export_work.h"

#include <span>
#include <utility>

#include "ui/session/whole_file.h"

namespace cusp::ui {
namespace {

Stored<std::optional<std::size_t>> export_to_file(StorageContext& context, const Actor& actor, const AttemptsFile& wanted, ExportProgress& progress) {
  WholeFile file(wanted.file);
  CsvPart part = CsvPart::beginning;
  const auto rows = export_rows(context, actor, wanted.filter, [&](std::span<const ExportRow> some, std::size_t all) -> Stored<bool> {
    progress.all = all;
    if (auto done = file.write(history_csv(some, std::exchange(part, CsvPart::further), wanted.options)); !done) {
      return std::unexpected(done.error());
    }
    progress.done += some.size();
    return !progress.stop;
  });
  if (!rows || !*rows) return rows;
  if (auto done = file.finish(); !done) return std::unexpected(done.error());
  return rows;
}

}  // namespace

BackgroundTask export_in_background(RecordsBeside records, const Actor& actor, AttemptsFile wanted, std::shared_ptr<ExportProgress> progress,
                                    std::function<void(Stored<std::optional<std::size_t>>)> then) {
  return BackgroundTask([records = std::move(records), actor, wanted = std::move(wanted), progress = std::move(progress), then = std::move(then)] {
    const auto store = open_beside(records);
    if (!store) return then(std::unexpected(store.error()));
    then(export_to_file((*store)->context(), actor, wanted, *progress));
  });
}

}  // namespace cusp::ui
