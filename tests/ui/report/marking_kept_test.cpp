// What stands in the card that marks an attempt, and stays while its report is read anew.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct KeptMarking : ::testing::Test {
  ReportData gathered() { return report_of(records, session, examiner); }
  static QPushButton* button(QWidget& in, const char* text) {
    for (QPushButton* one : in.findChildren<QPushButton*>())
      if (one->text().trimmed() == QString::fromUtf8(text)) return one;
    ADD_FAILURE() << "no button " << text;
    return nullptr;
  }
  static void write_on(QWidget& card, const char* text) { card.findChild<QPlainTextEdit*>()->setPlainText(QString::fromUtf8(text)); }
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

TEST_F(KeptMarking, IsAskedAboutBeforeThePageIsLeftWithTypedPoints) {
  QStringList asked;
  ports.ask = [&](QWidget*, const Question& question, const std::function<void(bool)>&) { asked += question.what; };
  ReportPage page(gathered(), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  auto* card = new MarkingCard(records.store(), examiner.actor(), page.data(), ports);
  page.set_card(card);
  QSignalSpy back(&page, &ReportPage::back_wanted);
  page.table()->choose_row(1);
  ASSERT_NE(page.chosen_criterion(), nullptr);
  card->set_criterion(page.chosen_criterion());
  button(page, "Back")->click();
  EXPECT_EQ(back.count(), 1) << "these are the points that count";
  auto* field = card->findChild<NumberField*>();
  ASSERT_LT(field->value(), field->maximum());
  field->setValue(field->maximum());
  EXPECT_TRUE(card->has_points());
  button(page, "Back")->click();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Leave without the changed points?")});
  EXPECT_EQ(back.count(), 1);
  write_on(*card, "The block was worn.");
  button(*card, "Change points")->click();
  EXPECT_FALSE(card->unsaved());
  button(page, "Back")->click();
  EXPECT_EQ(back.count(), 2);
}

TEST_F(KeptMarking, IsAskedAboutBeforeAnotherAttemptLeavesThePage) {
  int asked = 0;
  ports.ask = [&](QWidget*, const Question&, const std::function<void(bool)>&) { ++asked; };
  ReportPage page(gathered(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  auto* card = new MarkingCard(records.store(), examiner.actor(), page.data(), ports);
  page.set_card(card);
  QSignalSpy again(&page, &ReportPage::try_again_wanted);
  write_on(*card, "My own hand slipped.");
  button(page, "Try again")->click();
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(again.count(), 0);
  write_on(*card, "");
  button(page, "Try again")->click();
  EXPECT_EQ(again.count(), 1);
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
