// How an attempt stands and ends on the platform "offscreen": open questions, a lost device, a record that is refused.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <chrono>

#include "storage/sqlite/database.h"
#include "tests/refused_rows.h"
#include "tests/ui/drill/drill_end.h"
#include "ui/session/background_task.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

TEST_F(DrillEnd, cancelling_a_question_leaves_a_paused_attempt_paused) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  const QString stood_at = clock();
  cancel_both_questions();
  EXPECT_TRUE(card_shows("Paused"));
  EXPECT_EQ(clock(), stood_at);
  EXPECT_EQ(hand->force_n, 0);
}

TEST_F(DrillEnd, cancelling_a_question_gives_no_force_to_a_device_that_came_back) {
  begin(plan());
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(wait_for_card("answers again"));
  cancel_both_questions();
  EXPECT_TRUE(card_shows("answers again"));
  EXPECT_EQ(hand->force_n, 0);
}

TEST_F(DrillEnd, a_device_that_was_lost_during_a_question_waits_for_resume) {
  begin(plan());
  screen->ask_finish();
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card_shows("does not answer"); }, kComesWithinMs));
  answer(false);
  ASSERT_TRUE(wait_for_card("Paused"));
  EXPECT_EQ(hand->force_n, 0);
  button(card(), "Resume")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, cancelling_a_question_continues_an_attempt_that_ran) {
  begin(plan());
  screen->ask_finish();
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n == 0; }, kComesWithinMs));
  answer(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_stop_card_is_hidden_while_the_tooth_is_measured) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_finish();
  answer(true);
  ASSERT_TRUE(screen->findChild<Busy*>()->running());
  EXPECT_EQ(screen->findChild<Busy*>()->accessibleName(), QStringLiteral("Measuring the tooth"));
  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, an_assessment_cannot_be_paused) {
  begin(plan(Guidance::silent));
  EXPECT_EQ(button(*screen, "Pause"), nullptr);
  QTest::keyClick(screen.get(), Qt::Key_P);
  screen->toggle_pause();
  let_it_run();
  EXPECT_FALSE(card().isVisible());
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs)) << "the clock runs on";
}

TEST_F(DrillEnd, an_assessment_that_a_lost_device_stopped_is_resumed) {
  begin(plan(Guidance::silent));
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(wait_for_card("answers again"));
  screen->ask_finish();
  answer(false);
  let_it_run();
  EXPECT_TRUE(card_shows("answers again"));
  EXPECT_EQ(hand->force_n, 0);
  EXPECT_NE(button(card(), "Resume"), nullptr);
  ASSERT_NE(button(*screen, "Resume"), nullptr);
  QTest::keyClick(screen.get(), Qt::Key_P);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !card().isVisible() && hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_cutaway_opens_while_the_attempt_is_paused) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(QTest::qWaitFor([&] { return card().isVisible(); }, kComesWithinMs));
  EXPECT_FALSE(screen->view()->scene().cutaway);
  QTest::keyClick(screen.get(), Qt::Key_3);
  EXPECT_TRUE(QTest::qWaitFor([&] { return screen->view()->scene().cutaway.has_value(); }, kComesWithinMs));
}

TEST_F(DrillEnd, a_key_that_is_held_too_long_acts_once) {
  begin(plan());
  const auto stays_down = [this](Qt::Key key) {
    QTest::simulateEvent(screen.get(), true, key, Qt::NoModifier, QString(), true);
    let_it_run();
  };
  QTest::keyPress(screen.get(), Qt::Key_P);
  ASSERT_TRUE(wait_for_card("Paused"));
  stays_down(Qt::Key_P);
  EXPECT_TRUE(card_shows("Paused"));
  EXPECT_EQ(hand->force_n, 0);
  QTest::keyRelease(screen.get(), Qt::Key_P);
  QTest::keyClick(screen.get(), Qt::Key_6);
  const bool shown = screen->view()->scene().show_handpiece;
  stays_down(Qt::Key_6);
  EXPECT_EQ(screen->view()->scene().show_handpiece, shown);
  stays_down(Qt::Key_Escape);
  EXPECT_TRUE(asked.isEmpty());
}

TEST_F(DrillEnd, the_desktop_is_kept_awake_while_the_attempt_runs_and_no_longer) {
  std::weak_ptr<void> awake;
  ports.keep_awake = [&awake](const QString&) {
    const auto held = std::make_shared<int>(0);
    awake = held;
    return held;
  };
  screen = std::make_unique<DrillScreen>(ports);
  screen->resize(1280, 800);
  screen->show();
  screen->activateWindow();
  begin(plan());
  EXPECT_FALSE(awake.expired());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return awake.expired(); }, kComesWithinMs)) << "nobody drills";
  button(card(), "Resume")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !awake.expired(); }, kComesWithinMs));
  screen->ask_leave();
  answer(true);
  EXPECT_TRUE(awake.expired());
}

TEST_F(DrillEnd, an_attempt_that_nobody_attends_lets_the_desktop_sleep_and_runs_on) {
  std::weak_ptr<void> awake;
  std::chrono::milliseconds now{0};
  ports.keep_awake = [&awake](const QString&) {
    const auto held = std::make_shared<int>(0);
    awake = held;
    return held;
  };
  ports.since_boot = [&now] { return now; };
  screen = std::make_unique<DrillScreen>(ports);
  screen->resize(1280, 800);
  screen->show();
  screen->activateWindow();
  begin(plan());
  let_it_come_to_rest();
  now += std::chrono::minutes(4);
  let_it_run();
  EXPECT_FALSE(awake.expired()) << "somebody looks at the tooth";
  now += std::chrono::minutes(2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return awake.expired(); }, kComesWithinMs));
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs));
  EXPECT_FALSE(card().isVisible());
  QTest::keyClick(screen.get(), Qt::Key_6);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !awake.expired(); }, kComesWithinMs)) << "a key";
  now += std::chrono::minutes(6);
  EXPECT_TRUE(QTest::qWaitFor([&] { return awake.expired(); }, kComesWithinMs));
  hand->aside_mm = 1.0;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !awake.expired(); }, kComesWithinMs)) << "the device";
  now += std::chrono::minutes(6);
  EXPECT_TRUE(QTest::qWaitFor([&] { return awake.expired(); }, kComesWithinMs));
  screen->count_input();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !awake.expired(); }, kComesWithinMs)) << "what turns the tooth";
  screen.reset();  // before its clock
}

TEST_F(DrillEnd, an_attempt_begins_while_work_that_was_left_goes_on) {
  auto gate = std::make_shared<test::Gate>();
  BackgroundTask([gate] { gate->pass(); });
  begin(plan());
  EXPECT_FALSE(gate->gave_up());
  gate->open();
}

TEST_F(DrillEnd, an_open_question_of_an_assessment_takes_cut_and_force_off_and_lets_the_clock_run) {
  begin(plan(Guidance::silent));
  screen->ask_finish();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->force_n == 0; }, kComesWithinMs));
  // What was cut before is shown once the bar stands; three rounds are less than the depth that is left.
  double cut = -1.0;
  for (int round = 0; round < 3 && cut != removed(); ++round) {
    cut = removed();
    let_it_run();
  }
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs)) << "the clock runs on";
  let_it_run();
  EXPECT_EQ(removed(), cut);
  EXPECT_EQ(hand->force_n, 0);
  answer(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
  let_it_run();
  EXPECT_EQ(removed(), cut) << "its button is down since before the question";
  hand->pressed = false;
  let_it_run();
  hand->pressed = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return removed() > cut && hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, a_practice_in_a_minimised_window_stands_until_resume) {
  begin(plan());
  screen->setWindowState(Qt::WindowMinimized);
  ASSERT_TRUE(wait_for_card("Paused"));
  screen->setWindowState(Qt::WindowNoState);
  let_it_run();
  EXPECT_TRUE(card_shows("Paused"));
  EXPECT_EQ(hand->force_n, 0);
  button(card(), "Resume")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, an_assessment_in_a_minimised_window_has_no_force_until_it_is_shown_and_its_clock_runs_on) {
  begin(plan(Guidance::silent));
  screen->setWindowState(Qt::WindowMinimized);
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->force_n == 0; }, kComesWithinMs));
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs)) << "the clock runs on";
  EXPECT_EQ(hand->force_n, 0);
  screen->ask_finish();
  answer(false);
  let_it_run();
  EXPECT_EQ(hand->force_n, 0) << "who stays has not seen the tooth yet";
  screen->setWindowState(Qt::WindowNoState);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_time_limit_of_an_assessment_ends_it_under_an_open_question) {
  SessionPlan limited = plan(Guidance::silent);
  limited.scenario.time_limit_s = 8;
  limited.start_code = "K7P2";
  begin(std::move(limited));
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_leave();
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->findChild<Busy*>()->running(); }, kComesWithinMs));
  EXPECT_EQ(screen->findChild<Busy*>()->accessibleName(), QStringLiteral("The time is over. Measuring the tooth"));
  EXPECT_EQ(screen->accessibleDescription(), screen->findChild<Busy*>()->accessibleName()) << "it is read out";
  answer(true);  // too late: it is measured already
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, leaving_keeps_the_window_alive_while_the_last_second_waits_for_the_disk) {
  DeskRecords records;
  begin_recorded(records);
  QSignalSpy left(screen.get(), &DrillScreen::left);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->run("BEGIN IMMEDIATE"));  // as another program may
  let_it_run();
  screen->ask_leave();
  answer(true);
  EXPECT_FALSE(screen->running());
  EXPECT_EQ(left.count(), 0);
  ASSERT_TRUE(database->run("COMMIT"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, a_refused_record_is_finished_again_from_its_card_and_nothing_is_lost) {
  DeskRecords records;
  begin_recorded(records);
  QSignalSpy finished(screen.get(), &DrillScreen::finished), failed(screen.get(), &DrillScreen::failed);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  // From the third second on.
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(wait_for_card("Resume then writes"));
  screen->ask_finish();
  answer(true);
  for (int tries = 0; tries < 2; ++tries) {
    ASSERT_TRUE(wait_for_card("Try again then writes"));
    EXPECT_EQ(button(card(), "Resume"), nullptr) << "the session is stopped";
    EXPECT_EQ(button(card(), "Leave"), nullptr);
    if (tries == 1) {
      ASSERT_TRUE(take_rows(*database, "trace_chunks"));
    }
    ASSERT_NE(button(card(), "Try again"), nullptr);
    EXPECT_TRUE(button(card(), "Try again")->hasFocus()) << "Finish had the keys, and is off";
    button(card(), "Try again")->click();
    EXPECT_FALSE(card().isVisible());
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kComesWithinMs));
  ASSERT_EQ(finished.count(), 1);
  const auto result = finished.at(0).at(0).value<std::shared_ptr<const SessionResult>>();
  EXPECT_FALSE(result->interrupted);
  const auto chunks = records.store().traces.chunks(result->session);
  ASSERT_TRUE(chunks);
  EXPECT_GE(static_cast<double>(chunks->size()) + 1e-9, result->seconds) << "every second is kept";
}

TEST_F(DrillEnd, leaving_an_attempt_whose_record_is_refused_names_what_goes) {
  DeskRecords records;
  begin_recorded(records);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(wait_for_card("Resume then writes"));
  screen->ask_leave();
  EXPECT_TRUE(more.contains(QStringLiteral("without what cannot be written"))) << more.toStdString();
  answer(false);
  screen.reset();  // before its records
}

}  // namespace
}  // namespace cusp::test
