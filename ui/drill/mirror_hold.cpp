#include "ui/drill/mirror_hold.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <numbers>

namespace cusp::ui {
namespace {

constexpr double kStepMm = 0.5;
constexpr double kStepRad = 3.0 * std::numbers::pi / 180.0;
constexpr double kTiltRadPerPx = 0.004;
constexpr double kMmPerNotch = 1.0;
constexpr double kWholeMirrorMm = 14.0;  // of the view, from its middle to its edge

}  // namespace

MirrorHold::MirrorHold(ToothView& view) : QObject(&view), view_(view) { view_.installEventFilter(this); }

void MirrorHold::take(Vec3 place_mm) {
  const MouthMirror mirror = mirror_behind(view_.camera(), place_mm);
  before_ = view_.camera();
  Camera wide = Camera::about(0.4 * place_mm + 0.6 * mirror.centre_mm, kWholeMirrorMm);
  wide.set_angles(before_->yaw(), before_->pitch());
  if (wide.distance_mm() > before_->distance_mm()) view_.set_camera(wide);
  view_.set_mirror(mirror);
}

void MirrorHold::put_away() {
  last_.reset();
  view_.set_mirror(std::nullopt);
  if (!before_) return;
  Camera back = *before_;
  back.set_angles(view_.camera().yaw(), view_.camera().pitch());
  before_.reset();
  view_.set_camera(back);
}

bool MirrorHold::press_key(int key, Qt::KeyboardModifiers modifiers) {
  if (!held()) return false;
  Vec3 way(0.0);
  switch (key) {
    case Qt::Key_I: way.y = 1; break;
    case Qt::Key_K: way.y = -1; break;
    case Qt::Key_J: way.x = -1; break;
    case Qt::Key_L: way.x = 1; break;
    case Qt::Key_U: way.z = -1; break;
    case Qt::Key_O: way.z = 1; break;
    default: return false;
  }
  const bool tilts = (modifiers & Qt::ShiftModifier) && way.z == 0;
  const MouthMirror& now = *view_.scene().mirror;
  view_.set_mirror(tilts ? turned(now, view_.camera(), kStepRad * glm::dvec2(way.x, -way.y))
                         : moved(now, view_.camera(), kStepMm * way));
  return true;
}

bool MirrorHold::over(QPointF at) const {
  if (!held()) return false;
  const auto glass = distance_to(*view_.scene().mirror, view_.ray(at));
  if (!glass) return false;
  const auto tooth = view_.pick(at);
  return !tooth || tooth->distance_mm > *glass;
}

double MirrorHold::mm_per_px() const {
  const Camera& camera = view_.camera();
  const double depth = glm::dot(view_.scene().mirror->centre_mm - camera.eye_mm(), camera.forward());
  return depth / camera.distance_mm() / camera.px_per_mm(std::min(view_.width(), view_.height()));
}

void MirrorHold::drag(QPointF to) {
  const QPointF by = to - *last_;
  last_ = to;
  const MouthMirror& now = *view_.scene().mirror;
  if (button_ == Qt::LeftButton) {
    view_.set_mirror(moved(now, view_.camera(), mm_per_px() * Vec3(by.x(), -by.y(), 0.0)));
  } else {
    view_.set_mirror(turned(now, view_.camera(), kTiltRadPerPx * glm::dvec2(by.x(), by.y())));
  }
}

bool MirrorHold::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &view_ || !held()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->button() == Qt::MiddleButton || mouse->modifiers() != Qt::NoModifier || !over(mouse->position())) break;
      last_ = mouse->position();
      button_ = mouse->button();
      return true;
    }
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (last_) {
        drag(mouse->position());
        return true;
      }
      // A bur led over the glass would go into what lies behind it.
      if (mouse->buttons() == Qt::NoButton && over(mouse->position())) return true;
      break;
    }
    case QEvent::MouseButtonRelease:
      if (last_ && static_cast<QMouseEvent*>(event)->button() == button_) {
        last_.reset();
        return true;
      }
      break;
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      if (wheel->modifiers() != Qt::NoModifier || !over(wheel->position())) break;
      view_.set_mirror(moved(*view_.scene().mirror, view_.camera(), Vec3(0.0, 0.0, kMmPerNotch * wheel->angleDelta().y() / 120.0)));
      return true;
    }
    case QEvent::Hide:
    case QEvent::WindowDeactivate: last_.reset(); break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace cusp::ui
