#include "ui/widgets/busy.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/widgets/parts.h"

namespace cusp::ui {

Busy::Busy(QWidget* parent) : QWidget(parent), timer_(new QTimer(this)) {
  auto* column = new QVBoxLayout(this);
  column->setSpacing(px(8));
  setMinimumWidth(px(280));  // start() sets the title, which must not be clipped
  column->addStretch();
  title_ = make_label({}, TextRole::section, Weight::bold);
  title_->setAlignment(Qt::AlignCenter);
  counted_ = make_label({}, TextRole::body, Weight::regular, "text2");
  counted_->setAlignment(Qt::AlignCenter);
  bar_ = new Bar(Bar::Role::accent);
  cancel_ = make_button(tr("Cancel"));
  column->addWidget(title_);
  column->addWidget(counted_);
  column->addWidget(bar_);
  column->addWidget(cancel_, 0, Qt::AlignHCenter);
  column->addStretch();
  hide();
  timer_->setSingleShot(true);
  timer_->setInterval(kDelayMs);
  connect(timer_, &QTimer::timeout, this, [this] {
    if (!running_) return;
    show();
    Q_EMIT shown();
  });
  connect(cancel_, &QPushButton::clicked, this, &Busy::cancelled);
}

void Busy::start(const QString& title, Cancel cancel) {
  running_ = true;
  title_->setText(title);
  setAccessibleName(title);
  set_progress(0, {});
  cancel_->setVisible(cancel == Cancel::offered);
  timer_->start();
}

void Busy::set_progress(double share, const QString& counted) {
  counted_->setText(counted);
  bar_->set_share(share, counted);
}

void Busy::focus_cancel() {
  if (cancel_->isVisible()) cancel_->setFocus(Qt::OtherFocusReason);
}

void Busy::finish() {
  running_ = false;
  timer_->stop();
  hide();
}

ButtonWait::ButtonWait(QPushButton* button) : button_(button) {
  timer_.setSingleShot(true);
  timer_.setInterval(Busy::kDelayMs);
  timer_.callOnTimeout([this] { show_text(meanwhile_); });
}

void ButtonWait::start(const QString& meanwhile) {
  running_ = true;
  before_ = button_->text();
  meanwhile_ = meanwhile;
  timer_.start();
}

void ButtonWait::finish() {
  running_ = false;
  timer_.stop();
  show_text(before_);
}

void ButtonWait::show_text(const QString& text) {
  button_->setText(text);
  button_->setAccessibleName(text.trimmed());
}

}  // namespace cusp::ui
