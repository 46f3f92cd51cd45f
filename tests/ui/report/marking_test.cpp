// An attempt is marked on its report: comments, changed points, confirmation, release; and the student reads what was said.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>

#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/criteria_model.h"
#include "ui/report/marking_card.h"
#include "ui/report/report_page.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

class Marking : public testing::Test {
 protected:
  Marking() {
    lena = records.student("4711", "Lena Brandt");
    examiner = *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
    session = records.attempt(lena, "channel-1", 66, 90);
  }
  ReportData gathered(const Account& reader) {
    SessionResult result;
    result.session = session;
    result.scenario = *load_builtin("channel-1");
    result.grade = (*records.store().grades.newest(session))->grade;
    const Actor actor = reader.actor();
    return gather_report(result, &records.store(), &actor);
  }
  static QPushButton* button(QWidget& in, const char* text) {
    for (QPushButton* b : in.findChildren<QPushButton*>())
      if (b->text().trimmed() == QString::fromUtf8(text)) return b;
    ADD_FAILURE() << "no button " << text;
    return nullptr;
  }
  static void say(QWidget& card, const char* text) { card.findChild<QPlainTextEdit*>()->setPlainText(QString::fromUtf8(text)); }
  static QString message(QWidget& card) { return card.findChild<Band*>()->text(); }

  DeskRecords records;
  Account lena, examiner;
  SessionId session;
  Ports ports = Ports::of_the_system();
};

TEST_F(Marking, ChangedPointsCountOnTheReportAndTheReasonIsRead) {
  ReportPage page(gathered(examiner), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  MarkingCard card(records.store(), examiner.actor(), page.data(), ports);
  QSignalSpy stated(&card, &MarkingCard::stated);
  page.table()->choose_row(1);
  ASSERT_NE(page.chosen_criterion(), nullptr);
  const CriterionGrade before = *page.chosen_criterion();
  ASSERT_LT(before.points, before.points_max);
  card.set_criterion(&before);
  card.findChild<NumberField*>()->setValue(before.points_max);
  button(card, "Change points")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("needs a reason")));
  EXPECT_EQ(stated.count(), 0);
  say(card, "The block was worn.");
  button(card, "Change points")->click();
  ASSERT_EQ(stated.count(), 1) << message(card).toStdString();

  page.show_data(gathered(examiner));
  EXPECT_DOUBLE_EQ(page.data().result.grade.score, 66 + before.points_max - before.points);
  EXPECT_EQ(page.findChildren<Table*>().last()->model()->rowCount(), static_cast<int>(page.data().result.grade.criteria.size()));
  const QAbstractItemModel& table = *page.table()->model();
  for (int row = 0; row < table.rowCount(); ++row) {
    const QModelIndex name = table.index(row, CriteriaModel::kName);
    EXPECT_EQ(name.data().toString().contains(QStringLiteral("(changed)")), row == 1) << name.data().toString().toStdString();
    EXPECT_EQ(name.data(Qt::ToolTipRole).toString().contains(QStringLiteral("The block was worn.")), row == 1);
    EXPECT_EQ(name.data(IconRole).toString().isEmpty(), row != 1);
  }
  EXPECT_TRUE(table.index(1, CriteriaModel::kName).data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("Dr Berg")));
  const ReportData of_student = gathered(lena);
  ASSERT_EQ(of_student.changes.size(), 1u);
  ASSERT_EQ(of_student.remarks.size(), 1u);
  EXPECT_EQ(of_student.remarks[0].who, QStringLiteral("Dr Berg"));
  EXPECT_EQ(of_student.remarks[0].text, QStringLiteral("The block was worn."));
  EXPECT_TRUE(of_student.remarks[0].what.contains(QStringLiteral("instead of"))) << of_student.remarks[0].what.toStdString();
}

TEST_F(Marking, ACommentHasThePlaceOfTheChosenCriterionAndCanBeTakenBack) {
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  CriterionGrade criterion = gathered(examiner).result.grade.criteria.front();
  card.set_criterion(&criterion);
  criterion.measure.where_mm = Vec3(1, 2, 3);
  card.set_criterion(&criterion);
  card.findChild<QCheckBox*>()->setChecked(true);
  button(card, "Add comment")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("empty")));
  say(card, "Here you slipped.");
  button(card, "Add comment")->click();
  const ReportData of_student = gathered(lena);
  ASSERT_EQ(of_student.remarks.size(), 1u);
  EXPECT_EQ(of_student.remarks[0].place_mm, Vec3(1, 2, 3));

  card.show_data(gathered(examiner));
  say(card, "Another one's.");
  button(card, "Take back")->click();
  EXPECT_TRUE(gathered(lena).remarks.empty()) << message(card).toStdString();
}

TEST_F(Marking, IsOneLineInALowWindowUntilItIsOpened) {
  for (const int height : {800, 1000}) {
    ReportPage page(gathered(examiner), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
    auto* card = new MarkingCard(records.store(), examiner.actor(), page.data(), ports);
    page.set_card(card);
    page.resize(1280, height);
    page.show();
    QCoreApplication::processEvents();
    const bool open = height == 1000;
    EXPECT_EQ(card->findChild<QPlainTextEdit*>()->isVisible(), open);
    if (open) continue;
    EXPECT_LT(card->height(), px(52)) << "one line of controls";
    button(*card, "Mark this attempt")->click();
    EXPECT_TRUE(card->findChild<QPlainTextEdit*>()->isVisible());
    page.hide();
    page.show();
    EXPECT_TRUE(card->findChild<QPlainTextEdit*>()->isVisible()) << "as the examiner left it";
  }
}

TEST_F(Marking, AnOwnAssessmentStandsBesideTheCriteriaForStudentAndExaminer) {
  ReportPage without(gathered(lena), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  EXPECT_TRUE(without.table()->isColumnHidden(CriteriaModel::kOwn));
  EXPECT_TRUE(own_assessment_text(without.data()).isEmpty());
  const std::string first = without.data().result.grade.criteria[0].id;
  ASSERT_TRUE(records.store().statements.assess_own(lena.actor(), session, {{{first, OwnRating::partly}}}));
  for (const Account& reader : {lena, examiner}) {
    ReportPage page(gathered(reader), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
    EXPECT_FALSE(page.table()->isColumnHidden(CriteriaModel::kOwn)) << reader.number;
    EXPECT_EQ(page.table()->model()->index(0, CriteriaModel::kOwn).data().toString(), QStringLiteral("partly met"));
    EXPECT_EQ(own_assessment_text(page.data()), QStringLiteral("Own assessment: 50 of 100 on 1 rated criterion, measured 100"));
    EXPECT_TRUE(page.data().remarks.empty()) << "nothing that an examiner said";
  }
}

TEST_F(Marking, ASkippedOwnAssessmentIsNamed) {
  ASSERT_TRUE(records.store().statements.assess_own(lena.actor(), session, {}));
  ReportPage page(gathered(examiner), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  EXPECT_TRUE(page.table()->isColumnHidden(CriteriaModel::kOwn));
  EXPECT_EQ(own_assessment_text(page.data()), QStringLiteral("Own assessment: skipped"));
}

TEST_F(Marking, PracticeIsNeverReleased) {
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  EXPECT_TRUE(button(card, "Release to the student")->isHidden());
}

TEST_F(Marking, ARefusedStatementIsShownAndKeepsTheText) {
  MarkingCard card(records.store(), lena.actor(), gathered(lena), ports);
  say(card, "I was good.");
  button(card, "Add comment")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("may not"))) << message(card).toStdString();
  EXPECT_EQ(card.findChild<QPlainTextEdit*>()->toPlainText(), QStringLiteral("I was good."));
}

}  // namespace
}  // namespace cusp::test
