// A driver that does not come back: the attempt is left or kept all the same, and the window closes.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/ui/drill/drill_end.h"

namespace cusp::test {
namespace {

using DriverStandsStill = DrillEnd;

TEST_F(DriverStandsStill, an_attempt_whose_driver_stands_still_is_not_finished) {
  begin(plan());
  hand->stuck = true;
  ASSERT_TRUE(wait_for_card("driver of the device"));
  EXPECT_EQ(button(card(), "Resume"), nullptr);
  screen->ask_finish();
  EXPECT_TRUE(asked.isEmpty()) << "it would be graded without what the driver still holds";
  let_driver_go();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card_shows("driver of the device"); }, kComesWithinMs));
  screen->ask_finish();
  EXPECT_EQ(asked, QStringList({QStringLiteral("Finish")}));
}

TEST_F(DriverStandsStill, an_attempt_whose_driver_stands_still_is_left_and_kept) {
  DeskRecords records;
  const Actor student = begin_recorded(records);
  QSignalSpy left(screen.get(), &DrillScreen::left);
  let_it_run();
  hand->stuck = true;
  ASSERT_TRUE(wait_for_card("driver of the device"));
  ASSERT_NE(button(card(), "Leave"), nullptr);
  button(card(), "Leave")->click();
  EXPECT_TRUE(more.contains(QStringLiteral("until the driver of the device stood still"))) << more.toStdString();
  answer(true);
  EXPECT_FALSE(screen->running()) << "the window may close";
  ASSERT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
  screen.reset();
  EXPECT_TRUE(hand->open) << "its driver has not come back";
  const auto kept = records.store().history.interrupted(student, student.id);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->size(), 1u);
  const auto chunks = records.store().traces.chunks(kept->front().session);
  ASSERT_TRUE(chunks);
  EXPECT_FALSE(chunks->empty());
  let_driver_go();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs)) << "the thread that waits for it closes it";
}

TEST_F(DriverStandsStill, an_attempt_whose_driver_does_not_open_is_left) {
  hand->opens = std::make_shared<Gate>();
  QSignalSpy left(screen.get(), &DrillScreen::left);
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->open.load(); }, kComesWithinMs));
  screen->ask_leave();
  EXPECT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
  EXPECT_FALSE(hand->opens->gave_up()) << "nobody waits for the driver";
  screen.reset();
  EXPECT_TRUE(hand->open) << "its driver has not come back";
  hand->opens->open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs)) << "the thread that waits for it closes it";
}

TEST_F(DriverStandsStill, the_window_closes_while_a_driver_does_not_open) {
  hand->opens = std::make_shared<Gate>();
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->open.load(); }, kComesWithinMs));
  screen.reset();
  EXPECT_FALSE(hand->opens->gave_up());
  EXPECT_TRUE(hand->open);
  hand->opens->open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs));
}

}  // namespace
}  // namespace cusp::test
