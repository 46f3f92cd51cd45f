#include "ui/widgets/icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSet>
#include <QSvgRenderer>

namespace cusp::ui {
namespace {

/// Icons that point along the reading direction.
bool is_directional(const QString& name) {
  static const QSet<QString> names = {u"chevron_left"_qs, u"chevron_right"_qs, u"list"_qs, u"undo"_qs,
                                      u"redo"_qs,         u"sign_out"_qs};
  return names.contains(name);
}

class TokenIconEngine : public QIconEngine {
 public:
  TokenIconEngine(QString name, Ink ink) : name_(std::move(name)), ink_(ink) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const int side = std::min(rect.width(), rect.height());
    const qreal ratio = painter->device() ? painter->device()->devicePixelRatioF() : 1.0;
    const QPixmap drawn = draw(side, mode, ratio);
    painter->drawPixmap(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, drawn);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
    return draw(std::min(size.width(), size.height()), mode, 1.0);
  }
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override {
    QPixmap p = draw(qRound(std::min(size.width(), size.height()) / scale), mode, scale);
    p.setDevicePixelRatio(1.0);
    return p;
  }
  QIconEngine* clone() const override { return new TokenIconEngine(name_, ink_); }
  QString iconName() override { return name_; }

 private:
  QPixmap draw(int side, QIcon::Mode mode, qreal ratio) const;
  QString name_;
  Ink ink_;
};

QPixmap render(const QString& name, const QColor& colour, int side, qreal ratio) {
  const bool mirrored = is_directional(name) && QGuiApplication::layoutDirection() == Qt::RightToLeft;
  const QString key = QStringLiteral("cusp/%1/%2/%3/%4/%5")
                          .arg(name, colour.name(QColor::HexArgb))
                          .arg(side)
                          .arg(ratio)
                          .arg(mirrored);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  pixmap = QPixmap(QSize(side, side) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QSvgRenderer svg(u":/cusp/icons/"_qs + name + u".svg"_qs);
  Q_ASSERT_X(svg.isValid(), "cusp::icon", qPrintable(name));
  QPainter painter(&pixmap);
  if (mirrored) {
    painter.translate(side, 0);
    painter.scale(-1, 1);
  }
  svg.render(&painter, QRectF(0, 0, side, side));
  painter.resetTransform();
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(QRectF(0, 0, side, side), colour);
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QPixmap TokenIconEngine::draw(int side, QIcon::Mode mode, qreal ratio) const {
  const Tokens& t = tokens();
  const QColor colour = mode == QIcon::Disabled ? t.text3 : ui::colour_of(ink_, t);
  return render(name_, colour, std::max(side, 1), ratio);
}

}  // namespace

QColor colour_of(Ink ink, const Tokens& t) {
  switch (ink) {
    case Ink::text: return t.text;
    case Ink::text2: return t.text2;
    case Ink::text3: return t.text3;
    case Ink::accent: return t.accent;
    case Ink::on_accent: return t.on_accent;
    case Ink::good: return t.good;
    case Ink::look: return t.look;
    case Ink::bad: return t.bad;
  }
  return t.text;
}

QIcon icon(const QString& name, Ink ink) {
  Q_ASSERT_X(QFile::exists(u":/cusp/icons/"_qs + name + u".svg"_qs), "cusp::icon", qPrintable(name));
  return QIcon(new TokenIconEngine(name, ink));
}

QPixmap icon_pixmap(const QString& name, Ink ink, int size, double device_pixel_ratio) {
  return render(name, colour_of(ink), px(size), device_pixel_ratio);
}

}  // namespace cusp::ui
