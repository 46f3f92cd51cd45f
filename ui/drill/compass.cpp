#include "ui/drill/compass.h"

#include <QPainter>
#include <cmath>

#include "scenarios/teeth/landmarks.h"
#include "ui/modules.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

Compass::Compass(const ToothView& view, QWidget* parent) : QWidget(parent), view_(view) {
  setFixedSize(px(62), px(62));
  setAccessibleName(tr("Directions"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

std::array<Compass::Way, 4> Compass::ways(int fdi) {
  const double mesial = mesial_x(fdi);
  return {{{{mesial, 0, 0}, tr("M", "mesial")},
           {{-mesial, 0, 0}, tr("D", "distal")},
           {{0, 1, 0}, tr("B", "buccal")},
           {{0, -1, 0}, fdi < 30 ? tr("P", "palatal") : tr("L", "lingual")}}};
}

void Compass::set_tooth(int fdi) {
  fdi_ = fdi;
  setVisible(mesial_x(fdi) != 0);
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
  for (const auto& [way, letter] : ways(fdi_)) {
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
