#include "ui/instructor/size_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/text/import_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

// Of a lower first molar from buccal, as scenarios/teeth/teeth.json has it.
constexpr double kCrownWide = 11.0, kNeckWide = 9.0, kCrownHigh = 7.5, kRootHigh = 14.0;  // mm
constexpr double kMolarHigh = kCrownHigh + kRootHigh;
constexpr QSize kSize{300, 260};                    // px at 100 %
constexpr int kEdge = 12, kBetween = 32, kText = 20;  // likewise

/// Its outline, in millimetres; the origin lies below the middle of its roots, y grows downwards.
QPainterPath molar() {
  const double c = kCrownWide / 2, n = kNeckWide / 2, neck = -kRootHigh, top = -kMolarHigh;
  QPainterPath out(QPointF(-n, neck));
  out.cubicTo({-c - 0.4, neck - 2}, {-c, top + 1.8}, {-c + 0.7, top + 0.9});
  out.cubicTo({-c + 1.8, top - 0.3}, {-1.8, top - 0.3}, {-1.0, top + 0.9});   // mesiobuccal cusp, down to the buccal groove
  out.cubicTo({-0.4, top - 0.2}, {2.2, top - 0.2}, {2.6, top + 1.0});          // distobuccal cusp
  out.cubicTo({2.9, top + 0.3}, {c - 1.4, top + 0.3}, {c - 0.8, top + 1.4});   // distal cusp
  out.cubicTo({c, top + 2.2}, {c + 0.4, neck - 2}, {n, neck});
  out.cubicTo({n + 0.2, neck + 5}, {n - 0.5, -2}, {n - 1.6, 0});
  out.cubicTo({n - 2.8, -2}, {1.2, neck + 6}, {0, neck + 4});
  out.cubicTo({-1.2, neck + 6}, {-n + 2.8, -2}, {-n + 1.6, 0});
  out.cubicTo({-n + 0.5, -2}, {-n - 0.2, neck + 5}, {-n, neck});
  return out;
}

}  // namespace

SizePicture::SizePicture(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Size beside a molar"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void SizePicture::show_size(Vec3 size_mm) {
  size_mm_ = size_mm;
  setAccessibleDescription(tr("%1, beside a lower first molar of %2").arg(size_text(size_mm, u"mm"_qs), size_text({kCrownWide, kCrownWide, kMolarHigh}, u"mm"_qs, 0)));
  update();
}

QSize SizePicture::sizeHint() const { return {px(kSize.width()), px(kSize.height())}; }

double SizePicture::px_per_mm() const {
  const double wide = kCrownWide + std::max(size_mm_.x, 1e-3), high = std::max(kMolarHigh, size_mm_.z);
  return std::min((width() - 2.0 * px(kEdge) - px(kBetween)) / wide, (height() - 2.0 * px(kEdge) - px(kText)) / high);
}

void SizePicture::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(QRectF(rect()), px(4), px(4));
  p.fillPath(ground, t.sunken);
  const double scale = px_per_mm(), floor = height() - px(kEdge) - px(kText);
  const double wide = (kCrownWide + size_mm_.x) * scale + px(kBetween), left = (width() - wide) / 2;
  const double middle = left + kCrownWide * scale / 2;
  p.save();
  p.translate(middle, floor);
  p.scale(scale, scale);
  QPen outline(t.border, 1.5);
  outline.setCosmetic(true);
  p.setPen(outline);
  p.setBrush(t.surface);
  p.drawPath(molar());
  p.restore();
  const QRectF box(left + kCrownWide * scale + px(kBetween), floor - size_mm_.z * scale, size_mm_.x * scale, size_mm_.z * scale);
  p.setPen(QPen(t.accent, px(2.0)));
  p.setBrush(t.accent_soft);
  p.drawRect(box);
  p.setFont(font_of(TextRole::caption));
  p.setPen(t.text2);
  const auto below = [&](double x, const QString& text) {
    const double half = QFontMetricsF(p.font()).horizontalAdvance(text) / 2;
    const double at = std::clamp(x, half + px(4), std::max(half + px(4), width() - half - px(4)));
    p.drawText(QPointF(at - half, height() - px(kEdge)), text);
  };
  below(middle, tr("molar"));
  p.setPen(t.accent);
  below(box.center().x(), tr("your file"));
}

}  // namespace cusp::ui
