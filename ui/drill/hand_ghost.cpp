#include "ui/drill/hand_ghost.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/view/tooth_view.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kLeastRadius = 6, kCasing = 4, kStroke = 2;  // px at 100 %

}  // namespace

HandGhost::HandGhost(const ToothView& view, QWidget* parent) : QWidget(parent), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void HandGhost::follow(const std::optional<Vec3>& hand_mm, const Bur& bur) {
  const bool lags = hand_mm && glm::length(*hand_mm - bur.at_mm) > kLagMm;
  const auto hand = lags ? view_.project(*hand_mm) : std::nullopt;
  const auto at = lags ? view_.project(bur.at_mm) : std::nullopt;
  setVisible(hand && at);
  if (!hand || !at) return;
  const double radius = std::max<double>(px(kLeastRadius), bur.radius_mm * view_.camera().px_per_mm(std::min(view_.width(), view_.height())));
  QRectF ring(0, 0, 2 * radius, 2 * radius);
  ring.moveCenter(*hand);
  const QLineF whole(*hand, *at);
  const QLineF line(whole.pointAt(std::min(1.0, radius / whole.length())), whole.p2());
  const QRect box = ring.united(QRectF(line.p1(), line.p2()).normalized()).toAlignedRect().adjusted(-px(kCasing), -px(kCasing), px(kCasing), px(kCasing));
  setGeometry(box);
  ring_ = ring.translated(-box.topLeft());
  line_ = line.translated(-box.topLeft());
  QPainterPath path(line_.p1());
  path.lineTo(line_.p2());
  QPainterPathStroker stroker;
  stroker.setWidth(px(kCasing));
  const double half = px(kCasing) / 2.0;
  setMask(QRegion(ring_.adjusted(-half, -half, half, half).toAlignedRect(), QRegion::Ellipse) -
          QRegion(ring_.adjusted(half, half, -half, -half).toAlignedRect(), QRegion::Ellipse) +
          QRegion(stroker.createStroke(path).toFillPolygon().toPolygon()));
  update();
}

void HandGhost::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), ToothColours::get().casing);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(ToothColours::get().map[2], px(kStroke)));
  p.drawLine(line_);
  p.drawEllipse(ring_);
}

}  // namespace cusp::ui
