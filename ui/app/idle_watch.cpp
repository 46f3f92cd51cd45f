#include "ui/app/idle_watch.h"

#include <QCoreApplication>
#include <QEvent>

namespace cusp::ui {

IdleWatch::IdleWatch(QObject* parent) : QObject(parent) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &IdleWatch::idle);
  QCoreApplication::instance()->installEventFilter(this);
}

void IdleWatch::set_limit(std::chrono::milliseconds limit) {
  timer_.setInterval(limit);
  if (limit.count() > 0) {
    timer_.start();
  } else {
    timer_.stop();
  }
}

bool IdleWatch::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
      if (timer_.interval() > 0) timer_.start();
      break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace cusp::ui
