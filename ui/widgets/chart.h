/// Charts as Cusp draws them: y starts where stated, grid in line colour, names at the line's end, n printed, pass mark
/// dashed. Each chart is its table too (Ctrl+T), and a screen reader gets the summary.
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
  bool quiet = false;           // drawn in text3, for those who are not meant
};

struct ChartData {
  QString title;                // for screen readers and the table
  ChartAxis x, y;
  QVector<ChartSeries> series;
  std::optional<double> mark;   // dashed: horizontal for lines and dots, upright for bars
  QString mark_text;
  QString summary;              // one sentence for screen readers
};

/// Paints into any device; the PDF uses the same code with the light tokens.
void paint_chart(QPainter& painter, const QRectF& rect, const ChartData& data, const Tokens& tokens, double unit,
                 int highlighted_series = -1, int highlighted_point = -1);

class ChartCanvas;

class Chart : public QWidget {
  Q_OBJECT

 public:
  explicit Chart(QWidget* parent = nullptr);
  void set_data(const ChartData& data);
  const ChartData& data() const { return data_; }
  bool shows_table() const;

 public Q_SLOTS:
  void show_table(bool on);

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
