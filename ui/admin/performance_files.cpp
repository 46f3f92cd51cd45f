// What the performance page writes and opens as files.

#include <QPointer>
#include <utility>

#include "ui/admin/export_run.h"
#include "ui/admin/performance.h"
#include "ui/text/language.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {

QWidget* Performance::make_progress() {
  const ExportRun::Texts texts{.busy = tr("Exporting attempts"),
                               .counted = [](const QString& done, const QString& all) { return tr("%1 of %2 attempts").arg(done, all); },
                               .exported = [](int attempts) { return tr("%n attempt(s) exported.", nullptr, attempts); },
                               .cancelled = tr("The export was cancelled."),
                               .unwritten = tr("%1 was not written. What was there before is unchanged.")};
  export_ = new ExportRun(*band_, texts, this);
  return export_->busy();
}

bool Performance::exporting() const { return export_->running(); }
void Performance::cancel_export() { export_->cancel(); }

void Performance::choose_pack() {
  FileWish wish;
  wish.title = tr("Open an appeal pack");
  wish.filter = tr("Appeal pack (*.cusppack)");
  wish.saving = false;
  ports_.pick_file(this, wish, [this](const QString& path) { Q_EMIT pack_wanted(path); });
}

void Performance::export_csv() {
  if (exporting()) return;
  const FileWish wish = csv_file_wish(tr("Export CSV"), u"cusp-performance-"_qs + ports_.now().toString(u"yyyy-MM-dd"_qs));
  ports_.pick_file(this, wish, [self = QPointer(this), shown = filter()](const QString& path) {
    if (self) self->export_to(path, shown);
  });
}

void Performance::export_to(const QString& path, const HistoryFilter& shown) {
  const CsvOptions options{.byte_order_mark = true, .language = current_language().toStdString()};
  export_->start(path, [&](std::shared_ptr<WorkProgress> progress, std::function<void(ExportRun::Outcome)> then) {
    return export_in_background(records_of(store_), reader_, {path.toStdString(), shown, options}, std::move(progress), std::move(then));
  });
}

}  // namespace cusp::ui
