// What a chart says of its points.

#include <gtest/gtest.h>

#include <QTableView>

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

}  // namespace
}  // namespace cusp::test
