#include "ui/drill/section_view.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

SectionView::SectionView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Section at the bur"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize SectionView::sizeHint() const { return {px(271), px(202)}; }

void SectionView::set_sides(const QString& left, const QString& right) {
  left_ = left;
  right_ = right;
  update();
}

void SectionView::show_image(const SectionImage& image) {
  image_ = QImage(reinterpret_cast<const uchar*>(image.rgba.data()), image.width, image.height, image.width * 4,
                  QImage::Format_RGBA8888)
               .copy();
  update();
}

/// A letter on a ground of its own: tissue lies under it.
void SectionView::draw_side(QPainter& p, const QString& side, Qt::Alignment where) const {
  if (side.isEmpty()) return;
  const QSizeF size(p.fontMetrics().horizontalAdvance(side) + px(8), p.fontMetrics().height() + px(2));
  const double x = where == Qt::AlignLeft ? px(4) : width() - px(4) - size.width();
  const QRectF ground(QPointF(x, height() - px(4) - size.height()), size);
  p.setPen(Qt::NoPen);
  p.setBrush(tokens().surface);
  p.drawRoundedRect(ground, px(3), px(3));
  p.setPen(tokens().text);
  p.drawText(ground, Qt::AlignCenter, side);
}

void SectionView::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath clip;
  clip.addRoundedRect(box, px(4), px(4));
  QRadialGradient back(box.center(), box.width() * 0.7);
  back.setColorAt(0, t.view_middle);
  back.setColorAt(1, t.view_edge);
  p.fillPath(clip, back);
  p.setClipPath(clip);
  if (!image_.isNull()) {
    QSizeF size = image_.size();
    size.scale(box.size(), Qt::KeepAspectRatioByExpanding);
    p.drawImage(QRectF(box.center() - QPointF(size.width(), size.height()) / 2, size), image_);
  }
  p.setFont(font_of(TextRole::caption, Weight::bold));
  p.setLayoutDirection(Qt::LeftToRight);  // the sides are the tooth's
  draw_side(p, left_, Qt::AlignLeft);
  draw_side(p, right_, Qt::AlignRight);
  p.setClipping(false);
  p.setPen(QPen(t.line, 1));
  p.setBrush(Qt::NoBrush);
  p.drawPath(clip);
}

}  // namespace cusp::ui
