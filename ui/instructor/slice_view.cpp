#include "ui/instructor/slice_view.h"

#include <QBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <algorithm>
#include <array>

#include "ui/render/colours.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kPictureEdge = 260;
constexpr double kTint = 0.62;       // share of the tissue's colour; the rest shows the grey below
constexpr double kOutliers = 0.005;  // share of the values beyond black and beyond white

/// Axes of the volume that run to the right and upward on a slice.
struct Plane {
  int right, up;
};
constexpr std::array<Plane, 3> kPlanes = {{{1, 2}, {0, 2}, {0, 1}}};

QColor colour_of(Tissue tissue) {
  const Colour c = tissue_colours()[index_of(tissue) % kTissueCodes];
  return QColor::fromRgbF(c.r, c.g, c.b);
}

}  // namespace

class SliceView::Pane : public QWidget {
 public:
  explicit Pane(SliceView* view) : QWidget(view), view_(view) { setFixedSize(px(kPictureEdge), px(kPictureEdge)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.fillRect(rect(), tokens().view_edge);
    if (!view_->preview_) return;
    const Plane plane = kPlanes[static_cast<std::size_t>(view_->axis())];
    const ImagePreview& v = *view_->preview_;
    const double wide = v.size[plane.right] * v.spacing_mm[plane.right], high = v.size[plane.up] * v.spacing_mm[plane.up];
    const double scale = std::min(width() / wide, height() / high);
    const QRectF to((width() - wide * scale) / 2, (height() - high * scale) / 2, wide * scale, high * scale);
    p.drawImage(to, view_->picture());
  }

 private:
  SliceView* view_;
};

SliceView::SliceView(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  pane_ = new Pane(this);
  column->addWidget(pane_, 0, Qt::AlignHCenter);
  axes_ = new Segments({tr("From the side"), tr("From the front"), tr("From above")});
  axes_->choose(2);
  column->addWidget(axes_, 0, Qt::AlignHCenter);
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setAccessibleName(tr("Slice"));
  column->addWidget(slider_);
  where_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  where_->setAlignment(Qt::AlignHCenter);
  column->addWidget(where_);
  connect(axes_, &Segments::changed, this, &SliceView::change_axis);
  connect(slider_, &QSlider::valueChanged, this, &SliceView::redraw);
}

int SliceView::axis() const { return axes_->chosen(); }
int SliceView::slice() const { return slider_->value(); }

void SliceView::show_preview(std::shared_ptr<const ImagePreview> preview, ImageKind kind, IVec3 size) {
  preview_ = std::move(preview);
  size_ = size;
  kind_ = kind;
  if (preview_ && !preview_->value.empty()) {
    std::vector<float> sorted = preview_->value;
    const auto at = [&](double share) {
      const auto n = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
      std::ranges::nth_element(sorted, n);
      return *n;
    };
    low_ = at(kOutliers);
    high_ = at(1.0 - kOutliers);
    if (!(high_ > low_)) high_ = low_ + 1.0f;
  }
  change_axis();
}

void SliceView::set_tissues(std::function<Tissue(float)> tissue_of) {
  tissue_of_ = std::move(tissue_of);
  redraw();
}

void SliceView::change_axis() {
  if (!preview_) return;
  const int slices = preview_->size[axis()];
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, slices - 1);
  slider_->setValue(slices / 2);
  redraw();
}

void SliceView::redraw() {
  if (!preview_) return;
  const int slices = size_[axis()], each = (slices + kPreviewEdge - 1) / kPreviewEdge;
  where_->setText(tr("Slice %1 of %2").arg(slice() * each + 1).arg(slices));
  pane_->update();
}

QImage SliceView::picture() const {
  if (!preview_) return {};
  const ImagePreview& v = *preview_;
  const Plane plane = kPlanes[static_cast<std::size_t>(axis())];
  QImage out(v.size[plane.right], v.size[plane.up], QImage::Format_RGB32);
  IVec3 at(0);
  at[axis()] = std::clamp(slice(), 0, v.size[axis()] - 1);
  for (int y = 0; y < out.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(out.scanLine(y));
    at[plane.up] = out.height() - 1 - y;
    for (int x = 0; x < out.width(); ++x) {
      at[plane.right] = x;
      const float value = v.value[static_cast<std::size_t>(at.x) +
                                  static_cast<std::size_t>(v.size.x) *
                                      (static_cast<std::size_t>(at.y) + static_cast<std::size_t>(v.size.y) * static_cast<std::size_t>(at.z))];
      const int grey = std::clamp(static_cast<int>(255.0f * (value - low_) / (high_ - low_)), 0, 255);
      QColor ink = kind_ == ImageKind::colours ? QColor::fromRgb(static_cast<QRgb>(value)) : QColor(grey, grey, grey);
      const Tissue tissue = tissue_of_ ? tissue_of_(value) : Tissue::empty;
      if (tissue != Tissue::empty) {
        const QColor tint = colour_of(tissue);
        const auto mix = [](int a, int b) { return static_cast<int>(kTint * a + (1.0 - kTint) * b); };
        ink = QColor(mix(tint.red(), ink.red()), mix(tint.green(), ink.green()), mix(tint.blue(), ink.blue()));
      }
      line[x] = ink.rgb();
    }
  }
  return out;
}

}  // namespace cusp::ui
