#include "ui/drill/pointer_input.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>

namespace cusp::ui {

PointerInput::PointerInput(ToothView& view, PointerHand& hand, Vec3 tool_axis, double usual_push_n, QObject* parent)
    : QObject(parent), view_(view), hand_(hand), axis_(tool_axis), push_n_(usual_push_n) {
  view_.setMouseTracking(true);
  view_.set_wheel_taken(true);
  connect(&view_, &ToothView::camera_changed, this, &PointerInput::show_view);
  view_.installEventFilter(this);
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
    if (state != Qt::ApplicationActive) release_all();
  });
  connect(&view_, &ToothView::moved, this, [this](QPointF at, Qt::MouseButtons buttons) {
    // The button was released without an event for this view: over another window, in a menu.
    if (button_ && !(buttons & Qt::LeftButton)) release_all();
    if (!(buttons & Qt::LeftButton)) ignores_button_ = false;
    if (!(buttons & (Qt::RightButton | Qt::MiddleButton))) slide(at);
  });
  connect(&view_, &ToothView::pressed, this, [this](QPointF at) {
    ignores_button_ = !enabled_;
    if (!enabled_) return;
    slide(at);
    if (!plane_at_) return;  // no tooth was under the mouse yet
    button_ = true;
    hand_over();
    Q_EMIT drilled();
  });
  connect(&view_, &ToothView::released, this, [this](QPointF) {
    button_ = ignores_button_ = false;
    hand_over();
  });
  connect(&view_, &ToothView::wheel_turned, this, &PointerInput::turn_wheel);
  timer_.setInterval(8);
  connect(&timer_, &QTimer::timeout, this, &PointerInput::step_keys);
  show_view();
}

bool PointerInput::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::WindowDeactivate:  // Alt+Tab, a dialog
    case QEvent::WindowBlocked:
    case QEvent::Hide:              // the page was left
    case QEvent::EnabledChange:
    case QEvent::TouchCancel:
    case QEvent::TabletLeaveProximity:
    case QEvent::UngrabMouse: release_all(); break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

void PointerInput::show_view() {
  // Right on the screen, flat across the approach.
  const Vec3 right = view_.camera().right();
  hand_.set_view(-axis_, right - glm::dot(right, axis_) * axis_);
}

void PointerInput::slide(QPointF at) {
  if (!enabled_) return;
  const Ray ray = view_.ray(at);
  if (button_ || space_) {
    const double down = glm::dot(ray.along, axis_);
    if (std::abs(down) > 0.05) {
      const double t = glm::dot(*plane_at_ - ray.from_mm, axis_) / down;
      if (t > 0) hand_.move_to(ray.from_mm + t * ray.along);
    }
    return;
  }
  if (const auto hit = view_.pick(at)) {
    plane_at_ = hit->at_mm;
    hand_.move_to(hit->at_mm);
  }
}

/// A fine wheel and a touchpad send a notch in parts.
void PointerInput::turn_wheel(int delta) {
  constexpr int kNotch = 120;
  if ((delta > 0) != (wheel_ > 0)) wheel_ = 0;
  wheel_ += delta;
  const int notches = wheel_ / kNotch;
  wheel_ -= notches * kNotch;
  if (notches != 0) change_push(kPushStepN * notches);
}

void PointerInput::change_push(double by) {
  push_n_ = std::clamp(std::round((push_n_ + by) / kPushStepN) * kPushStepN, kLeastPushN, PointerHand::kMaxPushN);
  if (held_push_n_ > 0) held_push_n_ = push_n_;
  hand_over();
  Q_EMIT push_changed(push_n_);
}

void PointerInput::hand_over() {
  const bool drilling = enabled_ && (button_ || space_);
  hand_.set_cut(drilling);
  hand_.set_push(!enabled_ ? 0.0 : drilling ? push_n_ : held_push_n_);
}

bool PointerInput::press_key(int key, KeyPress press) {
  const bool repeated = press == KeyPress::repeated;
  if (key == Qt::Key_Space && !repeated) ignores_space_ = !enabled_;
  if (!enabled_) return false;
  switch (key) {
    case Qt::Key_Space:
      if (!repeated) {
        space_ = true;
        plane_at_ = hand_.wish().target_mm;
        hand_over();
        Q_EMIT drilled();
      }
      return true;
    case Qt::Key_PageDown:
      if (held_push_n_ <= 0) {
        held_push_n_ = push_n_;
        hand_over();
      } else {
        change_push(kPushStepN);
      }
      return true;
    case Qt::Key_PageUp:
      if (push_n_ <= kLeastPushN + 1e-6 || held_push_n_ <= 0) {
        held_push_n_ = 0;  // lifts off
        hand_over();
      } else {
        change_push(-kPushStepN);
      }
      return true;
    case Qt::Key_H:
      if (!repeated) hold_depth(!held_);
      return true;
    case Qt::Key_Home:
      if (hand_.turned_deg() <= 0) return false;
      hand_.turn_back();
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      if (!repeated) {
        arrows_.insert(key);
        if (!timer_.isActive()) {
          since_.start();
          timer_.start();
        }
      }
      return true;
    default: return false;
  }
}

bool PointerInput::release_key(int key) {
  if (key == Qt::Key_Space) {
    space_ = ignores_space_ = false;
    hand_over();
    return true;
  }
  if (arrows_.remove(key)) {
    step_keys();
    if (arrows_.isEmpty()) timer_.stop();
    return true;
  }
  return false;
}

void PointerInput::follow_bur(Vec3 pivot_mm, std::optional<double> above_floor_mm) {
  if (button_ || space_) drilled_mm_ = pivot_mm;
  hand_.set_floor(above_floor_mm ? std::optional(pivot_mm - axis_ * *above_floor_mm) : std::nullopt);
}

std::optional<Vec3> PointerInput::hand_mm(Vec3 pivot_mm) const {
  if (!enabled_ || (!button_ && !space_)) return std::nullopt;
  const Vec3 hand = hand_.wish().target_mm;
  return hand + glm::dot(pivot_mm - hand, axis_) * axis_;
}

void PointerInput::hold_depth(bool on) {
  held_ = on && drilled_mm_;
  hand_.hold_depth(held_ ? drilled_mm_ : std::nullopt);
  Q_EMIT depth_held(held_);
}

void PointerInput::forget_depth() {
  drilled_mm_.reset();
  hold_depth(false);
}

void PointerInput::step_keys() {
  const double seconds = std::min(static_cast<double>(since_.restart()) / 1000.0, 0.1);
  const bool fine = QGuiApplication::keyboardModifiers() & Qt::ShiftModifier;
  const double mm = seconds * (fine ? kSlideMmS / 5 : kSlideMmS);
  const double right = (arrows_.contains(Qt::Key_Right) ? mm : 0) - (arrows_.contains(Qt::Key_Left) ? mm : 0);
  const double up = (arrows_.contains(Qt::Key_Up) ? mm : 0) - (arrows_.contains(Qt::Key_Down) ? mm : 0);
  if (right == 0 && up == 0) return;
  if (QGuiApplication::keyboardModifiers() & Qt::ControlModifier)
    hand_.turn(right * kTurnDegPerMm, up * kTurnDegPerMm);
  else
    hand_.nudge(right, up);
}

void PointerInput::release_all() {
  stop();
  ignores_button_ = ignores_space_ = false;
}

void PointerInput::stop() {
  ignores_button_ = ignores_button_ || button_;
  ignores_space_ = ignores_space_ || space_;
  button_ = space_ = false;
  held_push_n_ = 0;
  arrows_.clear();
  timer_.stop();
  hand_over();
}

void PointerInput::set_enabled(bool on) {
  if (!on) stop();
  enabled_ = on;
}

}  // namespace cusp::ui
