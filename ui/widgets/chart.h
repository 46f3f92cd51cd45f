/// Charts: y starts where stated, names stand at the lines' ends, the pass mark is dashed. Each chart has its table (Ctrl+T)
/// and a summary for screen readers. Thread: GUI; paint_chart() any thread with a painter.
#pragma once

#include <QColor>
#include <QString>
#include <QVector>
#include <QWidget>
#include <optional>

class QStackedWidget;
class QTableView;

namespace cusp::ui {

struct Tokens;

struct ChartAxis {
  QString title;
  double least = 0, most = 100, step = 20;
  int decimals = 0;
};

struct ChartPoint {
  double x = 0, y = 0;
  QString label{};    // in the table and the tooltip: "Fri 20 Nov, 10:14"
  bool strong = false;  // filled and named, as the newest attempt
};

struct ChartSeries {
  enum class Draw { dots, line, line_dots, diamonds, bars };
  QString name;
  Draw draw = Draw::line_dots;
  QVector<ChartPoint> points;   // bars: x is the left edge of the bar, width one x step
  bool quiet = false;           // drawn in text3, as a background to the others
};

struct ChartData {
  QString title;                // for screen readers and the table
  ChartAxis x, y;
  QVector<ChartSeries> series;
  std::optional<double> mark;   // dashed: horizontal for lines and dots, upright for bars
  QString mark_text;
  QString summary;              // one sentence for a screen reader
  QString (*value_text)(double y) = nullptr;  // "1 point", in the tooltip; nullptr: the number and the axis' title
};

/// One point of one series; -1 and -1 for none.
struct ChartPick {
  int series = -1, point = -1;
  bool operator==(const ChartPick&) const = default;
};

/// Paints into any device. `unit`: of the device to a pixel of the screen at 100 %; `lit`: drawn larger.
void paint_chart(QPainter& painter, const QRectF& rect, const ChartData& data, const Tokens& tokens, double unit,
                 ChartPick lit = {});

class ChartCanvas;

class Chart : public QWidget {
  Q_OBJECT

 public:
  explicit Chart(QWidget* parent = nullptr);
  void set_data(const ChartData& data);
  const ChartData& data() const { return data_; }
  /// Ctrl+T changes between the plot and the same numbers as a table.
  enum class View { plot, table };
  View view() const;
  void set_view(View view);

 Q_SIGNALS:
  /// A point was opened with a click or Enter.
  void point_opened(int series, int point);

 private:
  void fill_table();
  ChartData data_;
  QStackedWidget* stack_;
  ChartCanvas* canvas_;
  QTableView* table_;
};

}  // namespace cusp::ui
