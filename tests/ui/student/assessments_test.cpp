// A student's assessments: their state, the start code, and that no result shows before its release.
#include <gtest/gtest.h>

#include <algorithm>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/assessments.h"
#include "ui/text/failure_text.h"
#include "ui/text/plain.h"
#include "ui/student/course.h"

namespace cusp::test {
namespace {

using State = AssignedAssessment::State;
constexpr std::int64_t kHour = 3'600'000'000;

class Assessments : public testing::Test {
 protected:
  Assessments() {
    lena = records.student("4711", "Lena Brandt");
    examiner = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    const Cohort cohort = *records.store().cohorts.create(examiner, "Year 3");
    EXPECT_TRUE(records.store().cohorts.add(examiner, cohort.id, lena.id));
    const Scenario scenario = *load_builtin("channel-1");
    const auto version = records.store().scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes);
    Assignment a{.version = version->id, .cohort = cohort.id, .kind = SessionKind::assessment};
    a.opens_utc_us = kMorning;
    a.due_utc_us = kMorning + kHour;
    a.attempts_allowed = 1;
    assignment = *records.store().assignments.create(examiner, a, "4711");
  }
  std::vector<AssignedAssessment> at(std::int64_t utc_us, const std::string& device_class = "pointer") {
    return load_assessments(records.store(), lena.actor(), QDateTime::fromMSecsSinceEpoch(utc_us / 1000), device_class)->shown;
  }
  /// The exercise with a time limit, as its next version.
  Stored<ScenarioVersion> publish_newer() {
    Scenario newer = *load_builtin("channel-1");
    newer.version += 1;
    newer.time_limit_s = 600;
    return records.store().scenarios.publish(examiner, newer, canonical_json(newer), content_hash(newer).bytes);
  }
  SessionId sit() {
    NewSession wanted{.student = lena.id, .version = assignment.version, .kind = SessionKind::assessment, .assignment = assignment.id};
    wanted.start_code = "4711";
    wanted.header.device.device_class = "pointer";
    wanted.header.scene = "{}";
    return records.store().sessions.start(lena.actor(), wanted)->id;
  }

  DeskRecords records;
  Account lena;
  Actor examiner;
  Assignment assignment;
};

TEST_F(Assessments, AreLaterThenOpenThenMissed) {
  EXPECT_EQ(at(kMorning - kHour).at(0).state, State::later);
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::open);
  EXPECT_EQ(at(kMorning + kHour).at(0).state, State::missed);
  EXPECT_TRUE(at(kMorning + 31 * 24 * kHour).empty()) << "a month later nobody asks for it";
}

TEST_F(Assessments, ThatCanBeSatStandBeforeThoseThatAreOver) {
  Assignment later{.version = assignment.version, .cohort = assignment.cohort, .kind = SessionKind::assessment};
  later.due_utc_us = kMorning + 9 * kHour;
  later.id = records.store().assignments.create(examiner, later, "4712")->id;
  const auto all = at(kMorning + 2 * kHour);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].assignment.id, later.id);
  EXPECT_EQ(all[1].state, State::missed);
}

TEST_F(Assessments, AreInterruptedThenHandedInAndLeaveTheStartPageWithTheirRelease) {
  const SessionId session = sit();
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::running);
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::interrupted);
  ASSERT_TRUE(records.store().grades.save(session, sample_grade(80), Hash256{}));
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::handed_in);
  EXPECT_EQ(at(kMorning + 2 * kHour).at(0).state, State::handed_in);
  const auto row = records.store().history.list(lena.actor())->front();
  EXPECT_EQ(result_text(row), QStringLiteral("Not released"));
  ASSERT_TRUE(records.store().statements.release(examiner, session));
  EXPECT_TRUE(at(kMorning + 1000).empty());
  EXPECT_EQ(result_text(records.store().history.list(lena.actor())->front()), QStringLiteral("Passed"));
}

TEST_F(Assessments, OnceHandedInTheNextCandidateHasTheOnePrimaryButtonAndTheWayHomeStandsBelowIt) {
  HandedIn page(QStringLiteral("W7C UPT"));
  page.resize(1280, 720);
  page.show();
  QTest::qWait(0);
  const QPushButton *next = nullptr, *home = nullptr;
  for (const QPushButton* button : page.findChildren<QPushButton*>()) (button->property("kind") == QStringLiteral("primary") ? next : home) = button;
  ASSERT_NE(next, nullptr);
  ASSERT_NE(home, nullptr);
  EXPECT_EQ(next->accessibleName().toStdString(), "Next candidate");
  EXPECT_LE(home->mapTo(&page, QPoint()).y() - next->mapTo(&page, QPoint(0, next->height())).y(), 40);
}

TEST_F(Assessments, OfferTheirStartOnlyWhileOpen) {
  EXPECT_EQ(AssessmentCard(at(kMorning - kHour)[0], lena.id, "pointer").start_button(), nullptr);
  EXPECT_NE(AssessmentCard(at(kMorning + 1000)[0], lena.id, "pointer").start_button(), nullptr);
}

TEST_F(Assessments, NameTheDevicesThatTheyAdmitAndStartWithNoOther) {
  Assignment a = assignment;
  a.device_classes = {"falcon", "inverse3"};
  a = *records.store().assignments.create(examiner, a, "4711");
  const auto with = [&](const std::string& device_class) {
    for (const AssignedAssessment& one : at(kMorning + 1000, device_class))
      if (one.assignment.id == a.id) return one;
    return AssignedAssessment{};
  };
  EXPECT_EQ(with("falcon").state, State::open);
  EXPECT_EQ(with("pointer").state, State::other_device);
  const AssessmentCard card(with("pointer"), lena.id, "pointer");
  EXPECT_EQ(card.start_button(), nullptr);
  QStringList texts;
  for (const QLabel* label : card.findChildren<QLabel*>()) texts += label->text();
  EXPECT_TRUE(texts.join(u'|').contains(QStringLiteral("only with Falcon, Inverse3"))) << texts.join(u'|').toStdString();
  // Whoever changes the device after the page was drawn reads why.
  QWidget window;
  auto* question = new AssessmentStart(records.store(), lena.actor(), with("falcon"), "pointer", AssessmentStart::Purpose::start, &window);
  question->findChild<QLineEdit*>()->setText(QStringLiteral("4711"));
  for (QPushButton* b : question->findChildren<QPushButton*>())
    if (b->text() == QStringLiteral("Begin")) b->click();
  EXPECT_TRUE(question->findChild<Band*>()->text().contains(QStringLiteral("needs another device")));
}

TEST_F(Assessments, AskForASelfTestOfTheDeviceInOneSentence) {
  Assignment a = assignment;
  a.self_test_days = 7;
  a = *records.store().assignments.create(examiner, a, "4711");
  const auto with = [&](const std::string& device_class) {
    for (const AssignedAssessment& one : at(kMorning + 1000, device_class))
      if (one.assignment.id == a.id) return one;
    return AssignedAssessment{};
  };
  const auto card_text = [&](const std::string& device_class) {
    const AssessmentCard card(with(device_class), lena.id, device_class);
    EXPECT_EQ(card.start_button() != nullptr, with(device_class).state == State::open);
    QStringList texts;
    for (const QLabel* label : card.findChildren<QLabel*>()) texts += label->text();
    return texts.join(u'|');
  };
  EXPECT_EQ(with("falcon").state, State::self_test_due);
  EXPECT_TRUE(card_text("falcon").contains(QStringLiteral("Ask the staff for a self-test of the Falcon on the page Device.")));
  EXPECT_TRUE(card_text("falcon").contains(QStringLiteral("self-test at most 7 days old"))) << card_text("falcon").toStdString();
  EXPECT_TRUE(card_text("pointer").contains(QStringLiteral("Mouse and keys: there is no self-test.")));
  ASSERT_TRUE(records.store().device_tests.add(examiner, {.device_class = "falcon", .device = "FT1"}));
  EXPECT_EQ(with("falcon").state, State::open);
  EXPECT_FALSE(card_text("falcon").contains(QStringLiteral("Ask the staff")));
  QWidget window;
  auto* question = new AssessmentStart(records.store(), lena.actor(), with("falcon"), "pointer", AssessmentStart::Purpose::start, &window);
  question->findChild<QLineEdit*>()->setText(QStringLiteral("4711"));
  for (QPushButton* b : question->findChildren<QPushButton*>())
    if (b->text() == QStringLiteral("Begin")) b->click();
  EXPECT_TRUE(question->findChild<Band*>()->text().contains(QStringLiteral("newer self-test of the device")));
}

TEST_F(Assessments, CountTheAttemptsUsedAlsoOfOne) {
  QStringList texts;
  const AssessmentCard card(at(kMorning + 1000)[0], lena.id, "pointer");
  for (const QLabel* label : card.findChildren<QLabel*>()) texts += label->text();
  EXPECT_TRUE(texts.join(u'|').contains(QStringLiteral("Attempts used: 0 of 1"))) << texts.join(u'|').toStdString();
}

TEST_F(Assessments, SayThatEachCandidateHasAnotherTooth) {
  AssignedAssessment one = at(kMorning + 1000)[0];
  const auto texts = [](const QWidget& widget) {
    QStringList out;
    for (const QLabel* label : widget.findChildren<QLabel*>()) out += label->text();
    return out.join(u'|');
  };
  const QString words = QStringLiteral("another tooth for each candidate"), drawn = QStringLiteral("Your tooth is drawn for you");
  QWidget window;
  EXPECT_FALSE(texts(AssessmentCard(one, lena.id, "pointer")).contains(words));
  EXPECT_FALSE(texts(*new AssessmentStart(records.store(), lena.actor(), one, "pointer", AssessmentStart::Purpose::start, &window)).contains(drawn));
  one.assignment.drawn_tooth = true;
  EXPECT_TRUE(texts(AssessmentCard(one, lena.id, "pointer")).contains(words));
  EXPECT_TRUE(texts(*new AssessmentStart(records.store(), lena.actor(), one, "pointer", AssessmentStart::Purpose::start, &window)).contains(drawn));
}

TEST_F(Assessments, NameTheTimeLimitWithTheStudentsExtraTime) {
  AssignedAssessment one = at(kMorning + 1000)[0];
  one.exercise.scenario.time_limit_s = 600;
  EXPECT_EQ(plain(time_limit_text(one)), "10:00 min");
  ASSERT_TRUE(records.store().assignments.adjust(examiner, one.assignment.id, lena.id, {.extra_time_percent = 25}));
  one.adjustment = at(kMorning + 1000)[0].adjustment;
  EXPECT_EQ(plain(time_limit_text(one)), "12:30 min (25 % extra time)");
  one.exercise.scenario.time_limit_s = 3600;
  EXPECT_EQ(plain(time_limit_text(one)), "1:15:00 h (25 % extra time)");
  one.exercise.scenario.time_limit_s = 0;
  EXPECT_TRUE(time_limit_text(one).isEmpty());
}

TEST_F(Assessments, BeginWithTheStartCodeAlone) {
  QWidget window;
  auto* question = new AssessmentStart(records.store(), lena.actor(), at(kMorning + 1000)[0], "pointer", AssessmentStart::Purpose::start, &window);
  QSignalSpy admitted(question, &AssessmentStart::admitted);
  QPushButton* begin = nullptr;
  for (QPushButton* b : question->findChildren<QPushButton*>())
    if (b->text() == QStringLiteral("Begin")) begin = b;
  question->findChild<QLineEdit*>()->setText(QStringLiteral("4712"));
  begin->click();
  EXPECT_TRUE(question->findChild<Band*>()->text().contains(QStringLiteral("not the start code")));
  EXPECT_EQ(admitted.count(), 0);
  question->findChild<QLineEdit*>()->setText(QStringLiteral(" 4711 "));
  begin->click();
  ASSERT_EQ(admitted.count(), 1);
  EXPECT_EQ(admitted[0][0].toString(), QStringLiteral("4711"));
}

TEST_F(Assessments, ContinueWithTheStartCodeThoughTimeAttemptsAndDeviceAdmitNoNewOne) {
  Assignment a = assignment;
  a.device_classes = {"pointer"};
  a = assignment = *records.store().assignments.create(examiner, a, "4711");
  ASSERT_TRUE(records.store().sessions.interrupt(sit(), "left"));
  AssignedAssessment one = at(kMorning + 1000)[0];
  one.assignment = a;
  using Purpose = AssessmentStart::Purpose;
  const auto shown = [&](Purpose purpose, const QString& code, const std::string& device_class) {
    QWidget window;
    auto* question = new AssessmentStart(records.store(), lena.actor(), one, device_class, purpose, &window);
    QSignalSpy admitted(question, &AssessmentStart::admitted);
    question->findChild<QLineEdit*>()->setText(code);
    for (QPushButton* b : question->findChildren<QPushButton*>())
      if (b->text() == (purpose == Purpose::start ? QStringLiteral("Begin") : QStringLiteral("Continue"))) b->click();
    return admitted.count() == 1 ? QStringLiteral("admitted") : question->findChild<Band*>()->text();
  };
  const QString right = QStringLiteral("4711"), wrong = QStringLiteral("4712"), admitted = QStringLiteral("admitted");
  EXPECT_TRUE(shown(Purpose::start, right, "pointer").contains(QStringLiteral("Every attempt")));
  for (const std::int64_t later_us : {std::int64_t{0}, 2 * kHour}) {
    records.now_us = kMorning + later_us;
    EXPECT_TRUE(shown(Purpose::resume, wrong, "pointer").contains(QStringLiteral("not the start code")));
    EXPECT_EQ(shown(Purpose::resume, right, "pointer"), admitted);
    EXPECT_EQ(shown(Purpose::resume, right, "falcon"), admitted);
  }
}

TEST_F(Assessments, AnAssignedPracticeStaysDueInItsVersionWhenANewerOneIsPublished) {
  const Assignment practice = *records.store().assignments.create(
      examiner, {.version = assignment.version, .cohort = assignment.cohort, .due_utc_us = kMorning + kHour});
  ASSERT_TRUE(publish_newer());
  const Course course = *load_course(records.store(), lena.actor());
  const auto row = std::ranges::find_if(course.rows, [](const CourseRow& r) { return r.assignment.has_value(); });
  ASSERT_NE(row, course.rows.end());
  EXPECT_EQ(row->assignment, practice.id);
  EXPECT_EQ(row->exercise.version, assignment.version);
}

TEST_F(Assessments, APracticeThatIsAssignedAgainIsDueByItsNewDayInItsNewVersion) {
  const auto version = publish_newer();
  ASSERT_TRUE(version);
  // Last term's, this term's, and one that opens later.
  Assignment past{.version = assignment.version, .cohort = assignment.cohort, .due_utc_us = kMorning + kHour, .attempts_allowed = 3};
  past = *records.store().assignments.create(examiner, past);
  Assignment now = past;
  now.version = version->id;
  now.due_utc_us = kMorning + 9 * kHour;
  now = *records.store().assignments.create(examiner, now);
  Assignment later = past;
  later.opens_utc_us = kMorning + 8 * kHour;
  later.due_utc_us = kMorning + 8 * kHour + 1;
  later = *records.store().assignments.create(examiner, later);
  const auto shown = [&](std::int64_t at_us) {
    records.now_us = at_us;
    const Course course = *load_course(records.store(), lena.actor());
    for (const CourseRow& row : course.rows)
      if (row.assignment) return row;
    return CourseRow{};
  };
  EXPECT_EQ(shown(kMorning).assignment, past.id) << "due first";
  const CourseRow row = shown(kMorning + 2 * kHour);
  EXPECT_EQ(row.assignment, now.id);
  EXPECT_EQ(row.exercise.version, version->id) << "an attempt at the older version would not count";
  EXPECT_EQ(row.due_utc_us, now.due_utc_us);
  EXPECT_EQ(shown(kMorning + 20 * kHour).assignment, now.id) << "all are over: the newest of them";
}

TEST_F(Assessments, APracticeIsNotDueBeforeItOpens) {
  ASSERT_TRUE(records.store().assignments.create(examiner, {.version = assignment.version,
                                                            .cohort = assignment.cohort,
                                                            .opens_utc_us = kMorning + kHour,
                                                            .due_utc_us = kMorning + 2 * kHour}));
  const auto due = [&] {
    const Course course = *load_course(records.store(), lena.actor());
    return std::ranges::any_of(course.rows, [](const CourseRow& row) { return row.due_utc_us.has_value(); });
  };
  EXPECT_FALSE(due()) << "an attempt now would not count";
  records.now_us = kMorning + kHour;
  EXPECT_TRUE(due());
}

TEST_F(Assessments, OfTheAttemptsAllowedThoseOfTheAssignmentAloneAreUsed) {
  records.attempt(lena, "channel-1", 60, 100);
  records.attempt(lena, "channel-1", 65, 100);
  ASSERT_TRUE(records.store().assignments.create(examiner, {.version = assignment.version, .cohort = assignment.cohort, .attempts_allowed = 1}));
  const CourseModel model(load_course(records.store(), lena.actor())->rows);
  QStringList used;
  for (int i = 0; i < model.rowCount(); ++i)
    if (model.row(i).assignment) used += model.index(i, CourseModel::kAttempts).data().toString();
  EXPECT_EQ(used, QStringList{QStringLiteral("0 of 1")});
}

TEST_F(Assessments, AWithdrawnVersionIsNoLongerAssigned) {
  const auto version = publish_newer();
  ASSERT_TRUE(version);
  Assignment a = assignment;
  a.version = version->id;
  ASSERT_TRUE(records.store().assignments.create(examiner, a, "4711"));
  ASSERT_TRUE(records.store().assignments.create(examiner, {.version = version->id, .cohort = a.cohort, .due_utc_us = kMorning + kHour}));
  EXPECT_EQ(at(kMorning + 1000).size(), 2u);
  ASSERT_TRUE(records.store().scenarios.withdraw(examiner, version->id));
  EXPECT_EQ(at(kMorning + 1000).size(), 1u);
  const Course course = *load_course(records.store(), lena.actor());
  for (const CourseRow& row : course.rows) EXPECT_NE(row.exercise.version, version->id);
}

TEST_F(Assessments, AWithdrawnAssignmentStaysOnlyWhileAnAttemptOfItIsOpenOrWithheld) {
  const Assignment second = *records.store().assignments.create(examiner, assignment, "4711");
  ASSERT_TRUE(records.store().assignments.withdraw(examiner, second.id));
  ASSERT_EQ(at(kMorning + 1000).size(), 1u);
  const SessionId session = sit();
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  ASSERT_TRUE(records.store().assignments.withdraw(examiner, assignment.id));
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::interrupted);
  ASSERT_TRUE(records.store().grades.save(session, sample_grade(80), Hash256{}));
  EXPECT_EQ(at(kMorning + 1000).at(0).state, State::handed_in);
}

TEST_F(Assessments, AnAssignedPracticeNamesItsDevicesInTheCourse) {
  ASSERT_TRUE(records.store().assignments.create(
      examiner, {.version = assignment.version, .cohort = assignment.cohort, .device_classes = {"inverse3", "falcon"}}));
  const Course course = *load_course(records.store(), lena.actor());
  const CourseRow& next = course.rows[static_cast<std::size_t>(course.next())];
  EXPECT_EQ(next.device_classes, (std::vector<std::string>{"falcon", "inverse3"}));
}

TEST_F(Assessments, AnAssignedAssessmentIsNoPracticeOfTheCourse) {
  const Course course = *load_course(records.store(), lena.actor());
  ASSERT_FALSE(course.rows.empty());
  for (const CourseRow& row : course.rows) EXPECT_FALSE(row.assignment);
}

TEST_F(Assessments, AnExerciseIsTriedAgainInTheVersionThatCounts) {
  ASSERT_TRUE(records.store().assignments.create(examiner, {.version = assignment.version, .cohort = assignment.cohort, .due_utc_us = kMorning + kHour}));
  const auto newer = publish_newer();
  ASSERT_TRUE(newer);
  const auto drilled = [&] { return exercise_to_drill(records.store(), lena.actor(), newer->scenario)->version; };
  EXPECT_EQ(drilled(), assignment.version);
  records.now_us = kMorning + 2 * kHour;  // over: no version counts
  EXPECT_EQ(drilled(), newer->id);
}

TEST_F(Assessments, WhatIsOverIsNotNextBeforeWhatIsDue) {
  const Scenario other = *load_builtin("paper-block");
  const auto version = records.store().scenarios.ensure(other, canonical_json(other), content_hash(other).bytes);
  ASSERT_TRUE(version);
  const auto assign = [&](const VersionId& id, std::int64_t due_us) {
    ASSERT_TRUE(records.store().assignments.create(examiner, {.version = id, .cohort = assignment.cohort, .due_utc_us = due_us}));
  };
  assign(assignment.version, kMorning + kHour);
  assign(version->id, kMorning + 9 * kHour);
  const auto next = [&] {
    const Course course = *load_course(records.store(), lena.actor());
    return course.rows[static_cast<std::size_t>(course.next())].exercise.version;
  };
  EXPECT_EQ(next(), assignment.version);
  records.now_us = kMorning + 2 * kHour;
  EXPECT_EQ(next(), version->id);
}

TEST_F(Assessments, RefusedByARuleNameWhatToDoNext) {
  for (const char* rule : {"withdrawn", "past_due", "attempts_used"})
    EXPECT_TRUE(describe(StorageFailure{StorageError::wrong_state, rule, {}}).more.contains(QStringLiteral("Ask your instructor."))) << rule;
  EXPECT_TRUE(describe(StorageFailure{StorageError::wrong_state, "not_open", {}}).more.contains(QStringLiteral("start page")));
  // Staff choose the device.
  EXPECT_TRUE(describe(StorageFailure{StorageError::other_device, "pointer", "falcon"}).more.contains(QStringLiteral("Ask the staff")));
  EXPECT_TRUE(describe(StorageFailure{StorageError::self_test_due, "pointer", "7"}).more.contains(QStringLiteral("Ask the staff")));
}

}  // namespace
}  // namespace cusp::test
