// A chart: its picture, and what it says of its points in its tooltip, to a screen reader and in its table.

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QStackedWidget>
#include <QTableView>
#include <QTest>

#include "tests/modules.h"
#include "ui/widgets/chart.h"

namespace cusp::test {
namespace {

ChartData scores(const QVector<ChartPoint>& points) {
  ChartData d;
  d.title = QStringLiteral("Time and score");
  d.x = {QStringLiteral("minutes"), 0, 14, 2, 0};
  d.y = {QStringLiteral("points"), 0, 100, 20, 0};
  ChartSeries s;
  s.name = QStringLiteral("You");
  s.points = points;
  d.series = {s};
  return d;
}

TEST(ChartTexts, every_row_of_the_table_has_the_decimals_of_its_column) {
  Chart chart;
  chart.set_data(scores({{12.4, 54, QStringLiteral("first"), false}, {7, 78.5, QStringLiteral("last"), true}}));
  const QAbstractItemModel& table = *chart.findChild<QTableView*>()->model();
  EXPECT_EQ(table.index(0, 1).data().toString(), QStringLiteral("12.4"));
  EXPECT_EQ(table.index(1, 1).data().toString(), QStringLiteral("7.0"));
  EXPECT_EQ(table.index(0, 2).data().toString(), QStringLiteral("54.0"));
  EXPECT_EQ(table.index(1, 2).data().toString(), QStringLiteral("78.5"));
  chart.set_data(scores({{12, 54, {}, false}, {7, 78, {}, true}}));
  EXPECT_EQ(table.index(0, 1).data().toString(), QStringLiteral("12"));
  EXPECT_EQ(table.index(0, 2).data().toString(), QStringLiteral("54"));
}

TEST(ChartTexts, a_point_that_is_picked_is_named_in_the_words_of_its_data) {
  ChartData d = scores({{1, 1, QStringLiteral("Fri 20 Nov"), false}});
  const auto picked = [&] {
    Chart chart;
    chart.resize(320, 220);
    chart.set_data(d);
    chart.show();
    QWidget* canvas = chart.findChild<QStackedWidget*>()->widget(0);
    QTest::keyClick(canvas, Qt::Key_Right);
    return canvas->accessibleDescription();
  };
  EXPECT_EQ(picked(), QStringLiteral("Fri 20 Nov\n1 points"));
  d.value_text = [](double y) { return QStringLiteral("%1 of a kind").arg(y); };
  EXPECT_EQ(picked(), QStringLiteral("Fri 20 Nov\n1 of a kind"));
}

ChartData two_attempts() {
  ChartData d;
  d.title = QStringLiteral("Time and score");
  d.x = {QStringLiteral("minutes"), 0, 14, 2, 0};
  d.y = {QStringLiteral("points"), 40, 100, 20, 0};
  d.mark = 70;
  d.mark_text = QStringLiteral("pass 70");
  ChartSeries s;
  s.name = QStringLiteral("You");
  s.points = {{12.4, 54, QStringLiteral("first"), false}, {7.1, 78, QStringLiteral("last"), true}};
  d.series = {s};
  return d;
}

TEST(Chart, is_its_table_too) {
  Chart chart;
  chart.resize(320, 220);
  chart.set_data(two_attempts());
  chart.show();
  EXPECT_EQ(chart.view(), Chart::View::plot);
  QTest::keyClick(chart.focusWidget() ? chart.focusWidget() : &chart, Qt::Key_T, Qt::ControlModifier);
  chart.set_view(Chart::View::table);
  EXPECT_EQ(chart.view(), Chart::View::table);
  const auto* table = chart.findChild<QTableView*>();
  ASSERT_NE(table, nullptr);
  ASSERT_EQ(table->model()->rowCount(), 2);
  EXPECT_EQ(table->model()->index(1, 0).data().toString().toStdString(), "last");
  EXPECT_EQ(table->model()->index(1, 2).data().toString().toStdString(), "78");
}

TEST(Chart, draws_its_points_where_the_axes_say) {
  // 320 x 220: the newest attempt is a filled dot in accent at x = 7.1 of 0..14, y = 78 of 40..100.
  QImage image(320, 220, QImage::Format_RGB32);
  image.fill(Tokens::light().surface);
  QPainter painter(&image);
  paint_chart(painter, QRectF(0, 0, 320, 220), two_attempts(), Tokens::light(), 1.0);
  painter.end();
  int found = 0, top = 220, bottom = 0;
  for (int y = 0; y < 220; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (image.pixelColor(x, y) != Tokens::light().accent) continue;
      ++found;
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  EXPECT_GT(found, 40);
  // Between the lines of 80 and of 40 points (8 from the top and 34 from the bottom are margins).
  const auto y_of = [](double points) { return 186 - (points - 40) / 60 * 178; };
  EXPECT_GT(top, y_of(84));
  EXPECT_LT(bottom, y_of(48));
}

TEST(Chart, no_line_of_the_grid_strikes_out_the_name_of_the_pass_mark_over_bars) {
  const Tokens& t = Tokens::light();
  ChartData d = two_attempts();
  d.x = {QStringLiteral("points"), 0, 100, 10, 0};
  d.y = {QStringLiteral("attempts"), 0, 5, 1, 0};
  d.series[0].draw = ChartSeries::Draw::bars;
  d.series[0].points = {{0, 1, {}, false}, {5, 0, {}, false}};
  const auto drawn = [&](const QString& name) {
    d.mark_text = name;
    QImage image(320, 220, QImage::Format_RGB32);
    image.fill(t.surface);
    QPainter painter(&image);
    paint_chart(painter, QRectF(0, 0, 320, 220), d, t, 1.0);
    painter.end();
    int on_line = 0;
    for (int x = 0; x < 320; ++x) on_line += image.pixelColor(x, 8) == t.line;  // the line of 5 attempts
    return on_line;
  };
  EXPECT_GT(drawn({}), 250);
  EXPECT_LT(drawn(QStringLiteral("pass 70")), drawn({}) - 30);  // the name is some 45 px wide
}

TEST(Chart, a_figure_of_full_points_is_drawn_whole) {
  // 100 of 100 lies 8 px below the chart's upper edge, its figure is 9 px high: above the dot it would be cut off.
  const auto dark_pixels = [](double points) {
    ChartData d = two_attempts();
    d.mark.reset();
    d.series[0].points = {{7.1, points, QStringLiteral("last"), true}};
    QImage image(320, 220, QImage::Format_RGB32);  // its edge is the canvas's
    image.fill(Tokens::light().surface);
    QPainter painter(&image);
    paint_chart(painter, QRectF(0, 0, 320, 220), d, Tokens::light(), 1.0);
    painter.end();
    int dark = 0;
    for (int y = 0; y < 220; ++y)
      for (int x = 0; x < 320; ++x) dark += qGray(image.pixel(x, y)) < 60;
    return dark;
  };
  EXPECT_GE(dark_pixels(100), dark_pixels(88));  // one more digit
}

TEST(Chart, draws_nothing_past_the_edges_of_its_canvas) {
  ChartData d = two_attempts();
  d.x = {QStringLiteral("attempt"), 1, 4, 1, 0};
  d.y = {QStringLiteral("attempts"), 0, 5, 1, 0};  // digits alone: the narrowest margins
  d.mark = 4;
  d.series[0].points = {{1, 1, {}, false}, {4, 3, QStringLiteral("last"), true}};
  const QRect canvas(40, 40, 320, 220);
  QImage image(400, 300, QImage::Format_RGB32);
  image.fill(Tokens::light().surface);
  QPainter painter(&image);
  paint_chart(painter, canvas, d, Tokens::light(), 1.0);
  painter.end();
  int past = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) past += !canvas.contains(x, y) && image.pixelColor(x, y) != Tokens::light().surface;
  EXPECT_EQ(past, 0);
}

TEST(Chart, a_line_of_one_point_is_seen) {
  ChartData d = two_attempts();
  d.series[0].draw = ChartSeries::Draw::line;
  d.series[0].points = {{7.1, 78, QStringLiteral("Median of 30 students"), false}};
  QImage image(320, 220, QImage::Format_RGB32);
  image.fill(Tokens::light().surface);
  QPainter painter(&image);
  paint_chart(painter, QRectF(0, 0, 320, 220), d, Tokens::light(), 1.0);
  painter.end();
  int found = 0;
  for (int y = 0; y < 220; ++y)
    for (int x = 0; x < 320; ++x) found += image.pixelColor(x, y) == Tokens::light().accent;
  EXPECT_GT(found, 0);
}

TEST(Chart, its_table_rounds_no_points_up_to_the_pass_mark) {
  ChartData d = two_attempts();
  d.series[0].points[1].y = 69.96;
  Chart chart;
  chart.set_data(d);
  EXPECT_EQ(chart.findChild<QTableView*>()->model()->index(1, 2).data().toString().toStdString(), "69.9");
}

}  // namespace
}  // namespace cusp::test
