#include "ui/device/homing_view.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/text/falcon_text.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kWide = 300, kHigh = 150;  // px at 100 %
constexpr double kInnermostM = 0.075, kOutermostM = 0.175;
constexpr double kTicksOfTravel = 2500.0;  // of an arm from inner to outer stop, rounded up

}  // namespace

class HomingView::Picture : public QWidget {
 public:
  using QWidget::QWidget;
  FalconView view;

 protected:
  QSize sizeHint() const override { return {px(kWide), px(kHigh)}; }
  QSize minimumSizeHint() const override { return sizeHint(); }
  void paintEvent(QPaintEvent*) override {
    const Tokens& t = tokens();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const double s = px(100) / 100.0;
    p.translate((width() - kWide * s) / 2, 0);
    p.scale(s, s);
    const bool ready = view.session.phase == falcon::Phase::ready;
    const std::uint8_t homed = view.session.homed;
    // Left: from the front. Arm 1 above, 2 right, 3 left.
    const QPointF middle(75, 75);
    p.setPen(QPen(t.border, 1.5));
    p.setBrush(t.sunken);
    p.drawEllipse(middle, 66, 66);
    for (int arm = 0; arm < 3; ++arm) {
      const double angle = (-90.0 + 120.0 * arm) * 3.14159265358979 / 180.0;
      const QPointF out(std::cos(angle), std::sin(angle));
      const bool done = (homed & (falcon::status::kHomed1 << arm)) != 0;
      p.setPen(QPen(done ? t.good : t.border, done ? 9 : 5, Qt::SolidLine, Qt::RoundCap));
      p.drawLine(middle + out * 22, middle + out * 58);
      p.setPen(QPen(done ? t.good : t.text2, 1.5));
      p.setBrush(done ? t.good : t.surface);
      p.drawEllipse(middle + out * 58, 9, 9);
      if (done) {
        p.setPen(QPen(t.surface, 2, Qt::SolidLine, Qt::RoundCap));
        const QPointF c = middle + out * 58;
        p.drawPolyline(QPolygonF({c + QPointF(-4, 0), c + QPointF(-1, 3), c + QPointF(4, -3)}));
      }
    }
    p.setPen(QPen(t.text2, 1.5));
    p.setBrush(ready ? t.accent : t.surface);
    p.drawEllipse(middle, 16, 16);
    // Right: from the side. The grip goes out to the user and back.
    p.setPen(QPen(t.border, 1.5));
    p.setBrush(t.sunken);
    p.drawRoundedRect(QRectF(165, 30, 26, 90), 6, 6);
    const double out = 200 + 70 * travel();
    p.setPen(QPen(t.text2, 4, Qt::SolidLine, Qt::RoundCap));
    p.drawLine(QPointF(191, 45), QPointF(out, 75));
    p.drawLine(QPointF(191, 105), QPointF(out, 75));
    p.setBrush(ready ? t.accent : t.surface);
    p.setPen(QPen(t.text2, 1.5));
    p.drawEllipse(QPointF(out, 75), 12, 12);
    if (!ready) {
      p.setPen(QPen(t.accent, 2.5, Qt::SolidLine, Qt::RoundCap));
      p.drawLine(QPointF(212, 132), QPointF(276, 132));
      for (const double end : {212.0, 276.0}) {
        const double way = end < 240 ? 7.0 : -7.0;
        p.drawPolyline(QPolygonF({QPointF(end + way, 126), QPointF(end, 132), QPointF(end + way, 138)}));
      }
    }
  }

 private:
  /// How far out the grip is, 0 to 1. Before homing only the arms' counts are known, from wherever they began.
  double travel() const {
    if (view.session.phase == falcon::Phase::ready)
      return std::clamp((view.grip_m.z - kInnermostM) / (kOutermostM - kInnermostM), 0.0, 1.0);
    const auto& e = view.session.encoders;
    return std::clamp(0.5 + (e[0] + e[1] + e[2]) / 3.0 / kTicksOfTravel, 0.0, 1.0);
  }
};

HomingView::HomingView(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  picture_ = new Picture(this);
  column->addWidget(picture_, 0, Qt::AlignHCenter);
  phase_ = make_label({}, TextRole::section, Weight::bold);
  sentence_ = make_label({}, TextRole::body, Weight::regular, "text2");
  sentence_->setWordWrap(true);
  column->addWidget(phase_);
  column->addWidget(sentence_);
  show_falcon({});
}

void HomingView::show_falcon(const FalconView& view) {
  const falcon::Phase before = std::exchange(picture_->view, view).session.phase;
  picture_->update();
  const QString phase = phase_text(view.session), sentence = help_text(view.session);
  if (phase_->text() == phase && sentence_->text() == sentence) return;
  const bool loads = before == view.session.phase && sentence_->text() == sentence;  // only the share of an upload differs
  phase_->setText(phase);
  sentence_->setText(sentence);
  picture_->setAccessibleName(sentence.isEmpty() ? phase : sentence);
  if (!loads) announce(this, text().trimmed());
}

QString HomingView::text() const { return phase_->text() + u' ' + sentence_->text(); }

}  // namespace cusp::ui
