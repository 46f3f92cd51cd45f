#include "ui/replay/playback_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ui/widgets/format.h"
#include "ui/widgets/icon.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kTicksPerSecond = 10;  // of the slider
constexpr double kSpeeds[] = {0.5, 1.0, 2.0};
constexpr int kUsualSpeed = 1;
constexpr double kStep_s = 1.0, kFineStep_s = 0.1;

}  // namespace

PlaybackBar::PlaybackBar(QWidget* parent) : QFrame(parent) {
  setProperty("kind", u"bar_bottom"_qs);
  setLayoutDirection(Qt::LeftToRight);  // time runs to the right in every language
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(px(16), px(8), px(16), px(8));
  row->setSpacing(px(16));
  play_ = make_button(tr("Pause"), ButtonKind::primary, u"pause"_qs);
  play_->setMinimumWidth(px(96));  // Play and Pause take the same place
  play_->installEventFilter(this);
  row->addWidget(play_);
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setAccessibleName(tr("Position"));
  slider_->setSingleStep(kTicksPerSecond);
  slider_->setPageStep(5 * kTicksPerSecond);
  slider_->installEventFilter(this);
  row->addWidget(slider_, 1);
  time_ = make_label({}, TextRole::body);
  time_->setMinimumWidth(px(80));
  row->addWidget(time_);
  QStringList speeds;
  //: Speed of what is watched; %1 is a number such as 0.5.
  for (const double speed : kSpeeds) speeds += tr("%1×").arg(QLocale().toString(speed));
  speed_ = new Segments(speeds);
  speed_->setAccessibleName(tr("Speed"));
  speed_->choose(kUsualSpeed);
  row->addWidget(speed_);
  connect(play_, &QPushButton::clicked, this, [this] { set_playing(!playing_); });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { seek(static_cast<double>(value) / kTicksPerSecond); });
  setFocusProxy(play_);
  show_playing();
}

void PlaybackBar::set_length(double seconds) {
  length_s_ = seconds;
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, static_cast<int>(std::lround(seconds * kTicksPerSecond)));
  show_position();
}

void PlaybackBar::set_playing(bool on) {
  if (on == playing_) return;
  playing_ = on;
  show_playing();
  if (on && position_s_ >= length_s_) seek(0);
  Q_EMIT playing_changed(on);
}

void PlaybackBar::seek(double s) {
  const double to = std::clamp(s, 0.0, length_s_);
  if (to == position_s_) return;
  position_s_ = to;
  show_position();
  Q_EMIT position_changed(position_s_);
}

void PlaybackBar::advance(double dt_s, double ready_s) {
  if (!playing_ || slider_->isSliderDown() || position_s_ > ready_s + kAhead_s) return;
  const double speed = kSpeeds[std::max(speed_->chosen(), 0)];
  seek(std::min(position_s_ + speed * dt_s, ready_s + kAhead_s + speed * kFineStep_s));
  if (position_s_ >= length_s_) set_playing(false);
}

bool PlaybackBar::press_key(int key, Qt::KeyboardModifiers modifiers) {
  const double step = modifiers & Qt::ShiftModifier ? kFineStep_s : kStep_s;
  if (key == Qt::Key_Space) set_playing(!playing_);
  else if (key == Qt::Key_Left) seek(position_s_ - step);
  else if (key == Qt::Key_Right) seek(position_s_ + step);
  else if (key == Qt::Key_Home) seek(0);
  else if (key == Qt::Key_End) seek(length_s_);
  else return false;
  return true;
}

/// The slider's own keys know no Shift, and arrows would move the focus from the button. Space presses the button by itself.
bool PlaybackBar::eventFilter(QObject* watched, QEvent* event) {
  if ((watched == slider_ || watched == play_) && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->isAutoRepeat()) return true;
    const bool pressed = watched == play_ && key->key() == Qt::Key_Space;
    return !pressed && press_key(key->key(), key->modifiers());
  }
  return QFrame::eventFilter(watched, event);
}

void PlaybackBar::show_position() {
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(position_s_ * kTicksPerSecond)));
  const QString text = tr("%1 of %2").arg(format_clock(std::floor(position_s_)), format_clock(length_s_));
  if (text == time_->text()) return;
  time_->setText(text);
  slider_->setAccessibleDescription(text);
}

void PlaybackBar::show_playing() {
  const QString act = playing_ ? tr("Pause") : tr("Play");
  play_->setIcon(icon(playing_ ? u"pause"_qs : u"play"_qs, Ink::on_accent));
  play_->setText(u' ' + act);  // as make_button: the style leaves no space after the sign
  play_->setAccessibleName(act);
  //: The name of a key stands in brackets.
  play_->setToolTip(tr("%1 (%2)").arg(act, QKeySequence(Qt::Key_Space).toString(QKeySequence::NativeText)));
}

}  // namespace cusp::ui
