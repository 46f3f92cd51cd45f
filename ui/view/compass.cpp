#include "ui/view/compass.h"

#include <QPainter>
#include <cmath>

#include "ui/text/tooth_sides.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

Compass::Compass(ToothView& view, QWidget* parent) : QWidget(parent), view_(view) {
  setFixedSize(px(62), px(62));
  setAccessibleName(tr("Directions"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  connect(&view, &ToothView::camera_changed, this, qOverload<>(&Compass::update));
}

void Compass::set_tooth(int fdi) {
  fdi_ = fdi;
  setVisible(is_tooth_number(fdi));
  update();
}

void Compass::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QPointF middle(width() / 2.0, height() / 2.0);
  p.setPen(QPen(t.line, 1));
  p.setBrush(t.surface);
  p.drawEllipse(middle, width() / 2.0 - 1, height() / 2.0 - 1);
  const Vec3 right = view_.camera().right(), up = view_.camera().up();
  p.setFont(font_of(TextRole::caption, Weight::bold));
  for (const auto& [way, letter] : tooth_sides(fdi_)) {
    QPointF to(glm::dot(way, right), -glm::dot(way, up));
    const double length = std::hypot(to.x(), to.y());
    if (length < 0.25) continue;  // points at the viewer or away
    to /= length;
    p.setPen(QPen(t.border, 1));
    p.drawLine(middle + to * px(4), middle + to * px(13));
    p.setPen(t.text);
    const QPointF at = middle + to * px(21);
    p.drawText(QRectF(at.x() - px(8), at.y() - px(8), px(16), px(16)), Qt::AlignCenter, letter);
  }
}

}  // namespace cusp::ui
