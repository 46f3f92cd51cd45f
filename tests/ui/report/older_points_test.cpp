// An attempt that evaluator 2 graded: its criteria have points of their weights, and people read points of the score. And one whose
// table rounds so that its points add up.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/criteria_model.h"
#include "ui/report/marking_card.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

/// 24 of weights that sum to 30, so 80 of 100; depth_most has 4 of 10, so 13.3 of 33.3.
struct OlderPoints : ::testing::Test {
  DeskRecords records;
  Account lena = records.student("4711", "Lena Brandt"), examiner;
  SessionId session;
  Ports ports = Ports::of_the_system();
  void SetUp() override {
    const auto made = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
    ASSERT_TRUE(made);
    examiner = *made;
    Grade grade = sample_grade(80);
    grade.evaluator = "2";
    session = records.graded_attempt(lena, "channel-1", grade, 90);
  }
  ReportData gathered() { return report_of(records, session, examiner); }
  /// Of depth_most, as the table of criteria shows them.
  static QString in_table(const ReportData& data) {
    const CriteriaModel model(data.result.grade, data.result.scenario, data.changes);
    return model.index(1, CriteriaModel::kPoints).data(Qt::AccessibleTextRole).toString();
  }
  /// Types points and a reason into a card and presses its button. Returns what the card showed before.
  QStringList change(double points) {
    const ReportData data = gathered();
    MarkingCard card(records.store(), examiner.actor(), data, ports);
    card.set_criterion(&data.result.grade.criteria[1]);
    auto* field = card.findChild<NumberField*>();
    QStringList shown{field->text()};
    for (const QLabel* label : card.findChildren<QLabel*>())
      if (label->text().contains(QStringLiteral(", of "))) shown += label->text().section(QStringLiteral(", of "), 1);
    field->setValue(points);
    card.findChild<QPlainTextEdit*>()->setPlainText(QStringLiteral("The block was worn."));
    QSignalSpy stated(&card, &MarkingCard::stated);
    for (QPushButton* button : card.findChildren<QPushButton*>())
      if (button->text().trimmed() == QStringLiteral("Change points")) button->click();
    EXPECT_EQ(stated.count(), 1);
    return shown;
  }
};

TEST_F(OlderPoints, are_changed_in_the_points_that_the_report_shows) {
  ASSERT_EQ(in_table(gathered()), QStringLiteral("13.3 of 33.3"));
  EXPECT_EQ(change(20), (QStringList{QStringLiteral("13.3"), QStringLiteral("33.3")}));
  const ReportData data = gathered();
  EXPECT_EQ(in_table(data), QStringLiteral("20 of 33.3"));
  EXPECT_NEAR(data.result.grade.score, 100 - 13.33, 0.01) << "26 of 30";
  ASSERT_EQ(data.remarks.size(), 1u);
  EXPECT_TRUE(data.remarks[0].what.endsWith(QStringLiteral("20 instead of 13.3 points"))) << data.remarks[0].what.toStdString();
  ASSERT_EQ(data.changes.size(), 1u);
  EXPECT_TRUE(data.changes[0].text.startsWith(QStringLiteral("20 instead of 13.3 points, changed by"))) << data.changes[0].text.toStdString();
}

TEST_F(OlderPoints, can_be_given_in_full) {
  change(33.3);
  const ReportData data = gathered();
  EXPECT_EQ(data.result.grade.criteria[1].points, 10) << "its whole weight";
  EXPECT_NEAR(data.result.grade.score, 100, 1e-9);
}

struct OfferedPoints : OlderPoints {};

TEST_F(OfferedPoints, are_those_of_the_table) {
  Grade grade = sample_grade(60);
  grade.criteria.push_back(grade.criteria[0]);
  grade.criteria[2].id = grade.criteria[2].measure.metric = "depth_mean";
  // To a tenth they would be 33.4, 33.4 and 33.3.
  const double most[] = {33.36, 33.36, 33.28}, points[] = {20, 10, 20};
  for (std::size_t i = 0; i < 3; ++i) {
    grade.criteria[i].points_max = most[i];
    grade.criteria[i].points = points[i];
  }
  session = records.graded_attempt(lena, "channel-1", grade, 90);
  ASSERT_EQ(in_table(gathered()), QStringLiteral("10 of 33.3"));
  EXPECT_EQ(change(33.3), (QStringList{QStringLiteral("10.0"), QStringLiteral("33.3")}));
  const ReportData data = gathered();
  EXPECT_EQ(in_table(data), QStringLiteral("33.3 of 33.3"));
  EXPECT_EQ(data.result.grade.criteria[1].points, 33.36) << "full points";
  ASSERT_EQ(data.remarks.size(), 1u);
  EXPECT_TRUE(data.remarks[0].what.endsWith(QStringLiteral("33.3 instead of 10 points"))) << data.remarks[0].what.toStdString();
}

}  // namespace
}  // namespace cusp::test
