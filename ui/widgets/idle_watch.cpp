#include "ui/widgets/idle_watch.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>
#include <utility>

namespace cusp::ui {
namespace {

constexpr std::chrono::milliseconds kLook{5000};  // so soon a computer that wakes is locked without input

bool is_input(QEvent::Type type) {
  switch (type) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:  // a shortcut's key comes as no other press
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate: return true;
    default: return false;
  }
}

}  // namespace

IdleWatch::IdleWatch(std::function<std::chrono::milliseconds()> clock, QObject* parent) : QObject(parent), clock_(std::move(clock)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &IdleWatch::look);
  QCoreApplication::instance()->installEventFilter(this);
}

void IdleWatch::set_limit(std::chrono::milliseconds limit) {
  limit_ = limit;
  wait();
}

/// The whole time from now on.
void IdleWatch::wait() {
  last_input_ = clock_();
  if (limit_.count() > 0) {
    timer_.start(std::min(limit_, kLook));
  } else {
    timer_.stop();
  }
}

void IdleWatch::look() {
  const auto left = last_input_ + limit_ - clock_();
  if (left.count() > 0) return timer_.start(std::min(left, kLook));
  Q_EMIT idle();
}

bool IdleWatch::count_input() {
  if (timer_.isActive() && clock_() - last_input_ >= limit_) {
    timer_.start(0);  // not from here: who is signed out may take the receiver of the event along
    return false;
  }
  wait();
  return true;
}

bool IdleWatch::eventFilter(QObject* watched, QEvent* event) {
  if (!is_input(event->type()) || count_input()) return QObject::eventFilter(watched, event);
  event->accept();  // a shortcut that nobody overrides would act
  return true;
}

}  // namespace cusp::ui
