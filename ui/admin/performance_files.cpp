// What the performance page writes and opens as files.

#include <QLocale>
#include <QPointer>
#include <QTimer>

#include "ui/admin/on_window.h"
#include "ui/admin/performance.h"
#include "ui/text/language.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {
namespace {
constexpr int kLookAtExportMs = 100;
}  // namespace

QWidget* Performance::make_progress() {
  busy_ = new Busy;
  busy_->hide();
  look_ = new QTimer(this);
  connect(look_, &QTimer::timeout, this, &Performance::show_progress);
  connect(busy_, &Busy::cancelled, this, &Performance::cancel_export);
  return busy_;
}

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
    if (self && !self->exporting()) self->export_to(path, shown);
  });
}

void Performance::export_to(const QString& path, const HistoryFilter& shown) {
  band_->clear();
  exported_to_ = path;
  progress_ = std::make_shared<ExportProgress>();
  busy_->start(tr("Exporting attempts"), Busy::Cancel::offered);
  look_->start(kLookAtExportMs);
  CsvOptions options;
  options.language = current_language().toStdString();
  task_ = export_in_background(records_of(store_), reader_, {path.toStdString(), shown, options}, progress_,
                               on_window<Stored<std::optional<std::size_t>>>(this, &Performance::show_exported));
}

void Performance::cancel_export() {
  if (exporting()) progress_->stop = true;
}

void Performance::show_progress() {
  if (!exporting() || progress_->all == 0) return;
  const std::size_t done = progress_->done, all = progress_->all;
  busy_->set_progress(static_cast<double>(done) / static_cast<double>(all),
                      tr("%1 of %2 attempts").arg(QLocale().toString(static_cast<qulonglong>(done)), QLocale().toString(static_cast<qulonglong>(all))));
}

void Performance::show_exported(const Stored<std::optional<std::size_t>>& rows) {
  progress_.reset();
  look_->stop();
  busy_->finish();
  if (rows && *rows) {
    return band_->show_message(Band::Kind::good, tr("%n attempt(s) exported.", nullptr, static_cast<int>(**rows)), exported_to_);
  }
  if (rows) return band_->show_message(Band::Kind::look, tr("The export was cancelled."), tr("%1 was not written. What was there before is unchanged.").arg(exported_to_));
  if (rows.error().where == exported_to_.toStdString()) return show_unwritten(*band_, exported_to_, QString::fromLocal8Bit(rows.error().detail.c_str()));
  show_failure(rows.error());
}

}  // namespace cusp::ui
