// An attempt is marked on its report: comments, changed points, confirmation, release; and the student reads what was said.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/modules.h"
#include "tests/ui/looks.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/criteria_model.h"
#include "ui/report/marking_card.h"
#include "ui/report/pinned_tooth.h"
#include "ui/report/report_page.h"
#include "ui/report/report_pdf.h"
#include "ui/session/scene_builder.h"
#include "ui/text/grade_text.h"
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
  ReportData gathered(const Account& reader) { return report_of(records, session, reader); }
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
  auto* field = card.findChild<NumberField*>();
  field->setValue(field->maximum());
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

/// The criterion as the report of `reader` has it.
const CriterionGrade& criterion_in(const ReportData& data, std::string_view id) {
  return *std::ranges::find(data.result.grade.criteria, id, &CriterionGrade::id);
}

TEST_F(Marking, NextTimeAndItsPicturesLeaveOutWhatWasChangedByHand) {
  const ReportData measured = gathered(examiner);
  ASSERT_EQ(next_time(measured).size(), 1u);
  ASSERT_EQ(next_time(measured)[0].metric, "depth_most");
  ASSERT_EQ(order_for_paper(measured, 100).places.size(), 1u);
  ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "depth_most", 9.6, "The block was worn."));
  const ReportData changed = gathered(lena);
  EXPECT_DOUBLE_EQ(criterion_in(changed, "depth_most").points, 9.6);  // 0.4 of 10 are still lost
  EXPECT_TRUE(next_time(changed).empty());
  EXPECT_TRUE(order_for_paper(changed, 100).places.empty());
  EXPECT_TRUE(no_advice_text(changed).contains(QStringLiteral("changed by hand"))) << no_advice_text(changed).toStdString();
  EXPECT_EQ(no_advice_text({}), QStringLiteral("Every criterion has its full points."));
}

TEST_F(Marking, TheCardOfAChangedCriterionGivesTheChangeInPlaceOfTheMeasuredReason) {
  const auto volume = build_specimen(*load_builtin("channel-1"), {});
  ASSERT_TRUE(volume);
  const auto card_text = [&] {
    ReportData data = gathered(lena);
    data.result.volume = std::make_shared<const Volume>(*volume);
    ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
    page.resize(1280, 800);
    const PinnedTooth* tooth = page.findChild<PinnedTooth*>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return tooth->tooth_shown(); }, 60'000));
    page.table()->choose_row(0);
    page.table()->choose_row(1);
    leave_picture(page, QStringLiteral("changed-%1").arg(data.changes.size()));
    QString out;
    for (const QLabel* label : tooth->findChildren<QLabel*>()) out += label->text();
    return out;
  };
  EXPECT_TRUE(card_text().contains(QStringLiteral("deeper than"))) << card_text().toStdString();
  ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "depth_most", 9.6, "The block was worn."));
  EXPECT_FALSE(card_text().contains(QStringLiteral("deeper than")));
  EXPECT_TRUE(card_text().contains(QStringLiteral("The block was worn."))) << card_text().toStdString();
}

TEST_F(Marking, AChangedCriterionNoLongerCountsWithTheTarget) {
  Grade grade = sample_grade(40);
  grade.criteria[0].measure.value = 43.5;
  grade.criteria[0].points = 5;
  grade.criteria[0].reason_code = "too_little";
  grade.criteria[1].reason_code = "little_drilled";
  session = records.graded_attempt(lena, "channel-1", grade, 90);
  const auto counted = [&] {
    const ReportData data = gathered(lena);
    return counted_text(data.result.grade, data.result.scenario.rubric);
  };
  EXPECT_FALSE(counted().isEmpty());
  ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "depth_most", 9, "The block was worn."));
  EXPECT_TRUE(counted().isEmpty()) << counted().toStdString();
  const ReportData data = gathered(lena);
  const CriteriaModel model(data.result.grade, data.result.scenario, data.changes);
  EXPECT_EQ(model.index(1, CriteriaModel::kSign).data(IconRole).toString(), QStringLiteral("warning")) << "1 of 10 points is lost";
}

TEST_F(Marking, AChangeThatALaterOneReplacesIsShownAsSuperseded) {
  for (const double points : {9.0, 8.0})
    ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "depth_most", points, "Looked at again."));
  ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "target_removed", 19, "Another criterion."));
  const ReportData data = gathered(lena);
  ASSERT_EQ(data.remarks.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(data.remarks[i].superseded, i == 0) << i;
    EXPECT_EQ(data.remarks[i].what.contains(QStringLiteral("superseded")), i == 0) << data.remarks[i].what.toStdString();
  }
  ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  page.resize(1280, 800);
  leave_picture(page, QStringLiteral("superseded"));
  int dimmed = 0;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    if (!label->text().contains(QStringLiteral("<b>Dr Berg</b>"))) continue;
    const bool old = label->text().contains(QStringLiteral("superseded"));
    EXPECT_EQ(label->property("ink").toString() == QStringLiteral("text3"), old);
    EXPECT_TRUE(label->text().contains(QStringLiteral(" 2026, "))) << label->text().toStdString();
    dimmed += old;
  }
  EXPECT_EQ(dimmed, 1);
}

TEST_F(Marking, AChangeToTheFigureThatStandsAlreadyIsRefused) {
  Grade grade = sample_grade(40);
  grade.criteria[0].points = grade.criteria[0].points_max = 90;
  grade.criteria[1].points = 4.04;  // the field shows 4.0
  session = records.graded_attempt(lena, "channel-1", grade, 90);
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  QSignalSpy stated(&card, &MarkingCard::stated);
  card.set_criterion(&grade.criteria[1]);
  say(card, "The block was worn.");
  button(card, "Change points")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("count already"))) << message(card).toStdString();
  EXPECT_EQ(stated.count(), 0);
  card.findChild<NumberField*>()->setValue(4.1);
  button(card, "Change points")->click();
  EXPECT_EQ(stated.count(), 1) << message(card).toStdString();
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
  say(card, "");
  button(card, "Take back")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("Write the reason below."))) << message(card).toStdString();
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

TEST_F(Marking, AnActThatTakesNoTextKeepsTheOneThatIsBeingWritten) {
  ASSERT_FALSE(gathered(examiner).counts->grade.passed) << "only a failed practice is confirmed";
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  say(card, "The wall is even, the floor is not.");
  EXPECT_TRUE(card.unsaved());
  button(card, "Confirm the result")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("confirmed"))) << message(card).toStdString();
  EXPECT_EQ(card.findChild<QPlainTextEdit*>()->toPlainText(), QStringLiteral("The wall is even, the floor is not."));
  button(card, "Add comment")->click();
  EXPECT_FALSE(card.unsaved());
  EXPECT_EQ(gathered(lena).remarks.size(), 1u);
}

TEST_F(Marking, LeavingThePageAsksWhileATextIsNotKept) {
  bool leave = false;
  int asked = 0;
  ports.ask = [&](QWidget*, const Question&, const std::function<void(bool)>& then) {
    ++asked;
    then(leave);
  };
  ReportPage page(gathered(examiner), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  auto* card = new MarkingCard(records.store(), examiner.actor(), page.data(), ports);
  page.set_card(card);
  QSignalSpy back(&page, &ReportPage::back_wanted);
  say(*card, "The wall is even.");
  button(page, "Back")->click();
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(back.count(), 0);
  leave = true;
  button(page, "Back")->click();
  EXPECT_EQ(back.count(), 1);
  say(*card, "");
  button(page, "Back")->click();
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(back.count(), 2);
}

/// The weights of a rubric that sums to 110: points of the score's maximum have more decimals than the field.
TEST_F(Marking, FullPointsCanBeGivenWhateverTheirDecimals) {
  for (const double most : {1000.0 / 110, 500.0 / 110}) {  // 9.0909 and 4.5454: shown as 9.1 and 4.5
    Grade grade = sample_grade(40);
    grade.criteria[0].points = grade.criteria[0].points_max = 100 - most;
    grade.criteria[1].points_max = most;
    grade.criteria[1].points = 1;
    session = records.graded_attempt(lena, "channel-1", grade, 90);
    MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
    card.set_criterion(&grade.criteria[1]);
    card.findChild<NumberField*>()->setValue(most + 1);
    say(card, "The block was worn.");
    button(card, "Change points")->click();
    const CriterionGrade changed = criterion_in(gathered(examiner), "depth_most");
    EXPECT_DOUBLE_EQ(changed.points, most) << message(card).toStdString();
    EXPECT_EQ(changed.reason_code, "full");
  }
}

TEST_F(Marking, ACriterionWithoutPointsHasNoneToChange) {
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  CriterionGrade criterion = criterion_in(gathered(examiner), "depth_most");
  card.set_criterion(&criterion);
  EXPECT_TRUE(button(card, "Change points")->isEnabled());
  criterion.points = criterion.points_max = 0;
  card.set_criterion(&criterion);
  EXPECT_FALSE(button(card, "Change points")->isEnabled());
  EXPECT_FALSE(card.findChild<NumberField*>()->isEnabled());
}

TEST_F(Marking, ARemarkKeepsItsLines) {
  ReportData data = gathered(lena);
  data.remarks.push_back({Uuid::v7(), QStringLiteral("Dr Berg"), data.when, {}, QStringLiteral("First the floor.\nThen <the> wall."), std::nullopt});
  ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  QString shown;
  for (const QLabel* label : page.findChildren<QLabel*>())
    if (label->text().contains(QStringLiteral("Dr Berg"))) shown = label->text();
  EXPECT_TRUE(shown.contains(QStringLiteral("First the floor.<br>Then &lt;the&gt; wall."))) << shown.toStdString();
}

TEST_F(Marking, TheKeyboardFollowsReadingBeforeAndAfterAStatement) {
  ReportPage page(gathered(examiner), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  auto* card = new MarkingCard(records.store(), examiner.actor(), page.data(), ports);
  page.set_card(card);
  const auto place = [&](const QWidget* of) {
    int steps = 0;
    for (const QWidget* at = &page; at != of && steps < 1000; at = at->nextInFocusChain()) ++steps;
    return steps;
  };
  const QPushButton* fold = button(*card, "Mark this attempt");
  EXPECT_EQ(page.focusProxy(), page.table());
  EXPECT_LT(place(fold), place(page.table()));
  ReportData with_place = gathered(examiner);
  with_place.remarks.push_back({Uuid::v7(), QStringLiteral("Dr Berg"), with_place.when, {}, QStringLiteral("Here."), Vec3(0.0)});
  page.show_data(with_place);
  EXPECT_EQ(page.focusProxy(), page.table());
  const QPushButton* shown = button(page, "Show the place");
  EXPECT_EQ(shown->accessibleDescription(), QStringLiteral("Here.")) << "of several remarks each";
  EXPECT_LT(place(shown), place(fold));
  EXPECT_LT(place(fold), place(page.table()));
}

TEST_F(Marking, AResultThatAnotherDeskChangedIsNotConfirmedUnseen) {
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  QSignalSpy stated(&card, &MarkingCard::stated);
  ASSERT_TRUE(records.store().statements.override_points(examiner.actor(), session, "depth_most", 1, "Looked at again."));
  button(card, "Confirm the result")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("at another desk"))) << message(card).toStdString();
  EXPECT_FALSE(gathered(examiner).counts->confirmation);
  EXPECT_EQ(stated.count(), 1) << "the report is read anew";
  card.show_data(gathered(examiner));
  button(card, "Confirm the result")->click();
  EXPECT_TRUE(gathered(examiner).counts->confirmation) << message(card).toStdString();
}

TEST_F(Marking, AResultThatWasGradedAnewIsNotConfirmedUnseen) {
  MarkingCard card(records.store(), examiner.actor(), gathered(examiner), ports);
  ASSERT_TRUE(records.store().grades.save(session, sample_grade(10), Hash256{}));
  button(card, "Confirm the result")->click();
  EXPECT_TRUE(message(card).contains(QStringLiteral("at another desk"))) << message(card).toStdString();
  EXPECT_FALSE(gathered(examiner).counts->confirmation);
}

}  // namespace
}  // namespace cusp::test
