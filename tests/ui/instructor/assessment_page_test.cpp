// The candidates of an assessment: without names, their results, and their release.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/whole_texts.h"
#include "ui/instructor/assessment_page.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

class Candidates : public testing::Test {
 protected:
  Candidates() {
    lena = records.student("4711", "Lena Brandt");
    omar = records.student("4712", "Omar Said");
    ida = records.student("4713", "Ida Berg");
    examiner = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    const Cohort cohort = *records.store().cohorts.create(examiner, "Year 3");
    for (const Account& student : {lena, omar, ida}) EXPECT_TRUE(records.store().cohorts.add(examiner, cohort.id, student.id));
    const Scenario scenario = *load_builtin("channel-1");
    const auto version = records.store().scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes);
    assignment = *records.store().assignments.create(
        examiner, {.version = version->id, .cohort = cohort.id, .kind = SessionKind::assessment}, "4711");
    passed = sit(lena, 80);
    failed = sit(omar, 40);
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked = question.what;
      then(true);
    };
  }
  SessionId sit(const Account& student, double score) { return sit_graded(student, sample_grade(score)); }
  SessionId sit_graded(const Account& student, const Grade& grade) {
    NewSession wanted{.student = student.id, .version = assignment.version, .kind = SessionKind::assessment, .assignment = assignment.id};
    wanted.start_code = "4711";
    wanted.header.device.device_class = "pointer";
    wanted.header.scene = "{}";
    const SessionId id = records.store().sessions.start(student.actor(), wanted)->id;
    EXPECT_TRUE(records.store().sessions.interrupt(id, "left"));
    EXPECT_TRUE(records.store().grades.save(id, grade, Hash256{}));
    return id;
  }
  const CandidateRow& row_of(const AssessmentPage& page, const Account& student) {
    int at = 0;
    for (int i = 0; i < page.model().rowCount(); ++i)
      if (page.model().row(i).student == student.id) at = i;
    return page.model().row(at);
  }
  bool released(SessionId session) { return records.store().history.details(examiner, session)->row.released; }

  DeskRecords records;
  Account lena, omar, ida;
  Actor examiner;
  Assignment assignment;
  SessionId passed, failed;
  Ports ports;
  QString asked;
};

TEST_F(Candidates, ButtonOfTheGradebookHasRoomForItsText) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  page.show();
  int with_menu = 0;
  for (const QPushButton* button : page.findChildren<QPushButton*>()) {
    if (!button->isVisible() || button->layout() == nullptr) continue;
    ++with_menu;
    EXPECT_EQ(button->accessibleName(), QStringLiteral("Gradebook"));
    EXPECT_GE(button->width(), button->layout()->sizeHint().width());
    EXPECT_GT(button->width(), button->fontMetrics().horizontalAdvance(button->accessibleName()));
  }
  EXPECT_EQ(with_menu, 1);
}

TEST_F(Candidates, OfALongExerciseAndCohortHaveAPageAsWideAsItsWindow) {
  const QString name = QString(QStringLiteral("Class II cavity with two boxes ")).repeated(6).trimmed();
  const Cohort cohort = *records.store().cohorts.create(examiner, name.toStdString());
  ASSERT_TRUE(records.store().cohorts.add(examiner, cohort.id, lena.id));
  Scenario scenario = *load_builtin("channel-1");
  scenario.version += 1;
  for (auto& [language, title] : scenario.title) title = name.toStdString();
  const auto version = records.store().scenarios.publish(examiner, scenario, canonical_json(scenario), content_hash(scenario).bytes);
  ASSERT_TRUE(version);
  const auto of_long = records.store().assignments.create(
      examiner, {.version = version->id, .cohort = cohort.id, .kind = SessionKind::assessment, .device_classes = {"falcon"}}, "4711");
  ASSERT_TRUE(of_long);
  AssessmentPage page(records.store(), examiner, of_long->id, ports);
  page.resize(853, 533);  // 1280 x 800 at 150 %
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.width(), 853);
  expect_nothing_clipped(page, "candidates");
}

TEST_F(Candidates, AreListedByNumberWithoutNamesAndWhoHasNotBegunToo) {
  const AssessmentPage page(records.store(), examiner, assignment.id, ports);
  ASSERT_EQ(page.model().rowCount(), 3);
  EXPECT_TRUE(page.table()->isColumnHidden(CandidatesModel::kName));
  EXPECT_FALSE(row_of(page, ida).attempt);
  EXPECT_EQ(row_of(page, lena).candidate.toStdString(), candidate_number(assignment.id, lena.id));
  for (int i = 0; i + 1 < 3; ++i) EXPECT_LT(page.model().row(i).candidate, page.model().row(i + 1).candidate);
}

TEST_F(Candidates, ReceiveTheirResultsTogetherButForUnconfirmedFails) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  page.release_all();
  EXPECT_TRUE(asked.contains(QStringLiteral("1")));
  EXPECT_TRUE(released(passed));
  EXPECT_FALSE(released(failed));
  EXPECT_TRUE(page.message().contains(QStringLiteral("wait"))) << page.message().toStdString();
  ASSERT_TRUE(records.store().statements.confirm(examiner, failed));
  AssessmentPage again(records.store(), examiner, assignment.id, ports);
  again.release_all();
  EXPECT_TRUE(released(failed));
}

TEST_F(Candidates, ReceiveAnAdjustmentThatShowsBesideTheirNumber) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  for (int i = 0; i < 3; ++i)
    if (page.model().row(i).student == ida.id) page.table()->choose_row(i);
  const Adjustment both{.extra_time_percent = 25, .large_text = true};
  page.adjust(both);
  EXPECT_EQ(row_of(page, ida).adjustment, both);
  EXPECT_EQ(row_of(page, omar).adjustment, Adjustment{});
  EXPECT_EQ(*records.store().assignments.adjustment(assignment.id, ida.id), both);
  EXPECT_TRUE(page.message().contains(QStringLiteral("25 % more time, large text"))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(row_of(page, ida).candidate)) << page.message().toStdString();
  page.adjust({.extra_time_percent = 401});
  EXPECT_EQ(row_of(page, ida).adjustment, both);
}

TEST_F(Candidates, WhoseAdjustmentsCannotBeReadAreNotListedAsHavingNone) {
  ASSERT_TRUE(records.store().assignments.adjust(examiner, assignment.id, lena.id, {25, false}));
  ASSERT_TRUE(records.store().database().run("DROP INDEX adjustments_of_assignment"));  // no extra time is found without it
  const AssessmentPage page(records.store(), examiner, assignment.id, ports);
  EXPECT_NE(page.message(), QString());
  EXPECT_EQ(page.model().rowCount(), 0);
}

TEST_F(Candidates, WhoseMarksCannotBeReadSaySoInTheirRow) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  const auto marked = [&](int row) { return page.model().index(row, CandidatesModel::kMarked).data().toString(); };
  const auto unread = [&] {
    int rows = 0;
    for (int i = 0; i < page.model().rowCount(); ++i) rows += marked(i) == QStringLiteral("could not be read") ? 1 : 0;
    return rows;
  };
  page.show();
  EXPECT_EQ(unread(), 0);
  ASSERT_TRUE(records.store().database().run("ALTER TABLE removed_tissues RENAME TO lost_tissues"));
  page.hide();
  page.show();
  EXPECT_EQ(page.model().rowCount(), 3);
  EXPECT_EQ(unread(), 2) << "the third has not begun";
}

TEST_F(Candidates, OfAnAssignmentThatCannotBeReadAreNotCalledNone) {
  const AssessmentPage page(records.store(), examiner, AssignmentId::make(), ports);
  EXPECT_NE(page.message(), QString());
}

TEST_F(Candidates, KeepAnAdjustmentThatAnotherDeskMadeMeanwhile) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  for (int i = 0; i < 3; ++i)
    if (page.model().row(i).student == ida.id) page.table()->choose_row(i);
  const Adjustment theirs{.extra_time_percent = 25}, both{.extra_time_percent = 25, .large_text = true};
  ASSERT_TRUE(records.store().assignments.adjust(examiner, assignment.id, ida.id, theirs));
  page.adjust({.large_text = true});  // as the page shows it: no extra time
  EXPECT_EQ(*records.store().assignments.adjustment(assignment.id, ida.id), theirs);
  EXPECT_EQ(row_of(page, ida).adjustment, theirs);
  EXPECT_TRUE(page.message().contains(QStringLiteral("at another desk meanwhile"))) << page.message().toStdString();
  EXPECT_EQ(page.model().row(page.table()->chosen_row()).student, ida.id);
  page.adjust(both);
  EXPECT_EQ(*records.store().assignments.adjustment(assignment.id, ida.id), both);
}

TEST_F(Candidates, WhoseAdjustmentIsNotKeptYetAreAskedAboutBeforeAnotherOneIsShownOrThePageIsLeft) {
  int questions = 0;
  bool answer = false;
  ports.ask = [&](QWidget*, const Question& question, std::function<void(bool)> then) {
    ++questions;
    asked = question.what;
    then(answer);
  };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  QSignalSpy back(&page, &AssessmentPage::back_wanted);
  page.show();
  page.table()->choose_row(0);
  auto* extra = page.findChild<NumberField*>();
  ASSERT_NE(extra, nullptr);
  EXPECT_FALSE(page.half_filled());
  extra->setValue(25);
  EXPECT_TRUE(page.half_filled());
  page.hide();
  page.show();  // as after a report: the candidates are read anew
  EXPECT_DOUBLE_EQ(extra->value(), 25);
  EXPECT_EQ(questions, 0);
  page.table()->choose_row(1);
  EXPECT_EQ(asked, QStringLiteral("Leave without saving the form?"));
  EXPECT_EQ(page.table()->chosen_row(), 0);
  EXPECT_DOUBLE_EQ(extra->value(), 25);
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Back")) button->click();
  EXPECT_EQ(questions, 2);
  EXPECT_EQ(back.count(), 0);
  answer = true;
  page.table()->choose_row(1);
  EXPECT_EQ(page.table()->chosen_row(), 1);
  EXPECT_DOUBLE_EQ(extra->value(), 0);
  EXPECT_FALSE(page.half_filled());
  EXPECT_EQ(*records.store().assignments.adjustment(assignment.id, page.model().row(0).student), Adjustment{});
}

TEST_F(Candidates, WhoseExtraTimeIsBeingTypedAreAskedAboutBeforeAShortcutLeavesThePage) {
  ports.ask = [this](QWidget*, const Question& question, const std::function<void(bool)>&) { asked = question.what; };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  QSignalSpy back(&page, &AssessmentPage::back_wanted);
  page.show();
  page.table()->choose_row(0);
  page.findChild<NumberField*>()->findChild<QLineEdit*>()->setText(QStringLiteral("25"));
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Back")) button->click();  // which leaves the focus where it is
  EXPECT_EQ(asked, QStringLiteral("Leave without saving the form?"));
  EXPECT_EQ(back.count(), 0);
}

TEST_F(Candidates, WhoLeftTheCohortReceiveNoAdjustmentAndTheExaminerReadsWhy) {
  ASSERT_TRUE(records.store().cohorts.remove(examiner, assignment.cohort, omar.id));
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  for (int i = 0; i < page.model().rowCount(); ++i)
    if (page.model().row(i).student == omar.id) page.table()->choose_row(i);
  page.adjust({.extra_time_percent = 25});
  EXPECT_EQ(row_of(page, omar).adjustment, Adjustment{});
  EXPECT_EQ(page.message().toStdString(), row_of(page, omar).candidate.toStdString() + " is no longer in the cohort. Nothing was changed.");
}

TEST_F(Candidates, GoToAGradebookWithTheirReleasedResults) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("out.csv"));
  ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  ports.pick_file = [&](QWidget*, const FileWish& wish, const std::function<void(const QString&)>& then) {
    EXPECT_TRUE(wish.name.startsWith(QStringLiteral("canvas-"))) << wish.name.toStdString();
    then(path);
  };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  page.release_all();
  page.export_gradebook(Gradebook::canvas);
  EXPECT_TRUE(page.message().contains(QStringLiteral("1 result"))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(QStringLiteral("1 result waits for release"))) << page.message().toStdString();
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().startsWith("Student,ID,SIS User ID"));
}

TEST_F(Candidates, WhoFailedWithEnoughPointsToPassAreCountedWithTheGradebook) {
  Grade exposed = sample_grade(90);
  exposed.passed = false;
  exposed.critical = {"pulp_exposure"};
  const SessionId id = sit_graded(ida, exposed);
  ASSERT_TRUE(records.store().statements.confirm(examiner, id));
  ASSERT_TRUE(records.store().statements.release(examiner, id));
  const QTemporaryDir folder;
  ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(folder.filePath(QStringLiteral("out.csv"))); };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  page.export_gradebook(Gradebook::moodle);
  EXPECT_TRUE(page.message().contains(QStringLiteral("1 of them failed by a critical event"))) << page.message().toStdString();
}

TEST_F(Candidates, AreNoExportInTheLogBeforeAFileIsChosen) {
  const QTemporaryDir folder;
  QString path;
  ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) {
    if (!path.isEmpty()) then(path);
  };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  const auto exports = [&] { return records.store().audit.list(records.administrator().actor(), 10, INT64_MAX, {.actions = {"gradebook_exported"}})->size(); };
  page.export_gradebook(Gradebook::moodle);
  EXPECT_EQ(exports(), 0u) << "the file picker was cancelled";
  path = folder.filePath(QStringLiteral("out.csv"));
  page.export_gradebook(Gradebook::moodle);
  EXPECT_EQ(exports(), 1u);
  EXPECT_TRUE(QFile::exists(path));
}

TEST_F(Candidates, AreNoExportInTheLogWhereTheFileWasNotWrittenAndInNoFileWhereTheLogRefuses) {
  const QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("none/out.csv"));
  ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  ports.pick_file = [&](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(path); };
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  const auto exports = [&] { return records.store().audit.list(records.administrator().actor(), 10, INT64_MAX, {.actions = {"gradebook_exported"}})->size(); };
  page.export_gradebook(Gradebook::moodle);
  EXPECT_TRUE(page.message().contains(QStringLiteral("The file was not written."))) << page.message().toStdString();
  EXPECT_EQ(exports(), 0u);
  path = folder.filePath(QStringLiteral("out.csv"));
  ASSERT_TRUE(records.store().accounts.disable(records.administrator().actor(), examiner.id));  // at another desk
  page.export_gradebook(Gradebook::moodle);
  EXPECT_TRUE(page.message().contains(QStringLiteral("Your account is switched off."))) << page.message().toStdString();
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
  EXPECT_EQ(exports(), 0u);
}

TEST_F(Candidates, AreReleasedThoughAnotherDeskReleasedOrConfirmedSomeMeanwhile) {
  const SessionId third = sit(ida, 90);
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  // Both come from another desk while the question is open here.
  ports.ask = [&](QWidget*, const Question&, std::function<void(bool)> then) {
    EXPECT_TRUE(records.store().statements.release(examiner, passed));
    EXPECT_TRUE(records.store().statements.confirm(examiner, failed));
    then(true);
  };
  page.release_all();
  EXPECT_TRUE(released(passed));
  EXPECT_TRUE(released(third));
  EXPECT_TRUE(released(failed)) << "confirmed meanwhile";
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("2 results released."))) << page.message().toStdString();
}

TEST_F(Candidates, WhoBecameExaminersReleaseTheOthersAndNotThemselves) {
  const SessionId third = sit(ida, 90);
  ASSERT_TRUE(records.store().accounts.set_password(records.administrator().actor(), ida.id, {}, "correct horse"));
  ASSERT_TRUE(records.store().accounts.set_role(records.administrator().actor(), ida.id, Role::instructor));
  AssessmentPage page(records.store(), {ida.id, Role::instructor}, assignment.id, ports);
  page.release_all();
  EXPECT_TRUE(asked.contains(QStringLiteral("1 result"))) << asked.toStdString();
  EXPECT_TRUE(released(passed));
  EXPECT_FALSE(released(third));
}

TEST_F(Candidates, StayChosenWhenAnotherAttemptComesAboveThem) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  page.show();
  page.table()->choose_row(2);
  const UserId chosen = page.model().row(2).student;
  page.hide();
  const UserId first = page.model().row(0).student;
  for (int again = 0; again < 2; ++again) sit(first == lena.id ? lena : first == omar.id ? omar : ida, 50);
  page.show();
  EXPECT_EQ(page.model().row(page.table()->chosen_row()).student, chosen);
}

TEST_F(Candidates, WhoDrillsNowHasNoReportYet) {
  NewSession wanted{.student = ida.id, .version = assignment.version, .kind = SessionKind::assessment, .assignment = assignment.id};
  wanted.start_code = "4711";
  wanted.header.device.device_class = "pointer";
  wanted.header.scene = "{}";
  ASSERT_TRUE(records.store().sessions.start(ida.actor(), wanted));
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  QSignalSpy opened(&page, &AssessmentPage::report_wanted);
  for (int i = 0; i < page.model().rowCount(); ++i) {
    const bool way_in = page.model().row(i).student != ida.id;
    EXPECT_EQ(page.model().index(i, CandidatesModel::kOpen).data(IconRole).isValid(), way_in);
    page.table()->choose_row(i);
    Q_EMIT page.table()->row_opened(page.model().index(i, 0));
  }
  EXPECT_EQ(opened.count(), 2);
}

TEST_F(Candidates, OpenTheirReport) {
  AssessmentPage page(records.store(), examiner, assignment.id, ports);
  QSignalSpy opened(&page, &AssessmentPage::report_wanted);
  for (int i = 0; i < 3; ++i) {
    page.table()->choose_row(i);
    Q_EMIT page.table()->row_opened(page.model().index(i, 0));
  }
  EXPECT_EQ(opened.count(), 2) << "who has not begun has no report";
}

}  // namespace
}  // namespace cusp::test
