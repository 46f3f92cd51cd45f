#include "ui/app/closing_window.h"

#include <QCloseEvent>
#include <QEventLoop>
#include <QLabel>
#include <QPushButton>
#include <QThreadPool>
#include <QVBoxLayout>

#include "ui/app/run_marker.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kWorkLookMs = 50;
constexpr int kShownAfterMs = 1'000;  // work that is called off ends within
constexpr int kClosingWidth = 480;    // px at 100 %

/// What the pool writes is asked about before the window closes (a specimen's import), or made again when it is wanted (a grade).
DroppedWork work_that_is_left() {
  const DroppedWork dropped = dropped_work();
  const bool computes = QThreadPool::globalInstance()->activeThreadCount() > 0;
  return dropped == DroppedWork::none && computes ? DroppedWork::harmless : dropped;
}

}  // namespace

ClosingWindow::ClosingWindow(QWidget* parent) : QWidget(parent) {
  set_kind(this, "page");
  setWindowTitle(QStringLiteral("Cusp"));
  setWindowIcon(icon(QStringLiteral("tooth"), Ink::accent));
  setFixedWidth(px(kClosingWidth));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(24), px(24), px(24), px(24));
  column->setSpacing(px(16));
  what_ = make_label(tr("Cusp is closing"), TextRole::section, Weight::bold);
  more_ = make_paragraph({});
  more_->setWordWrap(true);
  leave_ = make_button(tr("Close without waiting"));
  column->addWidget(what_);
  column->addWidget(more_);
  column->addWidget(leave_, 0, Qt::AlignTrailing);
  setAccessibleName(what_->text());
  connect(leave_, &QPushButton::clicked, this, [this] { end(End::left); });
  look_timer_.setInterval(kWorkLookMs);
  connect(&look_timer_, &QTimer::timeout, this, &ClosingWindow::look);
  show_timer_.setSingleShot(true);
  show_timer_.setInterval(kShownAfterMs);
  connect(&show_timer_, &QTimer::timeout, this, &ClosingWindow::show_wait);
}

ClosingWindow::End ClosingWindow::wait() {
  if (work_that_is_left() == DroppedWork::none) return End::work_over;
  QEventLoop loop;
  loop_ = &loop;
  look_timer_.start();
  show_timer_.start();
  loop.exec();
  loop_ = nullptr;
  look_timer_.stop();
  show_timer_.stop();
  hide();
  return end_;
}

void ClosingWindow::look() {
  const DroppedWork now = work_that_is_left();
  if (now == DroppedWork::none) return end(End::work_over);
  const bool had_time = !show_timer_.isActive();  // to stop, and to remove what is unfinished
  if (now == DroppedWork::harmless && had_time && ended_by_signal()) return end(End::left);
  if (now == work_) return;
  work_ = now;
  more_->setText(now == DroppedWork::change
                     ? tr("A file or a change of the records is still being written. If you do not wait, a file that is not finished is "
                          "missing, and a change that is not made yet is not made. All other records are kept.")
                     : tr("Work in the background has not ended: something is computed, or a drive or a device does not answer. Nothing is "
                          "lost if you do not wait."));
  set_kind(leave_, now == DroppedWork::change ? "erase" : "primary");
  resize(width(), layout()->totalHeightForWidth(width()));  // adjustSize() leaves a gap about wrapped text
  if (!isVisible()) return;
  announce(this, text());
}

void ClosingWindow::show_wait() {
  look();
  if (!loop_->isRunning() || ended_by_signal()) return;
  show();
  leave_->setFocus();
  announce(this, text());
}

QString ClosingWindow::text() const { return what_->text() + u". "_qs + more_->text(); }

void ClosingWindow::end(End how) {
  end_ = how;
  if (loop_ != nullptr) loop_->quit();
}

void ClosingWindow::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (work_ == DroppedWork::harmless) end(End::left);
}

}  // namespace cusp::ui
