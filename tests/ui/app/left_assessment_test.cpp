// An assessment is left by its start code alone, is continued by it, and keeps its exercise from practice until it is handed in.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "storage/sqlite/database.h"
#include "tests/modules.h"
#include "tests/refused_rows.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/report/report_page.h"
#include "ui/student/interrupted_card.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

constexpr int kDrillingMs = 60'000;  // waits for progress, never decides

struct LeftAssessment : ::testing::Test {
  LeftAssessment() {
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked.push_back(question);
      answer = std::move(then);
    };
    Store& store = records.store();
    lena = records.student("1", "Lena Brandt");
    examiner = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
    const CohortId cohort = store.cohorts.create(examiner, "Year 3")->id;
    EXPECT_TRUE(store.cohorts.add(examiner, cohort, lena.id));
    exercise.scenario = *load_builtin("channel-1");
    exercise.scenario.version += 1;
    exercise.scenario.specimen.voxel_mm = 0.4;  // so that it grows at once
    exercise.version = store.scenarios.ensure(exercise.scenario, canonical_json(exercise.scenario), content_hash(exercise.scenario).bytes)->id;
    const Assignment wanted{.version = exercise.version, .cohort = cohort, .kind = SessionKind::assessment, .attempts_allowed = 1};
    exam = *store.assignments.create(examiner, wanted, "4711");
    desktop = std::make_unique<Desktop>(settings, ports, records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(lena);
  }
  DrillScreen* screen() { return qobject_cast<DrillScreen*>(desktop->page()); }
  bool drills() {
    return QTest::qWaitFor([&] { return screen() != nullptr && screen()->running(); }, kDrillingMs);
  }
  bool leaves() {
    return QTest::qWaitFor([&] { return desktop->page() == desktop->shell(); }, kDrillingMs);
  }
  bool closes() {
    return QTest::qWaitFor([&] { return !desktop->isVisible(); }, kDrillingMs);
  }
  bool shows(const QString& part) const {
    for (const QLabel* label : desktop->page()->findChildren<QLabel*>())
      if (label->text().contains(part)) return true;
    return false;
  }
  /// Types into the dialog that asks for the start code; returns what it then shows.
  QString type_code(const QString& code, const QString& button) {
    auto* question = desktop->findChild<AssessmentStart*>();
    if (question == nullptr) return QStringLiteral("no question");
    question->findChild<QLineEdit*>()->setText(code);
    for (QPushButton* b : question->findChildren<QPushButton*>())
      if (b->text() == button) b->click();
    return question->isVisible() ? question->findChild<Band*>()->text() : QString();
  }
  void sit() {
    desktop->sit(load_assessments(records.store(), lena.actor(), QDateTime::currentDateTime(), "pointer")->shown.at(0));
    EXPECT_EQ(type_code(QStringLiteral("4711"), QStringLiteral("Begin")), QString());
    ASSERT_TRUE(drills());
  }
  SessionId sit_and_leave() {
    sit();
    screen()->ask_leave();
    answer(true);
    EXPECT_TRUE(leaves());
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return records.store().history.list(lena.actor())->front().session;
  }
  SessionId practise_and_leave() {
    desktop->drill(exercise);
    EXPECT_TRUE(drills());
    screen()->ask_leave();  // nothing was cut: it asks nothing
    EXPECT_TRUE(leaves());
    return records.store().history.list(lena.actor())->front().session;
  }
  SessionState state_of(const SessionId& session) { return *records.store().sessions.state(session); }
  /// As where the program is killed between the end of an attempt and its grade.
  void end_without_grade(const SessionId& session) {
    Store& store = records.store();
    ASSERT_TRUE(store.sessions.resume(session, "student"));
    const auto chunks = store.traces.chunks(session);
    ASSERT_TRUE(chunks);
    FinalVolume volume;
    if (!chunks->empty()) volume.tick = chunks->back().first_tick + chunks->back().count - 1;
    ASSERT_TRUE(store.sessions.finish(session, volume, "student"));
    ASSERT_EQ(state_of(session), SessionState::finished);
  }
  bool reports() {
    return QTest::qWaitFor([&] { return qobject_cast<ReportPage*>(desktop->page()) != nullptr; }, kDrillingMs);
  }

  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  std::vector<Question> asked;
  std::function<void(bool)> answer;
  Account lena;
  Actor examiner;
  Exercise exercise;
  Assignment exam;
  std::unique_ptr<Desktop> desktop;
};

TEST_F(LeftAssessment, is_not_ended_by_closing_the_window_which_asks_for_the_code) {
  sit();
  EXPECT_FALSE(desktop->close());
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].code, QStringLiteral("4711"));
  EXPECT_TRUE(screen()->running());
  answer(true);
  EXPECT_TRUE(closes()) << "who leaves it has asked for that";
  EXPECT_EQ(asked.size(), 1u);
  EXPECT_EQ(state_of(records.store().history.list(lena.actor())->front().session), SessionState::interrupted);
}

TEST_F(LeftAssessment, is_left_later_without_its_window_if_the_question_at_closing_was_cancelled) {
  sit();
  EXPECT_FALSE(desktop->close());
  answer(false);
  EXPECT_TRUE(screen()->running());
  screen()->ask_leave();
  answer(true);
  EXPECT_TRUE(leaves());
  EXPECT_TRUE(desktop->isVisible());
}

TEST_F(LeftAssessment, is_unlike_a_practice_with_nothing_cut_which_ends_with_its_window) {
  desktop->drill(exercise);
  ASSERT_TRUE(drills());
  desktop->close();
  EXPECT_TRUE(closes());
  EXPECT_TRUE(asked.empty());
}

TEST_F(LeftAssessment, is_continued_by_its_start_code_alone_and_left_by_it_again) {
  const SessionId session = sit_and_leave();
  EXPECT_EQ(state_of(session), SessionState::interrupted);
  desktop->resume_attempt(session);
  EXPECT_TRUE(type_code(QStringLiteral("4712"), QStringLiteral("Continue")).contains(QStringLiteral("not the start code")));
  EXPECT_EQ(desktop->page(), desktop->shell());
  EXPECT_EQ(type_code(QStringLiteral("4711"), QStringLiteral("Continue")), QString()) << "though its one attempt is used";
  ASSERT_TRUE(drills());
  EXPECT_TRUE(shows(QStringLiteral("continued")));
  screen()->ask_leave();
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[1].code, QStringLiteral("4711"));
}

TEST_F(LeftAssessment, keeps_its_exercise_from_practice_until_it_is_handed_in) {
  const SessionId practice = records.broken_attempt(lena, "channel-1");
  const SessionId session = sit_and_leave();
  const QString sentence = QStringLiteral("Your assessment of this exercise is not handed in yet.");
  desktop->drill(exercise);
  EXPECT_EQ(screen(), nullptr);
  EXPECT_TRUE(shows(sentence));
  desktop->back();
  desktop->resume_attempt(practice);
  EXPECT_EQ(screen(), nullptr);
  EXPECT_TRUE(shows(sentence));
  desktop->back();
  desktop->grade_interrupted(session);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[1].act, QStringLiteral("Hand in"));
  EXPECT_EQ(state_of(session), SessionState::interrupted);
  answer(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return qobject_cast<HandedIn*>(desktop->page()) != nullptr; }, kDrillingMs));
  desktop->back();
  desktop->drill(exercise);
  EXPECT_NE(screen(), nullptr);
}

TEST_F(LeftAssessment, is_graded_after_a_question_and_so_is_a_practice_that_was_left) {
  const SessionId practice = practise_and_leave();
  desktop->grade_interrupted(practice);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].act, QStringLiteral("Grade"));
  answer(false);
  EXPECT_EQ(desktop->page(), desktop->shell());
  EXPECT_EQ(state_of(practice), SessionState::interrupted) << "it can be continued";
  desktop->grade_interrupted(practice);
  answer(true);
  ASSERT_TRUE(reports());
  EXPECT_EQ(state_of(practice), SessionState::graded);
}

TEST_F(LeftAssessment, that_ended_without_its_grade_gets_it_where_its_examiner_opens_it) {
  const SessionId session = sit_and_leave();
  end_without_grade(session);
  desktop->open_report(session);
  EXPECT_NE(qobject_cast<HandedIn*>(desktop->page()), nullptr) << "its result is withheld from the student";
  EXPECT_EQ(state_of(session), SessionState::finished);
  desktop->sign_in(*records.store().accounts.find(examiner.id));
  desktop->open_report(session);
  ASSERT_TRUE(reports());
  EXPECT_EQ(state_of(session), SessionState::graded);
}

TEST_F(LeftAssessment, and_a_practice_that_ended_without_its_grade_gets_it_where_its_student_opens_it) {
  const SessionId practice = practise_and_leave();
  end_without_grade(practice);
  desktop->open_report(practice);
  ASSERT_TRUE(reports());
  EXPECT_EQ(state_of(practice), SessionState::graded);
  EXPECT_TRUE(records.store().history.list(lena.actor())->front().score.has_value()) << "it counts among the results";
}

TEST_F(LeftAssessment, and_a_practice_that_was_continued_is_tried_again_in_the_newest_version) {
  const SessionId practice = practise_and_leave();
  Store& store = records.store();
  exercise.scenario.rubric.pass += 1;
  const auto newest = store.scenarios.publish(examiner, exercise.scenario, canonical_json(exercise.scenario), content_hash(exercise.scenario).bytes);
  ASSERT_TRUE(newest);
  desktop->resume_attempt(practice);
  ASSERT_TRUE(drills());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !screen()->working(); }, kDrillingMs));
  screen()->ask_finish();
  answer(true);
  ASSERT_TRUE(reports());
  Q_EMIT qobject_cast<ReportPage*>(desktop->page())->try_again_wanted();
  ASSERT_TRUE(drills());
  const SessionId again = store.history.list(lena.actor())->front().session;
  EXPECT_NE(again, practice);
  EXPECT_EQ(store.sessions.find(again)->version, newest->id);
}

TEST_F(LeftAssessment, keeps_the_button_to_practise_from_the_report_of_an_earlier_one_until_it_is_handed_in) {
  Store& store = records.store();
  const auto begin = [&](const Assignment& of, const char* code) {
    NewSession wanted{.student = lena.id, .version = of.version, .kind = SessionKind::assessment, .assignment = of.id, .start_code = code};
    wanted.header.scene = "{}";
    return store.sessions.start(lena.actor(), wanted)->id;
  };
  const SessionId earlier = begin(exam, "4711");
  ASSERT_TRUE(store.sessions.interrupt(earlier, "left"));
  ASSERT_TRUE(store.grades.save(earlier, sample_grade(80), Hash256{}));
  ASSERT_TRUE(store.statements.release(examiner, earlier));
  const auto resit = store.assignments.create(examiner, {.version = exam.version, .cohort = exam.cohort, .kind = SessionKind::assessment}, "4712");
  ASSERT_TRUE(resit);
  const SessionId left = begin(*resit, "4712");
  ASSERT_TRUE(store.sessions.interrupt(left, "left"));
  const auto report_offers_practice = [&] {
    auto result = std::make_shared<SessionResult>();
    result->session = earlier;
    result->scenario = exercise.scenario;
    result->grade = sample_grade(80);
    desktop->end_attempt(result, exercise);
    EXPECT_TRUE(QTest::qWaitFor([&] { return qobject_cast<ReportPage*>(desktop->page()) != nullptr; }, kDrillingMs));
    const auto buttons = desktop->page()->findChildren<QPushButton*>();
    const bool offers = std::ranges::any_of(buttons, [](const QPushButton* b) { return b->accessibleName() == QStringLiteral("Practise it"); });
    EXPECT_FALSE(shows(QStringLiteral("Candidate"))) << "the report is the student's own";
    desktop->back();
    return offers;
  };
  EXPECT_FALSE(report_offers_practice());
  ASSERT_TRUE(store.grades.save(left, sample_grade(60), Hash256{}));
  EXPECT_TRUE(report_offers_practice());
}

TEST_F(LeftAssessment, leads_from_the_results_to_the_start_page_and_one_that_runs_is_named_so) {
  NewSession wanted{.student = lena.id, .version = exam.version, .assignment = exam.id, .start_code = "4711"};
  wanted.header.scene = "{}";
  const SessionId session = records.store().sessions.start(lena.actor(), wanted)->id;
  desktop->shell()->show_page(QStringLiteral("results"));
  desktop->open_report(session);
  EXPECT_TRUE(shows(QStringLiteral("This attempt is being drilled in another window.")));
  desktop->back();
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  desktop->open_report(session);
  EXPECT_EQ(desktop->page(), desktop->shell());
  EXPECT_EQ(desktop->shell()->page_key(), QStringLiteral("start"));
}

TEST_F(LeftAssessment, that_opened_while_the_computer_slept_is_offered_without_a_press) {
  QDateTime now = QDateTime::currentDateTime();
  constexpr int kHourS = 3600;
  const Assignment later{.version = exercise.version, .cohort = exam.cohort, .kind = SessionKind::assessment, .opens_utc_us = now.addSecs(kHourS).toMSecsSinceEpoch() * 1000};
  ASSERT_TRUE(records.store().assignments.create(examiner, later, "4712"));
  Ports with_clock = ports;
  with_clock.now = [&now] { return now; };
  desktop = std::make_unique<Desktop>(settings, with_clock, records.file());
  desktop->start();
  desktop->show();
  desktop->sign_in(lena);
  const auto starts = [this] {
    const auto cards = desktop->page()->findChildren<AssessmentCard*>();
    return std::ranges::count_if(cards, [](const AssessmentCard* card) { return card->start_button() != nullptr; });
  };
  EXPECT_EQ(starts(), 1) << "the other one is open";
  now = now.addSecs(kHourS);  // the page's timer has not run meanwhile
  EXPECT_TRUE(QTest::qWaitFor([&] { return starts() == 2; }, kDrillingMs));
  desktop.reset();  // it has the clock
}

TEST_F(LeftAssessment, whose_end_could_not_be_written_is_continued_once_it_can_be) {
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  sit();
  // Refused as on a full disk, but at once.
  ASSERT_TRUE(refuse_rows(*database, "session_events", "kind = 'started'"));
  screen()->ask_leave();
  answer(true);
  ASSERT_TRUE(leaves());
  const SessionId session = records.store().history.list(lena.actor())->front().session;
  EXPECT_EQ(state_of(session), SessionState::running);
  ASSERT_TRUE(take_rows(*database, "session_events"));
  desktop->shell()->show_page(QStringLiteral("start"));
  EXPECT_EQ(state_of(session), SessionState::interrupted);
  EXPECT_NE(desktop->page()->findChild<InterruptedCard*>(), nullptr);
}

TEST_F(LeftAssessment, is_unlike_a_finished_practice_whose_report_opens_without_a_grade_while_none_can_be_written) {
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  const SessionId practice = practise_and_leave();
  end_without_grade(practice);
  ASSERT_TRUE(refuse_rows(*database, "grades"));
  desktop->open_report(practice);
  ASSERT_TRUE(reports());
  EXPECT_EQ(state_of(practice), SessionState::finished);
  ASSERT_TRUE(take_rows(*database, "grades"));
  desktop->open_report(practice);
  ASSERT_TRUE(QTest::qWaitFor([&] { return state_of(practice) == SessionState::graded; }, kDrillingMs));
}

}  // namespace
}  // namespace cusp::test
