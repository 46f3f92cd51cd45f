// What the audit log's page writes as a file.

#include <QLocale>
#include <QPointer>
#include <QTimer>

#include "ui/admin/log_page.h"
#include "ui/admin/on_window.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {
namespace {
constexpr int kLookAtLogExportMs = 100;
}  // namespace

QWidget* LogPage::make_export_progress() {
  export_busy_ = new Busy;
  export_busy_->hide();
  look_at_export_ = new QTimer(this);
  connect(look_at_export_, &QTimer::timeout, this, &LogPage::show_export_progress);
  connect(export_busy_, &Busy::cancelled, this, &LogPage::cancel_export);
  return export_busy_;
}

void LogPage::export_csv() {
  if (exporting()) return;
  const FileWish wish = csv_file_wish(tr("Export CSV"), u"cusp-audit-log-"_qs + ports_.now().toString(u"yyyy-MM-dd"_qs));
  ports_.pick_file(this, wish, [self = QPointer(this), shown = filter()](const QString& path) {
    if (self && !self->exporting()) self->export_to(path, shown);
  });
}

void LogPage::export_to(const QString& path, const AuditFilter& shown) {
  band_->clear();
  exported_to_ = path;
  export_ = std::make_shared<ExportProgress>();
  export_busy_->start(tr("Exporting the audit log"), Busy::Cancel::offered);
  look_at_export_->start(kLookAtLogExportMs);
  LogFile wanted{path.toStdString(), shown, {}};
  for (const auto& [id, name] : names_) wanted.names[id] = name.toStdString();
  export_task_ = export_log_in_background(records_of(store_), actor_, std::move(wanted), export_,
                                          on_window<Stored<std::optional<std::size_t>>>(this, &LogPage::show_exported));
}

void LogPage::cancel_export() {
  if (exporting()) export_->stop = true;
}

void LogPage::show_export_progress() {
  if (!exporting() || export_->all == 0) return;
  const std::size_t done = export_->done, all = export_->all;
  export_busy_->set_progress(static_cast<double>(done) / static_cast<double>(all),
                             tr("%1 of %2 entries").arg(QLocale().toString(static_cast<qulonglong>(done)), QLocale().toString(static_cast<qulonglong>(all))));
}

void LogPage::show_exported(const Stored<std::optional<std::size_t>>& entries) {
  export_.reset();
  look_at_export_->stop();
  export_busy_->finish();
  if (entries && *entries) {
    return band_->show_message(Band::Kind::good, tr("%n entry(ies) exported.", nullptr, static_cast<int>(**entries)), exported_to_);
  }
  if (entries) return band_->show_message(Band::Kind::look, tr("The export was cancelled."), tr("%1 was not written. What was there before is unchanged.").arg(exported_to_));
  if (entries.error().where == exported_to_.toStdString()) return show_unwritten(*band_, exported_to_, QString::fromLocal8Bit(entries.error().detail.c_str()));
  show_failure(entries.error());
}

}  // namespace cusp::ui
