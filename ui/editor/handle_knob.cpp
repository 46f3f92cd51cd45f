#include "ui/editor/handle_knob.h"

#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/editor/target_view.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kBody = 14, kWhole = 22;                // px: a handle, and with its focus ring
constexpr double kCoreShare = 0.5;                     // of the body's width: the core of a landmark that is set
constexpr double kCrossMargin = 0.25;                  // of the body's width: about the cross
constexpr double kStepMm = 0.05, kFineStepMm = 0.01;  // of an arrow key

/// A handle for screen readers: a slider with place or size as its value. Two actions change a depth or a width by one step; a
/// point has none, and its numbers stand in the form.
class KnobForReaders : public QAccessibleWidget {
 public:
  explicit KnobForReaders(HandleKnob* knob) : QAccessibleWidget(knob, QAccessible::Slider), knob_(*knob) {}
  QStringList actionNames() const override {
    QStringList names = QAccessibleWidget::actionNames();
    if (!knob_.handle().is_place()) names << increaseAction() << decreaseAction();
    return names;
  }
  void doAction(const QString& name) override {
    const bool more = name == increaseAction();
    if (!more && name != decreaseAction()) return QAccessibleWidget::doAction(name);
    const bool down = knob_.handle().is_floor();
    const auto [less_key, more_key] = down ? std::pair{Qt::Key_Up, Qt::Key_Down} : std::pair{Qt::Key_Left, Qt::Key_Right};
    QKeyEvent press(QEvent::KeyPress, more ? more_key : less_key, Qt::NoModifier);
    QCoreApplication::sendEvent(&knob_, &press);
  }
  QString text(QAccessible::Text what) const override {
    return what == QAccessible::Value ? widget()->accessibleDescription() : QAccessibleWidget::text(what);
  }

 private:
  HandleKnob& knob_;
};

enum class Form : std::uint8_t { square, round };

void fill(QPainter& p, const QRectF& area, const QColor& colour, Form form) {
  p.setPen(Qt::NoPen);
  p.setBrush(colour);
  if (form == Form::round) {
    p.drawEllipse(area);
  } else {
    p.drawRect(area);
  }
}

/// White with a dark edge.
void paint_body(QPainter& p, const QRectF& body, Form form) {
  fill(p, body, ToothColours::get().casing, form);
  fill(p, body.adjusted(px(2), px(2), -px(2), -px(2)), Tokens::light().surface, form);
}

void paint_core(QPainter& p, const QRectF& body) {
  const double edge = body.width() * (1.0 - kCoreShare) / 2.0;
  fill(p, body.adjusted(edge, edge, -edge, -edge), ToothColours::get().casing, Form::round);
}

/// Two arms across a body that moves several shapes.
void paint_cross(QPainter& p, const QRectF& body) {
  const double edge = body.width() * kCrossMargin, half = px(1);
  const QPointF middle = body.center();
  fill(p, {body.left() + edge, middle.y() - half, body.width() - 2 * edge, 2 * half}, ToothColours::get().casing, Form::square);
  fill(p, {middle.x() - half, body.top() + edge, 2 * half, body.height() - 2 * edge}, ToothColours::get().casing, Form::square);
}

QAccessibleInterface* knob_for_readers(const QString&, QObject* object) {
  auto* knob = qobject_cast<HandleKnob*>(object);
  return knob ? new KnobForReaders(knob) : nullptr;
}

}  // namespace

HandleKnob::HandleKnob(TargetView& stage, int) : QWidget(&stage), stage_(stage) {
  [[maybe_unused]] static const bool once = (QAccessible::installFactory(knob_for_readers), true);
  setFocusPolicy(Qt::StrongFocus);
  setFixedSize(px(kWhole), px(kWhole));
  setCursor(Qt::SizeAllCursor);
  fit_mask();
}

void HandleKnob::fit_mask() {
  const int edge = hasFocus() ? 0 : (px(kWhole) - px(kBody)) / 2;
  const QRect area = rect().adjusted(edge, edge, -edge, -edge);
  setMask(handle_.is_round() ? QRegion(area, QRegion::Ellipse) : QRegion(area));
}

void HandleKnob::set_handle(const TargetHandle& handle, const QString& name, const QString& value) {
  const bool other = handle.kind != handle_.kind;
  if (other || handle.state != handle_.state) update();
  handle_ = handle;
  setAccessibleName(name);
  setAccessibleDescription(value);
  setToolTip(short_tool_tip(name + u": "_qs + value));
  if (other) fit_mask();
}

void HandleKnob::paintEvent(QPaintEvent*) {
  QPainter p(this);
  const ToothColours& c = ToothColours::get();
  p.fillRect(rect(), hasFocus() ? tokens().accent : c.casing);
  p.setRenderHint(QPainter::Antialiasing);
  const double edge = (px(kWhole) - px(kBody)) / 2.0;
  const QRectF body = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
  const Form form = handle_.is_round() ? Form::round : Form::square;
  if (hasFocus()) fill(p, body.adjusted(-2, -2, 2, 2), Tokens::light().surface, form);
  paint_body(p, body, form);
  if (handle_.kind == TargetHandle::Kind::landmark && handle_.state == MarkState::set) paint_core(p, body);
  if (handle_.kind == TargetHandle::Kind::whole) paint_cross(p, body);
}

void HandleKnob::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  stage_.model_.end_gesture();
  start_ = handle_;
  start_part_ = stage_.model_.chosen();
  start_at_ = mapToParent(event->position());
  dragging_ = true;
}

void HandleKnob::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return;
  const QPointF now = mapToParent(event->position());
  const auto snap = event->modifiers() & Qt::ShiftModifier ? TargetView::Snap::none : TargetView::Snap::landmarks;
  if (start_.kind == TargetHandle::Kind::landmark) return stage_.drag_landmark(start_, {start_at_, now});
  if (!start_.of_outline()) return stage_.drag_part(start_, start_part_, {start_at_, now, snap});
  Vec3 to = start_.at_mm;
  if (start_.kind == TargetHandle::Kind::depth) {
    const auto from = stage_.view_->project(start_.at_mm), below = stage_.view_->project(start_.at_mm - Vec3(0, 0, 1));
    if (!from || !below) return;
    const QPointF by = now - start_at_, down = *below - *from;  // px of one millimetre deeper
    const double length2 = QPointF::dotProduct(down, down);
    // From above a depth has no length on the screen; then "down" means deeper.
    const double scale = stage_.view_->camera().px_per_mm(std::min(stage_.width(), stage_.height()));
    to.z -= length2 > 16.0 ? QPointF::dotProduct(by, down) / length2 : by.y() / std::max(scale, 1.0);
  } else {
    const auto a = stage_.on_plane(start_at_), b = stage_.on_plane(now);
    if (!a || !b) return;
    to += *b - *a;
    if (start_.kind == TargetHandle::Kind::point && snap == TargetView::Snap::landmarks) to = stage_.snapped(to);
  }
  stage_.apply(start_, start_part_.outline, to);
}

void HandleKnob::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = false;
  stage_.model_.end_gesture();
}

void HandleKnob::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Delete && handle_.kind == TargetHandle::Kind::point) {
    stage_.model_.remove_point(handle_.path, handle_.point);
    return;
  }
  if (key == Qt::Key_Delete && handle_.kind == TargetHandle::Kind::landmark) {
    stage_.model_.remove_landmark(handle_.path);
    return;
  }
  if (key == Qt::Key_L && handle_.is_place() && handle_.kind != TargetHandle::Kind::landmark) {
    stage_.model_.end_gesture();
    return stage_.snap(handle_);
  }
  const int x = key == Qt::Key_Right ? 1 : key == Qt::Key_Left ? -1 : 0;
  const int y = key == Qt::Key_Up ? 1 : key == Qt::Key_Down ? -1 : 0;
  if (x == 0 && y == 0) return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier ? kFineStepMm : kStepMm;
  if (!event->isAutoRepeat()) stage_.model_.end_gesture();
  if (handle_.kind == TargetHandle::Kind::landmark) return stage_.step_landmark(handle_, {x, y}, step);
  if (handle_.of_outline()) return step_outline({x, y}, step);
  stage_.step_part(handle_, {x, y}, step);
}

void HandleKnob::step_outline(glm::ivec2 keys, double step) {
  const auto [x, y] = std::pair{keys.x, keys.y};
  Vec3 to = handle_.at_mm;
  const Outline target = stage_.model_.outline();
  switch (handle_.kind) {
    case TargetHandle::Kind::point: {
      // The axis of the specimen that is nearest to the key's direction on the screen.
      const Vec3 right = stage_.view_->camera().right();
      const bool along_x = std::abs(right.x) >= std::abs(right.y);
      const Vec3 axis = along_x ? Vec3(right.x >= 0 ? 1 : -1, 0, 0) : Vec3(0, right.y >= 0 ? 1 : -1, 0);
      const Vec3 away(-axis.y, axis.x, 0);
      to += step * (static_cast<double>(x) * axis + static_cast<double>(y) * away);
      break;
    }
    case TargetHandle::Kind::width: {
      // Each side moves by half: the step is one of the width.
      Outline wider = target;
      wider.width_mm = std::max(target.width_mm + (x + y) * step, kLeastHandleMm);
      stage_.model_.set_width_mm(std::round(wider.width_mm * 1e4) / 1e4);
      return;
    }
    case TargetHandle::Kind::size_x: to.x += (x + y) * step / 2; break;
    case TargetHandle::Kind::size_y: to.y += (x + y) * step / 2; break;
    case TargetHandle::Kind::depth: to.z += (x + y) * step; break;
    default: return;
  }
  stage_.apply(handle_, target, to);
}

void HandleKnob::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  fit_mask();
  raise();
  if (handle_.kind == TargetHandle::Kind::landmark) stage_.model_.choose_landmark({handle_.path, handle_.point});
  else stage_.place_handles();
}

void HandleKnob::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  stage_.model_.end_gesture();
  fit_mask();
  stage_.place_handles();
}

KnobSample::KnobSample(MarkState state, QWidget* parent) : QWidget(parent), state_(state) { setFixedSize(px(kWhole), px(kWhole)); }

void KnobSample::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), ToothColours::get().enamel);  // on a dark card the dark edge would not show
  p.setRenderHint(QPainter::Antialiasing);
  const double edge = (px(kWhole) - px(kBody)) / 2.0;
  const QRectF body = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
  paint_body(p, body, Form::round);
  if (state_ == MarkState::set) paint_core(p, body);
}

}  // namespace cusp::ui
