#include "ui/widgets/chart.h"

#include <QAction>
#include <QBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QToolTip>
#include <cmath>
#include <functional>
#include <vector>

#include "ui/widgets/format.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr double kBesideAxis = 10;  // px at 100 %, between the numbers of the y axis and the plot
constexpr double kTitlePast = 6;    // px at 100 %, of the x axis' title past the plot

/// Maps values onto the plot's area. The x axis runs to the right in every language.
struct Plot {
  QRectF area;
  const ChartData& data;
  double x(double v) const { return area.left() + (v - data.x.least) / (data.x.most - data.x.least) * area.width(); }
  double y(double v) const { return area.bottom() - (v - data.y.least) / (data.y.most - data.y.least) * area.height(); }
  QPointF at(const ChartPoint& p) const { return {x(p.x), y(p.y)}; }
};

QFont caption(double unit) {
  QFont font = font_of(TextRole::caption);
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(11.5 * unit))));
  return font;
}

Plot plot_of(const QRectF& rect, const ChartData& data, double unit) {
  const QFontMetricsF metrics(caption(unit));
  double labels = 0;
  for (double v = data.y.least; v <= data.y.most + 1e-9; v += data.y.step) {
    labels = std::max(labels, metrics.horizontalAdvance(format_number(v, data.y.decimals)));
  }
  // The right margin holds half of the last label and the end of the title, or the names at the lines' ends.
  double names = std::max(metrics.horizontalAdvance(format_number(data.x.most, data.x.decimals)) / 2 + 2 * unit, kTitlePast * unit);
  for (const auto& s : data.series) {
    if (s.draw == ChartSeries::Draw::line && !s.points.isEmpty()) {
      names = std::max(names, metrics.horizontalAdvance(s.name) + 10 * unit);
    }
  }
  const double below = data.x.title.isEmpty() ? 20 * unit : 34 * unit;
  return {rect.adjusted(std::ceil(labels) + kBesideAxis * unit, 8 * unit, -names, -below), data};
}

void paint_axes(QPainter& p, const Plot& plot, const Tokens& t, double unit) {
  const ChartData& d = plot.data;
  p.setFont(caption(unit));
  for (double v = d.y.least; v <= d.y.most + 1e-9; v += d.y.step) {
    const double y = std::round(plot.y(v)) + 0.5;
    p.setPen(QPen(t.line, 1));
    p.drawLine(QPointF(plot.area.left(), y), QPointF(plot.area.right(), y));
    p.setPen(t.text3);
    p.drawText(QRectF(plot.area.left() - (kBesideAxis + 50) * unit, y - 8 * unit, 50 * unit, 16 * unit),
               Qt::AlignRight | Qt::AlignVCenter, format_number(v, d.y.decimals));
  }
  p.setPen(t.text3);
  for (double v = d.x.least; v <= d.x.most + 1e-9; v += d.x.step) {
    p.drawText(QRectF(plot.x(v) - 30 * unit, plot.area.bottom() + 3 * unit, 60 * unit, 16 * unit), Qt::AlignCenter,
               format_number(v, d.x.decimals));
  }
  if (!d.x.title.isEmpty()) {
    p.drawText(QRectF(plot.area.left(), plot.area.bottom() + 18 * unit, plot.area.width() + kTitlePast * unit, 16 * unit),
               Qt::AlignRight | Qt::AlignVCenter, d.x.title);
  }
}

void paint_diamond(QPainter& p, QPointF at, double r) {
  QPainterPath path;
  path.moveTo(at + QPointF(0, -r));
  path.lineTo(at + QPointF(r, 0));
  path.lineTo(at + QPointF(0, r));
  path.lineTo(at + QPointF(-r, 0));
  path.closeSubpath();
  p.drawPath(path);
}

void paint_bars(QPainter& p, const Plot& plot, const ChartSeries& s, const Tokens& t, double unit) {
  // Bars may stand closer than the figures of the axis.
  const double width = s.points.size() > 1 ? s.points[1].x - s.points[0].x : plot.data.x.step;
  for (const ChartPoint& b : s.points) {
    const QRectF bar(QPointF(plot.x(b.x) + 1.5 * unit, plot.y(b.y)),
                     QPointF(plot.x(b.x + width) - 1.5 * unit, plot.area.bottom()));
    if (b.y <= plot.data.y.least) continue;
    // Below the mark: outline and soft fill, so that the side of the mark shows without colour.
    const bool below = plot.data.mark && b.x + width <= *plot.data.mark + 1e-9;
    QColor fill = t.accent;
    if (below) fill.setAlphaF(0.22);
    p.setPen(QPen(t.accent, 1.2 * unit));
    p.setBrush(fill);
    p.drawRoundedRect(bar, 2 * unit, 2 * unit);
  }
}

/// The pass mark: upright over bars, level over dots and lines.
void paint_mark(QPainter& p, const Plot& plot, const Tokens& t, double unit) {
  const ChartData& d = plot.data;
  const bool has_bars = !d.series.isEmpty() && d.series.first().draw == ChartSeries::Draw::bars;
  p.setFont(caption(unit));
  QPen pen(t.text, 1.4 * unit, Qt::CustomDashLine);
  pen.setDashPattern({3, 2});
  p.setPen(pen);
  const int flags = Qt::AlignRight | Qt::AlignVCenter;
  const auto write = [&](const QRectF& place, const QColor& ink) {
    p.fillRect(p.boundingRect(place, flags, d.mark_text), t.surface);  // no line of the grid strikes it out
    p.setPen(ink);
    p.drawText(place, flags, d.mark_text);
  };
  if (has_bars) {
    const double x = plot.x(*d.mark);
    p.drawLine(QPointF(x, plot.area.top() - 4 * unit), QPointF(x, plot.area.bottom()));
    write(QRectF(x - 126 * unit, plot.area.top() - 6 * unit, 120 * unit, 16 * unit), t.text);
  } else {
    const double y = plot.y(*d.mark);
    p.drawLine(QPointF(plot.area.left(), y), QPointF(plot.area.right(), y));
    write(QRectF(plot.area.right() - 120 * unit, y - 17 * unit, 120 * unit, 16 * unit), t.text2);
  }
}

void paint_line(QPainter& p, const Plot& plot, const ChartSeries& s, const Tokens& t, double unit) {
  QPainterPath path(plot.at(s.points.first()));
  for (const ChartPoint& point : s.points) path.lineTo(plot.at(point));
  p.setPen(QPen(s.quiet ? t.text3 : t.accent, (s.quiet ? 1.4 : 1.8) * unit, s.quiet ? Qt::DashLine : Qt::SolidLine,
                Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  p.drawPath(path);
}

/// `lit_point`: the one of the series under the pointer; -1 for none.
void paint_points(QPainter& p, const Plot& plot, const ChartSeries& s, const Tokens& t, double unit, int lit_point) {
  const QColor ink = s.quiet ? t.text3 : t.accent;
  for (int j = 0; j < s.points.size(); ++j) {
    const ChartPoint& point = s.points[j];
    const QPointF at = plot.at(point);
    const bool lit = j == lit_point;
    if (s.draw == ChartSeries::Draw::diamonds) {
      p.setPen(QPen(t.text2, 1.6 * unit));
      p.setBrush(lit ? t.text2 : t.surface);
      paint_diamond(p, at, 5 * unit);
    } else if (s.draw == ChartSeries::Draw::dots) {
      QColor soft = ink;
      soft.setAlphaF(s.quiet ? 0.7 : 1.0);
      p.setPen(Qt::NoPen);
      p.setBrush(soft);
      p.drawEllipse(at, (lit ? 4.0 : 2.6) * unit, (lit ? 4.0 : 2.6) * unit);
    } else {
      p.setPen(QPen(ink, 1.8 * unit));
      p.setBrush(point.strong || lit ? ink : t.surface);
      const double r = (point.strong || lit ? 4.6 : 3.2) * unit;
      p.drawEllipse(at, r, r);
    }
  }
}

/// The value of a strong point, beside its dot.
void paint_value(QPainter& p, const Plot& plot, const QRectF& rect, const ChartPoint& point, const Tokens& t, double unit) {
  QFont bold = caption(unit);
  bold.setBold(true);
  p.setFont(bold);
  p.setPen(t.text);
  const QPointF at = plot.at(point);
  const QString text = format_points(point.y);
  const QFontMetricsF metrics(bold);
  const double width = metrics.horizontalAdvance(text);
  const bool fits = at.x() + 10 * unit + width < rect.right();
  // Full points lie at the chart's upper edge: the figure then stands below them.
  const bool above = at.y() - 6 * unit - metrics.ascent() >= rect.top();
  p.drawText(QPointF(fits ? at.x() + 8 * unit : at.x() - 8 * unit - width,
                     above ? at.y() - 6 * unit : at.y() + 6 * unit + metrics.ascent()),
             text);
}

}  // namespace

void paint_chart(QPainter& p, const QRectF& rect, const ChartData& d, const Tokens& t, double unit, ChartPick lit) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setLayoutDirection(Qt::LeftToRight);
  const Plot plot = plot_of(rect, d, unit);
  paint_axes(p, plot, t, unit);
  for (const ChartSeries& s : d.series) {
    if (s.draw == ChartSeries::Draw::bars) paint_bars(p, plot, s, t, unit);
  }
  if (d.mark) paint_mark(p, plot, t, unit);
  p.setClipRect(plot.area.adjusted(-8 * unit, -8 * unit, 8 * unit, 8 * unit));
  for (int i = 0; i < d.series.size(); ++i) {
    const ChartSeries& s = d.series[i];
    const bool lined = s.draw == ChartSeries::Draw::line || s.draw == ChartSeries::Draw::line_dots;
    if (lined && s.points.size() > 1) paint_line(p, plot, s, t, unit);
    // A line of one point has no length.
    const bool dotted = s.draw != ChartSeries::Draw::bars && (s.draw != ChartSeries::Draw::line || s.points.size() == 1);
    if (dotted) paint_points(p, plot, s, t, unit, i == lit.series ? lit.point : -1);
  }
  p.setClipping(false);
  for (const ChartSeries& s : d.series) {
    if (s.points.isEmpty()) continue;
    if (s.draw == ChartSeries::Draw::line) {
      const QPointF end = plot.at(s.points.last());
      p.setFont(caption(unit));
      p.setPen(s.quiet ? t.text2 : t.text);
      p.drawText(QRectF(end.x() + 8 * unit, end.y() - 8 * unit, 200 * unit, 16 * unit), Qt::AlignLeft | Qt::AlignVCenter,
                 s.name);
    }
    for (const ChartPoint& point : s.points) {
      if (point.strong) paint_value(p, plot, rect, point, t, unit);
    }
  }
  p.restore();
}

/// Paints the chart. The pointer or the arrow keys pick a point, and a tooltip names it.
class ChartCanvas : public QWidget {
 public:
  explicit ChartCanvas(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(px(200), px(150));
  }
  void set_data(const ChartData& fresh) {
    data_ = fresh;
    lit_ = {};
    setAccessibleName(data_.title);
    setAccessibleDescription(data_.summary);
    update();
  }
  std::function<void(int series, int point)> opened;  // a point was chosen

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    paint_chart(painter, rect(), data_, tokens(), scale_percent() / 100.0, lit_);
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    const Plot plot = plot_of(rect(), data_, scale_percent() / 100.0);
    ChartPick nearest;
    double best = px(12.0);  // farther away no point is meant
    for (int i = 0; i < data_.series.size(); ++i) {
      if (data_.series[i].draw == ChartSeries::Draw::bars) continue;
      for (int j = 0; j < data_.series[i].points.size(); ++j) {
        const double distance = QLineF(plot.at(data_.series[i].points[j]), event->position()).length();
        if (distance >= best) continue;
        best = distance;
        nearest = {i, j};
      }
    }
    light(nearest, event->globalPosition().toPoint());
  }
  void leaveEvent(QEvent*) override { light({}, {}); }
  void mousePressEvent(QMouseEvent*) override {
    if (lit_.series >= 0) opened(lit_.series, lit_.point);
  }
  void keyPressEvent(QKeyEvent* event) override {
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (step != 0 && !data_.series.isEmpty()) {
      const int series = std::max(lit_.series, 0);
      const auto count = static_cast<int>(data_.series[series].points.size());
      if (count == 0) return;
      const int point = lit_.point < 0 ? (step > 0 ? 0 : count - 1) : std::clamp(lit_.point + step, 0, count - 1);
      const Plot plot = plot_of(rect(), data_, scale_percent() / 100.0);
      light({series, point}, mapToGlobal(plot.at(data_.series[series].points[point]).toPoint()));
      return;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && lit_.series >= 0) {
      opened(lit_.series, lit_.point);
      return;
    }
    QWidget::keyPressEvent(event);
  }

 private:
  void light(ChartPick pick, QPoint at) {
    if (pick == lit_) return;
    lit_ = pick;
    if (lit_.series >= 0) {
      const ChartPoint& p = data_.series[lit_.series].points[lit_.point];
      QString text = p.label.isEmpty() ? data_.series[lit_.series].name : p.label;
      text += u'\n' + (data_.value_text != nullptr ? data_.value_text(p.y) : format_points(p.y) + u' ' + data_.y.title);
      QToolTip::showText(at, text, this);
      setAccessibleDescription(text);
    } else {
      QToolTip::hideText();
    }
    update();
  }

  ChartData data_;
  ChartPick lit_;
};

Chart::Chart(QWidget* parent) : QWidget(parent), stack_(new QStackedWidget), canvas_(new ChartCanvas(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(stack_);
  stack_->addWidget(canvas_);
  auto* table = new Table;
  table_ = table;
  table_->setModel(new QStandardItemModel(this));
  stack_->addWidget(table_);
  canvas_->opened = [this](int series, int point) { Q_EMIT point_opened(series, point); };
  auto* toggle = new QAction(this);
  toggle->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_T));
  toggle->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(toggle);
  connect(toggle, &QAction::triggered, this, [this] { set_view(view() == View::plot ? View::table : View::plot); });
}

void Chart::set_data(const ChartData& data) {
  data_ = data;
  canvas_->set_data(data);
  table_->setAccessibleName(data.title);
  fill_table();
}

Chart::View Chart::view() const { return stack_->currentWidget() == table_ ? View::table : View::plot; }

void Chart::set_view(View view) {
  stack_->setCurrentWidget(view == View::table ? static_cast<QWidget*>(table_) : canvas_);
  stack_->currentWidget()->setFocus();
}

void Chart::fill_table() {
  auto* model = static_cast<QStandardItemModel*>(table_->model());
  model->clear();
  const bool bars = !data_.series.isEmpty() && data_.series.first().draw == ChartSeries::Draw::bars;
  model->setHorizontalHeaderLabels({bars ? QString() : tr("Which"), data_.x.title, data_.y.title});
  std::vector<double> values;
  bool whole = true;  // every x
  for (const ChartSeries& s : data_.series) {
    for (const ChartPoint& p : s.points) {
      values.push_back(p.y);
      whole = whole && p.x == std::floor(p.x);
    }
  }
  const int decimals = points_decimals(values);
  for (const ChartSeries& s : data_.series) {
    for (const ChartPoint& p : s.points) {
      QList<QStandardItem*> row = {new QStandardItem(p.label.isEmpty() ? s.name : p.label),
                                   new QStandardItem(format_number(p.x, whole ? 0 : 1)),
                                   new QStandardItem(format_points_to(p.y, decimals))};
      row[1]->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      row[2]->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      model->appendRow(row);
    }
  }
  static_cast<Table*>(table_)->set_stretch_column(0);
}

}  // namespace cusp::ui
