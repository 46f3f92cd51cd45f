#include "ui/editor/depth_arrow.h"

#include <QPainter>
#include <QRegion>
#include <cmath>

#include "ui/view/tooth_view.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

DepthArrow::DepthArrow(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void DepthArrow::span(QPointF floor, QPointF top) {
  const QPointF along = top - floor;
  const double length = std::hypot(along.x(), along.y());
  setVisible(length > px(10));
  if (length <= px(10)) return;
  const QPointF u = along / length, n(-u.y(), u.x());
  const double half = px(1.5), head = px(6.0), tall = px(11.0);
  const QRectF box = QRectF(floor, top).normalized().adjusted(-head - 2, -head - 2, head + 2, head + 2);
  setGeometry(box.toAlignedRect());
  const QPointF f = floor - QPointF(pos()), t = top - QPointF(pos()), neck = t - u * tall;
  QPolygonF shape;
  shape << f + n * half << neck + n * half << neck + n * head << t << neck - n * head << neck - n * half << f - n * half;
  path_ = QPainterPath();
  path_.addPolygon(shape);
  path_.closeSubpath();
  QPainterPathStroker wider;
  wider.setWidth(px(2.0));
  setMask(QRegion((path_ + wider.createStroke(path_)).simplified().toFillPolygon().toPolygon()));
  update();
}

void DepthArrow::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), ToothColours::get().map[2]);
  p.setRenderHint(QPainter::Antialiasing);
  p.fillPath(path_, ToothColours::get().casing);
}

}  // namespace cusp::ui
