#include "ui/editor/band_picture.h"

#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/grading/bands.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

// px at 100 %.
constexpr int kPlotSide = 12, kPlotHeight = 56, kFiguresHeight = 22, kPlotTop = 10, kMarkRow = 14;
constexpr int kEdgeKnob = 10, kWholeEdgeKnob = 18;  // a handle, and what the theme rings at focus
constexpr double kMouseReach = 12;               // within which the mouse takes an edge
constexpr double kSoftOpacity = 0.14;              // opacity of what a measured value may be

struct BandText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::BandPicture)
};

/// A handle for screen readers: a slider with the edge's value.
class EdgeForReaders : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit EdgeForReaders(BandKnob* knob) : QAccessibleWidget(knob, QAccessible::Slider), knob_(*knob) {}
  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  QString text(QAccessible::Text what) const override {
    return what == QAccessible::Value ? knob_.picture().value_text(knob_.value()) : QAccessibleWidget::text(what);
  }
  QVariant currentValue() const override { return knob_.value(); }
  void setCurrentValue(const QVariant& value) override {
    knob_.picture().move_edge(knob_.edge(), value.toDouble(), minimumStepSize().toDouble());
    knob_.picture().end_gesture();
  }
  QVariant maximumValue() const override { return knob_.picture().scale().limits(knob_.edge()).most; }
  QVariant minimumValue() const override { return knob_.picture().scale().limits(knob_.edge()).least; }
  QVariant minimumStepSize() const override { return knob_.picture().step() * kFineBandStep; }

 private:
  BandKnob& knob_;
};

QAccessibleInterface* edge_for_readers(const QString&, QObject* object) {
  auto* knob = qobject_cast<BandKnob*>(object);
  return knob ? new EdgeForReaders(knob) : nullptr;
}

QColor softened(QColor colour) {
  colour.setAlphaF(kSoftOpacity);
  return colour;
}

}  // namespace

QString band_edge_name(std::size_t edge) {
  switch (edge) {
    case 0: return BandText::tr("No points below");
    case 1: return BandText::tr("Half from");
    case 2: return BandText::tr("Full from");
    case 3: return BandText::tr("Full to");
    case 4: return BandText::tr("Half to");
    default: return BandText::tr("No points above");
  }
}

void paint_band_mark(QPainter& p, QPointF middle, TriedBy by) {
  const double half = px(4.5);
  p.setPen(Qt::NoPen);
  p.setBrush(by == TriedBy::author ? tokens().accent : tokens().text);
  QPainterPath path;
  switch (by) {
    case TriedBy::author: path.addEllipse(middle, half, half); break;
    case TriedBy::reference:
      path.addPolygon(QPolygonF{{middle + QPointF(0, -half), middle + QPointF(half, 0), middle + QPointF(0, half), middle + QPointF(-half, 0)}});
      break;
    case TriedBy::competent:
      path.addPolygon(QPolygonF{{middle + QPointF(-half, half * 0.8), middle + QPointF(half, half * 0.8), middle + QPointF(0, -half)}});
      break;
    case TriedBy::novice: path.addRect(QRectF(middle - QPointF(half, half) * 0.8, middle + QPointF(half, half) * 0.8)); break;
  }
  path.closeSubpath();
  p.drawPath(path);
}

BandPicture::BandPicture(Criterion criterion, std::function<bool(const Bands&)> take, std::function<void()> end, QWidget* parent)
    : QWidget(parent),
      criterion_(std::move(criterion)),
      step_(band_step(criterion_.unit.toStdString())),
      take_(std::move(take)),
      end_(std::move(end)),
      scale_({}, criterion_.possible, step_) {
  setAccessibleName(BandText::tr("Bands of %1 as a picture").arg(criterion_.name));
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  for (std::size_t edge = 0; edge < knobs_.size(); ++edge) {
    knobs_[edge] = new BandKnob(*this, edge);
    knobs_[edge]->setAccessibleName(criterion_.name + u": "_qs + band_edge_name(edge));
  }
}

QSize BandPicture::sizeHint() const {
  const int rows = static_cast<int>(marks_.size()) * px(kMarkRow);
  return {px(240), px(kPlotTop) + rows + px(kPlotHeight) + px(kFiguresHeight)};
}

BandPlot BandPicture::plot() const {
  return {static_cast<double>(px(kPlotSide)), static_cast<double>(height() - px(kFiguresHeight) - px(kPlotHeight)),
          std::max(1.0, static_cast<double>(width() - 2 * px(kPlotSide))), static_cast<double>(px(kPlotHeight))};
}

QString BandPicture::value_text(double value) const { return format({value, std::nullopt, criterion_.unit, 2}); }

void BandPicture::show_bands(const Bands& bands) {
  if (dragged_) {
    scale_ = scale_.holding(bands);
  } else {
    scale_ = BandScale(bands, criterion_.possible, step_);
    fit_scale();
  }
  place_knobs();
  update();
}

void BandPicture::set_marks(std::vector<BandMark> marks) {
  marks_ = std::move(marks);
  fit_scale();
  updateGeometry();
  place_knobs();
  update();
}

void BandPicture::fit_scale() {
  std::vector<double> values;
  for (const BandMark& mark : marks_) values.push_back(mark.value);
  scale_ = BandScale(scale_.bands(), criterion_.possible, step_, values);
}

void BandPicture::place_knobs() {
  const BandPlot at = plot();
  for (BandKnob* knob : knobs_) {
    const BandSpot spot = scale_.spot_of(knob->edge(), at);
    knob->move(qRound(spot.x) - knob->width() / 2, qRound(spot.y) - knob->height() / 2);
    knob->setVisible(scale_.movable(knob->edge()) || (dragged_ && *dragged_ == knob->edge()));
    knob->follow();
  }
}

void BandPicture::move_edge(std::size_t edge, double wanted, double step) {
  const Bands after = scale_.moved(edge, wanted, step);
  if (!(after == scale_.bands())) static_cast<void>(take_(after));  // a refusal leaves the picture as it is
}

void BandPicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_knobs();
}

std::optional<std::size_t> BandPicture::edge_under(QPointF at) const { return scale_.edge_at({at.x(), at.y()}, plot(), px(kMouseReach)); }

void BandPicture::mousePressEvent(QMouseEvent* event) {
  const auto edge = event->button() == Qt::LeftButton ? edge_under(event->position()) : std::nullopt;
  if (!edge) return event->ignore();
  end_();
  dragged_ = edge;
  grip_px_ = event->position().x() - scale_.spot_of(*edge, plot()).x;
  knobs_[*edge]->setFocus(Qt::MouseFocusReason);
}

void BandPicture::mouseMoveEvent(QMouseEvent* event) {
  if (!dragged_) {
    const auto edge = edge_under(event->position());
    setCursor(edge ? Qt::SizeHorCursor : Qt::ArrowCursor);
    setToolTip(edge ? band_edge_name(*edge) + u": "_qs + value_text(knobs_[*edge]->value()) : QString());
    return;
  }
  const bool fine = event->modifiers() & Qt::ShiftModifier;
  move_edge(*dragged_, scale_.value_at(event->position().x() - grip_px_, plot()), fine ? step_ * kFineBandStep : step_);
}

void BandPicture::mouseReleaseEvent(QMouseEvent*) {
  if (!dragged_) return;
  dragged_.reset();
  end_();
  show_bands(scale_.bands());  // the scale follows now
}

void BandPicture::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setLayoutDirection(Qt::LeftToRight);  // a chart's x is not mirrored
  const BandPlot at = plot();
  paint_shares(p, at);
  paint_figures(p, at);
  paint_marks(p, at);
}

/// The share of the points over the value: a plateau, its flanks, and a line where there are none.
void BandPicture::paint_shares(QPainter& p, const BandPlot& at) const {
  const Tokens& t = tokens();
  const BandRange shown = scale_.shown();
  const Bands& b = scale_.bands();
  const double foot = at.top + at.height;
  const auto y_of = [&](double value) { return at.top + (1 - share_of_points(b, value)) * at.height; };
  p.fillRect(QRectF(at.left, at.top, at.width, at.height), t.surface);
  QPolygonF line{QPointF(at.left, y_of(shown.least))};
  for (std::size_t edge = 0; edge < kBandEdges.size(); ++edge) {
    const double value = b.*kBandEdges[edge];
    if (value < shown.least || value > shown.most) continue;
    const BandSpot spot = scale_.spot_of(edge, at);
    line << QPointF(spot.x, spot.y);
  }
  line << QPointF(at.left + at.width, y_of(shown.most));
  QPolygonF area = line;
  area << QPointF(at.left + at.width, foot) << QPointF(at.left, foot);
  p.setPen(Qt::NoPen);
  p.setBrush(t.look_soft);
  p.drawPolygon(area);
  const QRectF full(QPointF(scale_.x_of(b.ideal_lo, at), at.top), QPointF(scale_.x_of(b.ideal_hi, at), foot));
  p.fillRect(full, t.good_soft);
  QPen dashed(t.line, 1, Qt::DashLine);
  p.setPen(dashed);
  p.drawLine(QPointF(at.left, at.top + at.height / 2), QPointF(at.left + at.width, at.top + at.height / 2));
  p.setPen(QPen(t.text, px(2)));
  p.drawPolyline(line);
  p.setFont(font_of(TextRole::caption));
  p.setPen(t.good);
  if (full.width() > p.fontMetrics().horizontalAdvance(BandText::tr("full")) + px(8)) p.drawText(full, Qt::AlignCenter, BandText::tr("full"));
}

void BandPicture::paint_figures(QPainter& p, const BandPlot& at) const {
  const Tokens& t = tokens();
  const double foot = at.top + at.height;
  const std::vector<double> ticks = scale_.ticks();
  const double apart = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
  const int decimals = apart < 0.095 ? 2 : apart < 0.95 ? 1 : 0;
  p.setPen(QPen(t.border, 1));
  p.drawLine(QPointF(at.left, foot), QPointF(at.left + at.width, foot));
  p.setFont(font_of(TextRole::caption));
  const QString unit = unit_text(criterion_.unit);
  const double unit_width = p.fontMetrics().horizontalAdvance(unit) + px(4);
  p.setPen(t.text2);
  p.drawText(QRectF(0, foot + px(4), width() - 1, px(kFiguresHeight) - px(4)), Qt::AlignRight | Qt::AlignVCenter, unit);
  double free_from = -1e9;
  for (const double value : ticks) {
    const double x = scale_.x_of(value, at);
    p.setPen(QPen(t.border, 1));
    p.drawLine(QPointF(x, foot), QPointF(x, foot + px(4)));
    const QString text = format_number(value, decimals);
    const double wide = p.fontMetrics().horizontalAdvance(text), from = x - wide / 2;
    if (from < free_from || from + wide > width() - unit_width) continue;
    free_from = from + wide + px(8);
    p.setPen(t.text2);
    p.drawText(QRectF(from, foot + px(4), wide + 1, px(kFiguresHeight) - px(4)), Qt::AlignCenter, text);
  }
}

/// One row for each, so that equal values stand apart; a value off the scale has an arrow at its end.
void BandPicture::paint_marks(QPainter& p, const BandPlot& at) const {
  const Tokens& t = tokens();
  const BandRange shown = scale_.shown();
  double y = at.top - px(kMarkRow) * static_cast<double>(marks_.size()) - px(kEdgeKnob) / 2.0 + px(kMarkRow) / 2.0;
  for (const BandMark& mark : marks_) {
    const QColor ink = mark.by == TriedBy::author ? t.accent : t.text;
    const double x = scale_.x_of(mark.value, at);
    const bool off = mark.value < shown.least || mark.value > shown.most;
    if (!off && mark.uncertainty > 0) {
      const double from = scale_.x_of(mark.value - mark.uncertainty, at), to = scale_.x_of(mark.value + mark.uncertainty, at);
      p.fillRect(QRectF(QPointF(from, y), QPointF(to, at.top + at.height)), softened(ink));
    }
    if (off) {
      const double way = mark.value < shown.least ? -1 : 1;
      p.setPen(QPen(ink, px(2)));
      const QPointF tip(x + way * px(9), y);
      p.drawLine(QPointF(x, y), tip);
      p.drawLine(tip, tip - QPointF(way * px(4), px(4)));
      p.drawLine(tip, tip - QPointF(way * px(4), -px(4)));
    } else {
      p.setPen(QPen(ink, 1));
      p.drawLine(QPointF(x, y), QPointF(x, at.top + (1 - share_of_points(scale_.bands(), mark.value)) * at.height));
    }
    paint_band_mark(p, {x, y}, mark.by);
    y += px(kMarkRow);
  }
}

BandKnob::BandKnob(BandPicture& picture, std::size_t edge) : QWidget(&picture), picture_(picture), edge_(edge) {
  [[maybe_unused]] static const bool once = (QAccessible::installFactory(edge_for_readers), true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedSize(px(kWholeEdgeKnob), px(kWholeEdgeKnob));
}

void BandKnob::follow() {
  const QString text = picture_.value_text(value());
  if (text == accessibleDescription()) return;
  setAccessibleDescription(text);
  QAccessibleValueChangeEvent changed(this, value());
  QAccessible::updateAccessibility(&changed);
  update();
}

void BandKnob::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Tokens& t = tokens();
  const double edge = (px(kWholeEdgeKnob) - px(kEdgeKnob)) / 2.0;
  const QRectF body = QRectF(rect()).adjusted(edge, edge, -edge, -edge);
  p.setPen(QPen(t.text, px(2)));
  p.setBrush(t.surface);
  p.drawEllipse(body);
}

void BandKnob::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const int way = key == Qt::Key_Right || key == Qt::Key_Up ? 1 : key == Qt::Key_Left || key == Qt::Key_Down ? -1 : 0;
  if (way == 0) return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier ? picture_.step() * kFineBandStep : picture_.step();
  if (!event->isAutoRepeat()) picture_.end_gesture();
  picture_.move_edge(edge_, value() + way * step, step);
}

void BandKnob::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  picture_.end_gesture();
}

}  // namespace cusp::ui
