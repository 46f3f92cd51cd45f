// What the audit log's page writes as a file.

#include <QPointer>
#include <utility>

#include "ui/admin/export_run.h"
#include "ui/admin/log_page.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {

QWidget* LogPage::make_export_progress() {
  const ExportRun::Texts texts{.busy = tr("Exporting the audit log"),
                               .counted = [](const QString& done, const QString& all) { return tr("%1 of %2 entries").arg(done, all); },
                               .exported = [](int entries) { return tr("%n entry(ies) exported.", nullptr, entries); },
                               .cancelled = tr("The export was cancelled."),
                               .unwritten = tr("%1 was not written. What was there before is unchanged.")};
  export_ = new ExportRun(*band_, texts, this);
  return export_->busy();
}

bool LogPage::exporting() const { return export_->running(); }
void LogPage::cancel_export() { export_->cancel(); }

void LogPage::export_csv() {
  if (exporting()) return;
  const FileWish wish = csv_file_wish(tr("Export CSV"), u"cusp-audit-log-"_qs + ports_.now().toString(u"yyyy-MM-dd"_qs));
  ports_.pick_file(this, wish, [self = QPointer(this), shown = filter()](const QString& path) {
    if (self) self->export_to(path, shown);
  });
}

void LogPage::export_to(const QString& path, const AuditFilter& shown) {
  read_names();
  LogFile wanted{path.toStdString(), shown, {}};
  for (const auto& [id, name] : names_) wanted.names[id] = name.toStdString();
  export_->start(path, [this, &wanted](std::shared_ptr<WorkProgress> progress, std::function<void(ExportRun::Outcome)> then) {
    return export_log_in_background(records_of(store_), actor_, std::move(wanted), std::move(progress), std::move(then));
  });
}

}  // namespace cusp::ui
