// Columns of points in the report: decimal signs below each other.

#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"

namespace cusp::test {
namespace {

Grade with_points(std::initializer_list<std::pair<double, double>> points) {
  Grade out = sample_grade(81);
  const CriterionGrade like = out.criteria[0];
  out.criteria.clear();
  for (const auto& [got, most] : points) {
    CriterionGrade& c = out.criteria.emplace_back(like);
    c.id = "surface_within_" + std::to_string(100 + out.criteria.size());
    c.points = got;
    c.points_max = most;
  }
  return out;
}

QStringList column(const CriteriaModel& model, int role) {
  QStringList out;
  for (int row = 0; row < model.rowCount(); ++row) out += model.index(row, CriteriaModel::kPoints).data(role).toString();
  return out;
}

TEST(CriteriaModel, points_of_every_row_have_the_same_decimals_and_their_maxima_one_width) {
  const CriteriaModel model(with_points({{20, 20}, {3.2, 5}, {75, 75}}), {});
  EXPECT_EQ(column(model, Qt::DisplayRole), (QStringList{QStringLiteral("20.0"), QStringLiteral("3.2"), QStringLiteral("75.0")}));
  EXPECT_EQ(column(model, SecondRole), (QStringList{QStringLiteral("/ 20"), QStringLiteral("/ \u20075"), QStringLiteral("/ 75")}));
  const CriteriaModel whole(with_points({{20, 25}, {5, 75}}), {});
  EXPECT_EQ(column(whole, Qt::DisplayRole), (QStringList{QStringLiteral("20"), QStringLiteral("5")}));
}

TEST(CriteriaModel, reads_the_points_of_a_criterion_with_the_most_it_can_bring) {
  const CriteriaModel model(with_points({{3.2, 5}, {95, 95}, {0, 0}}), {});
  EXPECT_EQ(column(model, Qt::AccessibleTextRole), (QStringList{QStringLiteral("3.2 of 5"), QStringLiteral("95 of 95"), QString()}));
}

TEST(CriteriaModel, what_brings_no_points_gives_its_column_no_decimals) {
  const CriteriaModel model(with_points({{20, 25}, {75, 75}, {0, 0}}), {});
  EXPECT_EQ(column(model, Qt::DisplayRole), (QStringList{QStringLiteral("20"), QStringLiteral("75"), QStringLiteral("no points")}));
  EXPECT_EQ(column(model, SecondRole).last(), QString());
}

TEST(AgainstBefore, gives_every_gain_the_same_decimals) {
  const AgainstBefore view(with_points({{20, 20}, {4.5, 5}, {70, 75}}), with_points({{20, 20}, {3, 5}, {75, 75}}));
  const QString spoken = view.accessibleDescription().remove(QChar(0x2066)).remove(QChar(0x2069));
  EXPECT_TRUE(spoken.contains(QStringLiteral("+1.5"))) << spoken.toStdString();
  EXPECT_TRUE(spoken.contains(QStringLiteral("\u22125.0"))) << spoken.toStdString();
  EXPECT_TRUE(spoken.contains(QStringLiteral(" 0.0"))) << spoken.toStdString();
}

}  // namespace
}  // namespace cusp::test
