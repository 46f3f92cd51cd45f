// The report in a narrow window.

#include <gtest/gtest.h>

#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/report/criteria_model.h"
#include "ui/report/report_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

TEST(CriteriaModel, gives_up_bars_and_uncertainty_in_a_narrow_table_and_never_points) {
  CriteriaModel model(test::sample_grade(81), {});
  model.set_detail(CriteriaModel::Detail::narrow);
  const auto at = [&](int column, int role = Qt::DisplayRole) { return model.index(1, column).data(role); };
  EXPECT_TRUE(at(CriteriaModel::kYours).toString().contains(QStringLiteral("2.41")));
  EXPECT_FALSE(at(CriteriaModel::kYours, SecondRole).isValid());
  EXPECT_TRUE(at(CriteriaModel::kYours, Qt::AccessibleTextRole).toString().contains(QStringLiteral("0.03")));
  EXPECT_FALSE(at(CriteriaModel::kPoints, ShareRole).isValid());
  EXPECT_EQ(at(CriteriaModel::kPoints, SecondRole).toString().toStdString(), "/ 33.3");
}

TEST(ReportPage, a_narrow_window_cuts_nothing_off_at_the_side) {
  ReportData data;
  data.result.scenario = *load_builtin("channel-1");
  data.result.grade = test::sample_grade(81);
  data.title = QStringLiteral("Straight channel");
  data.when = QDateTime(QDate(2026, 11, 20), QTime(10, 14));
  data.before = test::sample_grade(95);
  data.before_when = data.when;
  data.result.grade.criteria[1].id = "overcut_leeway_side";
  const Ports ports = Ports::of_the_system();
  ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.resize(853, 533);  // 1280x800 at 150 %
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.table()->horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(page.table()->verticalScrollBar()->maximum(), 0);
  const auto* scroll = page.findChild<QScrollArea*>();
  ASSERT_NE(scroll, nullptr);
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
  int named = 0;
  for (const QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() != u"Print" && b->accessibleName() != u"Save as PDF") continue;
    ++named;
    EXPECT_TRUE(b->text().isEmpty());
    EXPECT_TRUE(b->toolTip().startsWith(b->accessibleName()));
  }
  EXPECT_EQ(named, 2);
  page.resize(1280, 800);
  QTest::qWait(0);
  for (const QPushButton* b : page.findChildren<QPushButton*>()) EXPECT_FALSE(b->text().isEmpty()) << b->accessibleName().toStdString();
}

}  // namespace
}  // namespace cusp::test
