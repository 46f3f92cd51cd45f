// What a chart says of its points: in its tooltip, to a screen reader and in its table.

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cusp::test
