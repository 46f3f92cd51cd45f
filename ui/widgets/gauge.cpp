#include "ui/widgets/gauge.h"

#include <QAccessibleWidget>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kDecimals = 2;   // of a gauge's number
constexpr int kWhole = 10000;  // steps of a Bar: finer than a pixel of any screen

/// What theme.qss calls the role.
const char* kind_of(Bar::Role role) {
  switch (role) {
    case Bar::Role::accent: return "bar_accent";
    case Bar::Role::target: return "bar_target";
    case Bar::Role::good: return "bar_good";
    case Bar::Role::look: return "bar_look";
    case Bar::Role::bad: return "bar_bad";
    case Bar::Role::enamel: return "bar_enamel";
    case Bar::Role::dentine: return "bar_dentine";
    case Bar::Role::carious: return "bar_carious";
    case Bar::Role::pulp: return "bar_pulp";
    case Bar::Role::plain: return "bar_plain";
  }
  return "bar_accent";
}

/// Name, value, least and most for a screen reader.
class AccessibleGauge : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit AccessibleGauge(Gauge* gauge) : QAccessibleWidget(gauge, QAccessible::Dial), gauge_(gauge) {}
  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  QString text(QAccessible::Text which) const override {
    if (which == QAccessible::Name) return gauge_->title();
    if (which == QAccessible::Value) return gauge_->value_text();
    return QAccessibleWidget::text(which);
  }
  QVariant currentValue() const override { return gauge_->value() ? QVariant(*gauge_->value()) : QVariant(); }
  void setCurrentValue(const QVariant&) override {}
  QVariant maximumValue() const override { return gauge_->most(); }
  QVariant minimumValue() const override { return gauge_->least(); }
  QVariant minimumStepSize() const override { return 0.01; }

 private:
  Gauge* gauge_;
};

/// Qt's own reads the bare number; this one reads it with its unit.
class AccessibleBar : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit AccessibleBar(Bar* bar) : QAccessibleWidget(bar, QAccessible::ProgressBar), bar_(bar) {}
  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  QString text(QAccessible::Text which) const override {
    if (which == QAccessible::Value) return bar_->format();
    return QAccessibleWidget::text(which);
  }
  QVariant currentValue() const override { return bar_->share(); }
  void setCurrentValue(const QVariant&) override {}
  QVariant maximumValue() const override { return 1.0; }
  QVariant minimumValue() const override { return 0.0; }
  QVariant minimumStepSize() const override { return 0.01; }

 private:
  Bar* bar_;
};

QAccessibleInterface* accessible_for(const QString&, QObject* object) {
  if (auto* gauge = qobject_cast<Gauge*>(object)) return new AccessibleGauge(gauge);
  if (auto* bar = qobject_cast<Bar*>(object)) return new AccessibleBar(bar);
  return nullptr;
}

void install_accessibility() {
  static const bool once = [] {
    QAccessible::installFactory(accessible_for);
    return true;
  }();
  Q_UNUSED(once);
}

}  // namespace

Gauge::Gauge(const QString& title, const QString& unit, Grows grows, QWidget* parent)
    : QWidget(parent), title_(title), unit_(unit), grows_(grows) {
  install_accessibility();
  setAccessibleName(title);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

void Gauge::set_scale(const Scale& scale) {
  scale_ = scale;
  scale_.most = std::max(scale.most, scale.least + 1e-6);
  scale_.major_step = std::max(scale.major_step, 1e-6);
  scale_.minor_per_major = std::max(scale.minor_per_major, 1);
  update();
}
void Gauge::set_scale_side(ScaleSide side) {
  side_ = side;
  update();
}
void Gauge::set_band(std::optional<double> lo, std::optional<double> hi) {
  band_lo_ = lo;
  band_hi_ = hi;
  update();
}
void Gauge::set_limit(std::optional<double> limit) {
  limit_ = limit;
  update();
}
void Gauge::set_value(std::optional<double> value) {
  if (value && !std::isfinite(*value)) value = std::nullopt;
  // A change below a fifth of the last digit costs no repaint.
  if (value && value_ && std::abs(*value - *value_) < 0.2 * std::pow(10.0, -kDecimals)) return;
  if (value == value_) return;
  value_ = value;
  update();
}

QString Gauge::value_text() const {
  if (!value_) return QStringLiteral("–");
  return format({*value_, std::nullopt, unit_, kDecimals});
}

QSize Gauge::sizeHint() const { return {px(104), px(420)}; }
QSize Gauge::minimumSizeHint() const { return {px(96), px(176)}; }

double Gauge::y_of(double value, const QRectF& bar) const {
  const double share = std::clamp((value - scale_.least) / (scale_.most - scale_.least), 0.0, 1.0);
  return grows_ == Grows::down ? bar.top() + share * bar.height() : bar.bottom() - share * bar.height();
}

void Gauge::paintEvent(QPaintEvent*) {
  const Tokens& t = tokens();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setLayoutDirection(Qt::LeftToRight);  // scales are not mirrored
  p.setPen(QPen(t.line, 1));
  p.setBrush(t.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), px(8), px(8));
  paint_head(p, t);
  const double bar_width = px(15);
  const double bar_x = side_ == ScaleSide::left ? width() - px(38) - bar_width + px(1) : px(36);
  const QRectF bar(bar_x, px(64), bar_width, height() - px(64) - px(22));
  paint_track(p, bar, t);
  paint_scale(p, bar, t);
  if (value_) paint_value(p, bar, t);
}

/// Title, number and unit.
void Gauge::paint_head(QPainter& p, const Tokens& t) const {
  const double margin = px(12);
  p.setPen(t.text2);
  p.setFont(font_of(TextRole::caption));
  p.drawText(QRectF(margin, px(8), width() - 2 * margin, px(16)), Qt::AlignLeft | Qt::AlignVCenter, title_);
  p.setPen(t.text);
  p.setFont(font_of(TextRole::live, Weight::bold));
  const QString number = value_ ? format_number(*value_, kDecimals) : QStringLiteral("–");
  const QRectF line(margin, px(24), width() - 2 * margin, px(26));
  const QFontMetricsF live(p.font());
  p.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, number);
  // The number keeps its width: the unit stands where the widest number would end.
  const QString widest = format_number(std::max(std::abs(scale_.least), std::abs(scale_.most)), kDecimals);
  const double unit_x = margin + std::max(live.horizontalAdvance(widest), live.horizontalAdvance(number)) + px(5);
  p.setFont(font_of(TextRole::body));
  p.setPen(t.text2);
  p.drawText(QRectF(unit_x, line.top() + px(2), width() - unit_x, line.height()), Qt::AlignLeft | Qt::AlignVCenter,
             unit_text(unit_));
}

/// The empty bar, the wanted band and the limit.
void Gauge::paint_track(QPainter& p, const QRectF& bar, const Tokens& t) const {
  p.setPen(QPen(t.border, 1));
  p.setBrush(t.sunken);
  p.drawRoundedRect(bar, px(2), px(2));
  if (band_lo_ && band_hi_) {
    const double y0 = y_of(*band_lo_, bar), y1 = y_of(*band_hi_, bar);
    QColor soft = t.line_target;
    soft.setAlphaF(0.28);
    p.fillRect(QRectF(QPointF(bar.left() + 1, std::min(y0, y1)), QPointF(bar.right() - 1, std::max(y0, y1))), soft);
    p.setPen(QPen(t.line_target, px(2)));
    for (const double y : {y0, y1}) p.drawLine(QPointF(bar.left(), y), QPointF(bar.right(), y));
  }
  if (limit_ && *limit_ > scale_.least && *limit_ <= scale_.most) {
    const double y = y_of(*limit_, bar);
    QPen dashed(t.line_leeway, px(2), Qt::CustomDashLine);
    dashed.setDashPattern({2, 1});
    p.setPen(dashed);
    p.drawLine(QPointF(bar.left(), y), QPointF(bar.right(), y));
  }
}

/// Ticks and their figures, beside the bar.
void Gauge::paint_scale(QPainter& p, const QRectF& bar, const Tokens& t) const {
  p.setFont(font_of(TextRole::caption));
  const int majors = static_cast<int>(std::floor((scale_.most - scale_.least) / scale_.major_step + 1e-9));
  const int label_decimals = scale_.major_step < 0.1 ? 2 : scale_.major_step < 1 ? 1 : (scale_.most - scale_.least) <= 5 ? 1 : 0;
  for (int i = 0; i <= majors; ++i) {
    const double value = scale_.least + i * scale_.major_step;
    const double y = y_of(value, bar);
    p.setPen(QPen(t.border, 1));
    const double long_tick = px(14), short_tick = px(8), gap = px(2);
    if (side_ == ScaleSide::left) {
      p.drawLine(QPointF(bar.left() - gap - long_tick, y), QPointF(bar.left() - gap, y));
    } else {
      p.drawLine(QPointF(bar.right() + gap, y), QPointF(bar.right() + gap + long_tick / 2, y));
    }
    p.setPen(t.text2);
    const QString text = format_number(value, label_decimals);
    if (side_ == ScaleSide::left) {
      p.drawText(QRectF(px(4), y - px(8), bar.left() - gap - long_tick - px(8), px(16)),
                 Qt::AlignRight | Qt::AlignVCenter, text);
    } else {
      p.drawText(QRectF(bar.right() + gap + long_tick / 2 + px(5), y - px(8), px(40), px(16)),
                 Qt::AlignLeft | Qt::AlignVCenter, text);
    }
    if (i == majors || side_ == ScaleSide::right) continue;
    p.setPen(QPen(t.border, 1));
    for (int j = 1; j < scale_.minor_per_major; ++j) {
      const double ym = y_of(value + j * scale_.major_step / scale_.minor_per_major, bar);
      p.drawLine(QPointF(bar.left() - gap - short_tick, ym), QPointF(bar.left() - gap, ym));
    }
  }
}

/// The bar filled from zero to the value, and the marker beside it.
void Gauge::paint_value(QPainter& p, const QRectF& bar, const Tokens& t) const {
  const double y = y_of(*value_, bar);
  const double zero = y_of(std::clamp(0.0, scale_.least, scale_.most), bar);
  const double inset = grows_ == Grows::down ? 1.0 : px(4);
  QColor fill = grows_ == Grows::down ? t.text3 : t.text;
  if (grows_ == Grows::down) fill.setAlphaF(0.35);
  p.fillRect(QRectF(QPointF(bar.left() + inset, std::min(y, zero)), QPointF(bar.right() - inset, std::max(y, zero))),
             fill);
  QPainterPath marker;
  if (side_ == ScaleSide::left) {
    const double x = bar.right() + px(2);
    marker.moveTo(x, y);
    marker.lineTo(x + px(8), y - px(6));
    marker.lineTo(x + px(8), y + px(6));
  } else {
    const double x = bar.left() - px(2);
    marker.moveTo(x, y);
    marker.lineTo(x - px(8), y - px(6));
    marker.lineTo(x - px(8), y + px(6));
  }
  marker.closeSubpath();
  p.fillPath(marker, t.text);
}

void Gauge::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) update();
  QWidget::changeEvent(event);
}

QColor colour_of(Bar::Role role) {
  const Tokens& t = tokens();
  switch (role) {
    case Bar::Role::accent: return t.accent;
    case Bar::Role::target: return t.line_target;
    case Bar::Role::good: return t.good;
    case Bar::Role::look: return t.look;
    case Bar::Role::bad: return t.bad;
    case Bar::Role::enamel: return t.bar_enamel;
    case Bar::Role::dentine: return t.bar_dentine;
    case Bar::Role::carious: return t.bar_carious;
    case Bar::Role::pulp: return t.bar_pulp;
    case Bar::Role::plain: return t.text2;
  }
  return t.accent;
}

void paint_bar(QPainter& painter, const QRectF& rect, double share, const QColor& fill, const QColor& track) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const double radius = rect.height() / 2;
  painter.setBrush(track);
  painter.drawRoundedRect(rect, radius, radius);
  share = std::clamp(share, 0.0, 1.0);
  if (share > 0) {
    const double width = std::max(share * rect.width(), rect.height());
    const bool rtl = painter.layoutDirection() == Qt::RightToLeft;
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(rtl ? rect.right() - width : rect.left(), rect.top(), width, rect.height()), radius,
                            radius);
  }
  painter.restore();
}

Bar::Bar(Role role, QWidget* parent) : QProgressBar(parent), role_(role) {
  install_accessibility();
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setTextVisible(false);
  setRange(0, kWhole);
  setValue(0);
  setFormat({});
  setProperty("kind", QString::fromLatin1(kind_of(role)));
}
void Bar::set_role(Role role) {
  if (role == role_) return;
  role_ = role;
  set_kind(this, kind_of(role));
}
void Bar::set_share(double share, const QString& spoken) {
  setValue(std::isfinite(share) ? static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kWhole)) : 0);
  setFormat(spoken);
}
double Bar::share() const { return static_cast<double>(value()) / kWhole; }
QSize Bar::sizeHint() const { return {px(80), px(6)}; }

}  // namespace cusp::ui
