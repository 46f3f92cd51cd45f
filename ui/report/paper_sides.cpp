#include "ui/report/paper_sides.h"

#include <QPainter>

#include "ui/render/camera.h"
#include "ui/text/tooth_sides.h"

namespace cusp::ui {

void write_sides(Paper& paper, const QRectF& where, int fdi) {
  if (!is_tooth_number(fdi)) return;
  const Tokens& t = Tokens::light();
  Camera above = Camera::about({}, 1.0);
  above.set_preset(PresetView::occlusal);
  QPainter& p = paper.painter();
  p.setFont(paper.font(11, Weight::bold));
  const double half = paper.u(9), edge = half + paper.u(5);
  const QRectF room = where.adjusted(edge, edge, -edge, -edge);
  for (const ToothSide& side : tooth_sides(fdi)) {
    const double right = glm::dot(side.way, above.right()), down = -glm::dot(side.way, above.up());
    const QPointF at = room.center() + QPointF(0.5 * room.width() * right, 0.5 * room.height() * down);
    p.setPen(QPen(t.line, paper.u(0.7)));
    p.setBrush(t.surface);
    p.drawEllipse(at, half, half);
    p.setPen(t.text);
    p.drawText(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half), Qt::AlignCenter, side.letter);
  }
}

}  // namespace cusp::ui
