#include "ui/drill/cut_slider.h"

#include <QBoxLayout>
#include <QLabel>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kWidest = 420, kNamesFrom = 300;  // px at 100 %

}  // namespace

CutSlider::CutSlider(QWidget* parent) : QFrame(parent) {
  set_kind(this, "card");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(px(12), px(6), px(12), px(6));
  row->setSpacing(px(8));
  row->addWidget(far_ = make_label(tr("farther"), TextRole::caption, Weight::regular, "text2"));
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setAccessibleName(tr("Place of the cut"));
  slider_->setToolTip(tr("How far from the bur the tooth is cut"));
  const int steps = static_cast<int>(std::lround(kMostMm / kStepMm));
  slider_->setRange(-steps, steps);
  slider_->setPageStep(5);
  slider_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(slider_, 1);
  row->addWidget(near_ = make_label(tr("nearer"), TextRole::caption, Weight::regular, "text2"));
  place_ = make_label({}, TextRole::body, Weight::bold);
  place_->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  row->addWidget(place_);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    show_place();
    Q_EMIT moved();
  });
  show_place();
  // A value that changes keeps its width.
  const QFontMetrics metrics(font_of(TextRole::body, Weight::bold));
  for (const QString& text : {tr("at the bur"), place_->text(), format({-kMostMm, {}, QStringLiteral("mm"), 1})})
    place_->setMinimumWidth(std::max(place_->minimumWidth(), metrics.horizontalAdvance(text) + px(4)));
}

double CutSlider::nearer_mm() const { return slider_->value() * kStepMm; }

void CutSlider::centre() { slider_->setValue(0); }

void CutSlider::fit(int width_px) {
  const bool named = width_px >= px(kNamesFrom);
  far_->setVisible(named);
  near_->setVisible(named);
  resize(std::min(width_px, px(kWidest)), sizeHint().height());
}

void CutSlider::show_place() {
  place_->setText(slider_->value() == 0 ? tr("at the bur") : format({nearer_mm(), {}, QStringLiteral("mm"), 1}));
  slider_->setAccessibleDescription(place_->text());
}

}  // namespace cusp::ui
