#include "ui/admin/export_run.h"

#include <QLocale>
#include <QTimer>
#include <utility>

#include "ui/admin/on_window.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {
namespace {
constexpr int kLookAtExportMs = 100;  // between two looks at how far the export is
}  // namespace

ExportRun::ExportRun(Band& band, Texts texts, QObject* page)
    : QObject(page), band_(band), texts_(std::move(texts)), busy_(new Busy), look_(new QTimer(this)) {
  connect(look_, &QTimer::timeout, this, &ExportRun::show_progress);
  connect(busy_, &Busy::cancelled, this, &ExportRun::cancel);
}

void ExportRun::start(const QString& path, const Begin& begin) {
  if (running()) return;
  band_.clear();
  path_ = path;
  progress_ = std::make_shared<ExportProgress>();
  busy_->start(texts_.busy, Busy::Cancel::offered);
  look_->start(kLookAtExportMs);
  task_ = begin(progress_, on_window<Outcome>(this, &ExportRun::show_outcome));
}

void ExportRun::cancel() {
  if (running()) progress_->stop = true;
}

void ExportRun::show_progress() {
  if (!running() || progress_->all == 0) return;
  const std::size_t done = progress_->done, all = progress_->all;
  busy_->set_progress(static_cast<double>(done) / static_cast<double>(all),
                      texts_.counted(QLocale().toString(static_cast<qulonglong>(done)), QLocale().toString(static_cast<qulonglong>(all))));
}

void ExportRun::show_outcome(const Outcome& rows) {
  progress_.reset();
  look_->stop();
  busy_->finish();
  if (rows && *rows) return band_.show_message(Band::Kind::good, texts_.exported(static_cast<int>(**rows)), path_);
  if (rows) return band_.show_message(Band::Kind::look, texts_.cancelled, texts_.unwritten.arg(path_));
  if (rows.error().where == path_.toStdString()) return show_unwritten(band_, path_, QString::fromLocal8Bit(rows.error().detail.c_str()));
  const Message message = describe(rows.error());
  band_.show_message(Band::Kind::bad, message.what, message.more);
}

}  // namespace cusp::ui
