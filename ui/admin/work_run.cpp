#include "ui/admin/work_run.h"

#include <QLocale>
#include <utility>

namespace cusp::ui {
namespace {
constexpr int kReadProgressMs = 100;
}  // namespace

WorkWatch watch_of(std::shared_ptr<WorkProgress> progress) {
  if (!progress) return {};
  return [progress = std::move(progress)](std::size_t done, std::size_t all) {
    progress->all = all;
    progress->done = done;
    return !progress->stop;
  };
}

QString count_text(std::size_t count) { return QLocale().toString(static_cast<qulonglong>(count)); }

WorkRun::WorkRun(QObject* page) : QObject(page), busy_(new Busy), timer_(new QTimer(this)) {
  connect(timer_, &QTimer::timeout, this, [this] { show_progress(); });
  connect(busy_, &Busy::cancelled, this, [this] { cancel(); });
  connect(busy_, &Busy::shown, this, [this] {
    if (running() && handed_on(focused())) busy_->focus_cancel();
  });
}

std::shared_ptr<WorkProgress> WorkRun::start(const QString& title, Counted counted) {
  progress_ = std::make_shared<WorkProgress>();
  show(title, std::move(counted), Busy::Cancel::offered);
  return progress_;
}

void WorkRun::follow(std::shared_ptr<WorkProgress> progress, const QString& title, Counted counted) {
  progress_ = std::move(progress);
  show(title, std::move(counted), Busy::Cancel::none);
}

void WorkRun::show(const QString& title, Counted counted, Busy::Cancel cancel) {
  counted_ = std::move(counted);
  pressed_ = focused();
  handed_to_ = nullptr;
  handed_ = false;
  QTimer::singleShot(0, this, [this] {
    handed_to_ = focused();
    handed_ = true;
  });
  busy_->start(title, cancel);
  timer_->start(kReadProgressMs);
}

void WorkRun::finish(QWidget* instead) {
  const QWidget* now = focused();
  const bool lost = handed_on(now) || busy_->isAncestorOf(now);
  progress_.reset();
  timer_->stop();
  busy_->finish();
  QWidget* back = pressed_ && pressed_->isEnabled() ? pressed_.data() : instead;
  if (lost && back != nullptr) back->setFocus(Qt::OtherFocusReason);
}

QWidget* WorkRun::focused() const { return busy_->window()->focusWidget(); }

bool WorkRun::handed_on(const QWidget* now) const { return now != pressed_ && (!handed_ || now == nullptr || now == handed_to_); }

void WorkRun::cancel() {
  if (running()) progress_->stop = true;
}

void WorkRun::show_progress() {
  if (!running() || progress_->all == 0) return;
  const std::size_t done = progress_->done, all = progress_->all;
  busy_->set_progress(static_cast<double>(done) / static_cast<double>(all), counted_(done, all));
}

}  // namespace cusp::ui
