// What stands in the card that marks an attempt, and stays while its report is read anew.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/marking_card.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

struct KeptMarking : ::testing::Test {
  ReportData gathered() { return report_of(records, session, examiner); }
  static const CriterionGrade& lost_points(const ReportData& data) {
    return *std::ranges::find_if(data.result.grade.criteria, [](const CriterionGrade& c) { return c.points < c.points_max; });
  }

  DeskRecords records;
  Ports ports = Ports::of_the_system();
  Account lena = records.student("4711", "Lena Brandt");
  Account examiner = *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  SessionId session = records.attempt(lena, "channel-1", 66, 90);
};

TEST_F(KeptMarking, HasTheTypedPointsAfterACommentAndNotAfterAnotherCriterion) {
  const ReportData data = gathered();
  MarkingCard card(records.store(), examiner.actor(), data, ports);
  card.set_criterion(&lost_points(data));
  auto* points = card.findChild<NumberField*>();
  ASSERT_LT(points->value(), points->maximum());
  points->setValue(points->maximum());
  card.findChild<QPlainTextEdit*>()->setPlainText(QStringLiteral("The block was worn."));
  for (QPushButton* button : card.findChildren<QPushButton*>())
    if (button->text().trimmed() == QStringLiteral("Add comment")) button->click();
  const ReportData fresh = gathered();
  ASSERT_EQ(fresh.remarks.size(), 1u);
  card.show_data(fresh);
  card.set_criterion(&lost_points(fresh));
  EXPECT_DOUBLE_EQ(points->value(), points->maximum());
  card.set_criterion(nullptr);
  card.set_criterion(&lost_points(fresh));
  EXPECT_LT(points->value(), points->maximum());
}

TEST_F(KeptMarking, HasTheRemarkThatIsToBeTakenBack) {
  for (const char* text : {"Mind the floor.", "Mind the walls."}) ASSERT_TRUE(records.store().statements.comment(examiner.actor(), session, text, {}));
  MarkingCard card(records.store(), examiner.actor(), gathered(), ports);
  QComboBox* remarks = nullptr;
  for (QComboBox* box : card.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("What was said")) remarks = box;
  ASSERT_NE(remarks, nullptr);
  ASSERT_EQ(remarks->count(), 2);
  remarks->setCurrentIndex(1);
  const QVariant chosen = remarks->currentData();
  ASSERT_TRUE(records.store().statements.comment(examiner.actor(), session, "Well polished.", {}));
  card.show_data(gathered());
  EXPECT_EQ(remarks->count(), 3);
  EXPECT_EQ(remarks->currentData(), chosen);
}

TEST_F(KeptMarking, OffersCommentsAloneOnTheExaminersOwnAttempt) {
  ASSERT_TRUE(records.store().accounts.set_password(records.administrator().actor(), lena.id, {}, "correct horse"));
  ASSERT_TRUE(records.store().accounts.set_role(records.administrator().actor(), lena.id, Role::instructor));
  examiner = *records.store().accounts.find(lena.id);
  MarkingCard card(records.store(), examiner.actor(), gathered(), ports);
  QStringList offered;
  for (QPushButton* button : card.findChildren<QPushButton*>()) offered += button->text().trimmed();
  EXPECT_TRUE(offered.contains(QStringLiteral("Add comment")));
  for (const char* decision : {"Change points", "Confirm the result", "Release to the student"}) EXPECT_FALSE(offered.contains(QString::fromUtf8(decision)));
}

}  // namespace
}  // namespace cusp::test
