#include "ui/widgets/paper.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/widgets/format.h"

namespace cusp::ui {

QFont Paper::font(double size, Weight weight) const {
  QFont f = font_of(TextRole::body, weight);
  f.setPixelSize(std::max(1, static_cast<int>(std::lround(size * u_))));
  return f;
}

double Paper::write(const QString& text, const Column& column, const Type& type, Qt::Alignment align, Then then) {
  p_.setFont(font(type.size, type.weight));
  p_.setPen(type.ink);
  const QRectF area(column.x, y_, column.width, page_.bottom() - y_);
  const int flags = static_cast<int>(align | Qt::AlignTop) | Qt::TextWordWrap;
  const QRectF used = p_.boundingRect(area, flags, text);
  p_.drawText(area, flags, text);
  if (then == Then::advance) y_ += used.height();
  return used.height();
}

double Paper::height_of(const QString& text, double width, const Type& type) {
  p_.setFont(font(type.size, type.weight));
  return p_.boundingRect(QRectF(0.0, 0.0, width, page_.height()), static_cast<int>(Qt::AlignLeading | Qt::AlignTop) | Qt::TextWordWrap, text).height();
}

void Paper::rule(const QColor& ink) { p_.fillRect(QRectF(page_.left(), y_, page_.width(), std::max(1.0, u(0.7))), ink); }

void Paper::number(QPointF middle, int number) {
  const Tokens& t = Tokens::light();
  const double r = u(kNumberRing);
  p_.setPen(QPen(t.text, u(1)));
  p_.setBrush(t.surface);
  p_.drawEllipse(middle, r, r);
  p_.setFont(font(9, Weight::bold));
  p_.setPen(t.text);
  p_.drawText(QRectF(middle.x() - r, middle.y() - r, 2 * r, 2 * r), Qt::AlignCenter, installed_locale().toString(number));
}

}  // namespace cusp::ui
