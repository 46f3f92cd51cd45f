#include "ui/drill/drill_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <array>

#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLeastTitle = 96;  // px at 100 %

constexpr std::array kTimeWarningsS = {300.0, 60.0};  // of what is left

}  // namespace

DrillBar::DrillBar(QWidget* parent) : QFrame(parent) {
  set_kind(this, "bar_top");
  setFixedHeight(px(48));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(px(12), 0, px(12), 0);
  row->setSpacing(px(12));
  leave_ = make_button(tr("Leave"), ButtonKind::quiet, QStringLiteral("chevron_left"));
  leave_->setToolTip(leave_->accessibleName());
  connect(leave_, &QPushButton::clicked, this, &DrillBar::leave);
  row->addWidget(leave_);
  QFrame* rule = make_rule(Qt::Vertical);
  rule->setFixedHeight(px(32));
  row->addWidget(rule, 0, Qt::AlignVCenter);
  title_ = make_label({}, TextRole::section, Weight::bold);
  aside_ = make_label({});
  set_kind(aside_, "tag");
  row->addWidget(title_);
  row->addWidget(aside_, 0, Qt::AlignVCenter);
  row->addStretch(1);
  auto* clock_sign = new QLabel(this);
  clock_sign->setPixmap(icon_pixmap(QStringLiteral("clock"), Ink::text2, 16, devicePixelRatioF()));
  clock_ = make_label(format_clock(0), TextRole::live, Weight::bold);
  clock_->setAccessibleDescription(tr("Time"));
  clock_->setMinimumWidth(QFontMetrics(font_of(TextRole::live, Weight::bold)).horizontalAdvance(QStringLiteral("00:00:00")));
  row->addWidget(clock_sign);
  row->addWidget(clock_);
  limit_ = make_label({}, TextRole::body, Weight::regular, "text2");
  limit_->setAccessibleDescription(tr("Time limit"));
  limit_->hide();
  row->addWidget(limit_);
  row->addStretch(1);
  device_name_ = make_label({}, TextRole::body, Weight::regular, "text2");
  row->addWidget(device_name_, 0, Qt::AlignVCenter);
  pause_ = make_button(tr("Pause"), ButtonKind::standard, QStringLiteral("pause"), QKeySequence(Qt::Key_P));
  connect(pause_, &QPushButton::clicked, this, &DrillBar::pause);
  row->addWidget(pause_);
  finish_ = make_button(tr("Finish"), ButtonKind::primary, QStringLiteral("flag"), QKeySequence(Qt::CTRL | Qt::Key_Return));
  connect(finish_, &QPushButton::clicked, this, &DrillBar::finish);
  row->addWidget(finish_);
}

void DrillBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

void DrillBar::fit() {
  for (const Detail detail : {Detail::whole, Detail::no_device, Detail::icons, Detail::short_texts}) {
    show_detail(detail);
    if (layout()->sizeHint().width() <= width()) return;
  }
}

void DrillBar::show_detail(Detail detail) {
  const bool texts = detail < Detail::icons;
  const auto show_text = [texts](QPushButton* button) {
    const QString text = texts ? u' ' + button->accessibleName() : QString();  // as make_button: the style leaves no space after the sign
    if (button->text() == text) return;
    const QKeySequence key = button->shortcut();  // a new text takes the shortcut away
    button->setText(text);
    button->setShortcut(key);
  };
  show_text(leave_);
  show_text(pause_);
  device_name_->setVisible(delayed_ || detail < Detail::no_device);
  show_texts(detail);
}

/// Down to kLeastTitle the title alone gives way, then the tag.
void DrillBar::show_texts(Detail detail) {
  title_->setText(whole_title_);
  aside_->setText(whole_aside_);
  const auto shorten = [this](QLabel* label, const QString& whole, int least) {
    const int too_wide = layout()->sizeHint().width() - width();
    if (too_wide <= 0) return;
    const int beside = label->sizeHint().width() - label->fontMetrics().horizontalAdvance(whole);
    label->setText(label->fontMetrics().elidedText(whole, Qt::ElideRight, std::max(least, label->sizeHint().width() - too_wide) - beside));
  };
  if (detail == Detail::short_texts) {
    shorten(title_, whole_title_, std::min(px(kLeastTitle), title_->sizeHint().width()));
    shorten(aside_, whole_aside_, 0);
  }
  title_->setToolTip(title_->text() == whole_title_ ? QString() : short_tool_tip(whole_title_));
  aside_->setToolTip(aside_->text() == whole_aside_ ? QString() : short_tool_tip(whole_aside_));
}

void DrillBar::set_exercise(const QString& title, const QString& aside) {
  whole_title_ = title;
  title_->setAccessibleName(title);
  whole_aside_ = aside;
  aside_->setAccessibleName(aside);
  aside_->setVisible(!aside.isEmpty());
  fit();
}

void DrillBar::set_seconds(double seconds) {
  const QString time = format_clock(seconds);
  if (time != clock_->text()) clock_->setText(time);
  if (limit_s_ > 0) show_time_left(std::max(0.0, limit_s_ - seconds));
}

void DrillBar::set_time_limit(double seconds) {
  limit_s_ = seconds;
  limit_->setVisible(seconds > 0);
  limit_->setText(tr("of %1").arg(format_clock(seconds)));
  fit();
}

void DrillBar::show_time_left(double left_s) {
  int due = 0;
  for (const double warning_s : kTimeWarningsS) due += left_s < warning_s && warning_s < limit_s_ ? 1 : 0;
  if (due == 0) return;
  const QString text = tr("%1 left").arg(format_clock(left_s));
  if (text != limit_->text()) limit_->setText(text);
  if (due <= warned_) return;
  warned_ = due;
  set_ink(limit_, "look");  // an assessment shows no red
  announce(this, text);
  fit();
}

void DrillBar::set_device(const DeviceLimits& device) {
  device_ = device;
  device_name_->setText(device_name(device.device_class));
  fit();
}

void DrillBar::show_grant(const RealtimeGrant& grant) {
  if (shown_grant_ || grant.refusal == RealtimeRefusal::not_asked) return;
  shown_grant_ = true;
  if (!device_.closed_loop || grant.realtime()) return;
  const Message message = describe(grant);
  device_name_->setText(tr("%1, may be delayed").arg(device_name(device_.device_class)));
  device_name_->setToolTip(message.line());
  set_ink(device_name_, "look");
  delayed_ = true;
  fit();
  announce(this, message.line());
}

void DrillBar::offer_pause(bool on) {
  offers_pause_ = on;
  pause_->setVisible(offers_pause_ || stopped_);
  fit();
}

void DrillBar::set_stopped(bool stopped) {
  if (stopped == stopped_) return;
  stopped_ = stopped;
  pause_->setVisible(offers_pause_ || stopped_);
  const QString act = stopped ? tr("Resume") : tr("Pause");
  pause_->setIcon(icon(stopped ? QStringLiteral("play") : QStringLiteral("pause")));
  pause_->setAccessibleName(act);
  pause_->setToolTip(QStringLiteral("%1 (%2)").arg(act, QKeySequence(Qt::Key_P).toString(QKeySequence::NativeText)));
  fit();
}

void DrillBar::enable_pause(bool on) {
  pause_->setEnabled(on);
  finish_->setEnabled(on);
}

void DrillBar::enable_leave(bool on) { leave_->setEnabled(on); }

void DrillBar::enable_finish(bool on) { finish_->setEnabled(on); }

}  // namespace cusp::ui
