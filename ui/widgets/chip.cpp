#include "ui/widgets/chip.h"

#include <QAccessible>
#include <QEvent>
#include <QPainter>

namespace cusp::ui {

QString chip_icon(Chip::Kind kind) {
  switch (kind) {
    case Chip::Kind::plain: return {};
    case Chip::Kind::good: return u"check"_qs;
    case Chip::Kind::look: return u"warning"_qs;
    case Chip::Kind::bad: return u"cross"_qs;
    case Chip::Kind::accent: return u"chart"_qs;
  }
  return {};
}

Ink chip_ink(Chip::Kind kind) {
  switch (kind) {
    case Chip::Kind::plain: return Ink::text2;
    case Chip::Kind::good: return Ink::good;
    case Chip::Kind::look: return Ink::look;
    case Chip::Kind::bad: return Ink::bad;
    case Chip::Kind::accent: return Ink::accent;
  }
  return Ink::text2;
}

QColor chip_fill(Chip::Kind kind, const Tokens& t) {
  switch (kind) {
    case Chip::Kind::plain: return t.sunken;
    case Chip::Kind::good: return t.good_soft;
    case Chip::Kind::look: return t.look_soft;
    case Chip::Kind::bad: return t.bad_soft;
    case Chip::Kind::accent: return t.accent_soft;
  }
  return t.sunken;
}

QSize chip_size(const QString& text, Chip::Kind kind) {
  const QFontMetrics metrics(font_of(TextRole::caption));
  const int sign = chip_icon(kind).isEmpty() ? 0 : px(18);
  return {metrics.horizontalAdvance(text) + sign + px(14), px(20)};
}

void paint_chip(QPainter& painter, const QRect& rect, const QString& text, Chip::Kind kind, const Tokens& t,
                qreal device_pixel_ratio) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(chip_fill(kind, t));
  painter.drawRoundedRect(rect, px(4), px(4));
  QRect inner = rect.adjusted(px(7), 0, -px(7), 0);
  const QString sign = chip_icon(kind);
  const bool rtl = painter.layoutDirection() == Qt::RightToLeft;
  if (!sign.isEmpty()) {
    const QPixmap drawn = icon_pixmap(sign, chip_ink(kind), 14, device_pixel_ratio);
    const int x = rtl ? inner.right() - px(14) : inner.left() - px(1);
    painter.drawPixmap(x, rect.top() + (rect.height() - px(14)) / 2, drawn);
    inner.adjust(rtl ? 0 : px(17), 0, rtl ? -px(17) : 0, 0);
  }
  painter.setFont(font_of(TextRole::caption));
  painter.setPen(colour_of(chip_ink(kind), t));
  painter.drawText(inner, Qt::AlignVCenter | Qt::AlignLeading, text);
  painter.restore();
}

Chip::Chip(const QString& text, Kind kind, QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  set(text, kind);
}

void Chip::set(const QString& text, Kind kind) {
  text_ = text;
  kind_ = kind;
  setAccessibleName(text);
  if (parentWidget() != nullptr) setVisible(!text.isEmpty());  // without a parent it would be a window
  updateGeometry();
  update();
}

QSize Chip::sizeHint() const { return chip_size(text_, kind_); }

void Chip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_chip(painter, QRect(QPoint(0, (height() - px(20)) / 2), QSize(width(), px(20))), text_, kind_, tokens(),
             devicePixelRatioF());
}

void Chip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) updateGeometry();
  if (event->type() == QEvent::ParentChange && text_.isEmpty()) hide();
  QWidget::changeEvent(event);
}

}  // namespace cusp::ui
