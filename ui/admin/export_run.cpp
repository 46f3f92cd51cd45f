#include "ui/admin/export_run.h"

#include <utility>

#include "ui/admin/on_window.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"

namespace cusp::ui {

ExportRun::ExportRun(Band& band, Texts texts, QObject* page)
    : QObject(page), band_(band), texts_(std::move(texts)), run_(new WorkRun(this)) {}

void ExportRun::start(const QString& path, const Begin& begin) {
  if (running()) return;
  band_.clear();
  path_ = path;
  auto progress = run_->start(texts_.busy, [this](std::size_t done, std::size_t all) { return texts_.counted(count_text(done), count_text(all)); });
  task_ = begin(std::move(progress), on_window<Outcome>(this, &ExportRun::show_outcome));
}

void ExportRun::show_outcome(const Outcome& rows) {
  run_->finish();
  if (rows && *rows) return band_.show_message(Band::Kind::good, texts_.exported(static_cast<int>(**rows)), path_);
  if (rows) return band_.show_message(Band::Kind::look, texts_.cancelled, texts_.unwritten.arg(path_));
  if (rows.error().where == path_.toStdString()) return show_unwritten(band_, path_, QString::fromLocal8Bit(rows.error().detail.c_str()));
  const Message message = describe(rows.error());
  band_.show_message(Band::Kind::bad, message.what, message.more);
}

}  // namespace cusp::ui
