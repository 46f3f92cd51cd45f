// A window that closes over an attempt that is opened, measured or left: it shows what is waited for, and closes after it.
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "storage/sqlite/database.h"
#include "tests/refused_rows.h"
#include "tests/ui/drill/drill_end.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

struct Leaving : DrillEnd {
  /// As the window that closes.
  void close() {
    screen->ask_leave_then([this] { closed = true; });
  }
  bool shows(const char* doing) const {
    const auto* busy = screen->findChild<Busy*>();
    return busy->running() && busy->accessibleName() == QLatin1String(doing) && screen->accessibleDescription() == QLatin1String(doing);
  }
  bool closes() {
    return QTest::qWaitFor([this] { return closed; }, kComesWithinMs);
  }
  bool closed = false;
};

TEST_F(Leaving, a_tooth_that_is_measured_is_waited_for_and_its_result_is_kept_before_the_window_closes) {
  begin(plan());
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_finish();
  answer(true);
  ASSERT_TRUE(screen->working());
  close();
  EXPECT_FALSE(closed);
  EXPECT_TRUE(shows("Cusp closes once the tooth is measured"));
  ASSERT_TRUE(closes());
  EXPECT_EQ(finished.count(), 1);
}

TEST_F(Leaving, leave_alone_does_not_disturb_the_measuring) {
  begin(plan());
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_finish();
  answer(true);
  screen->ask_leave();
  EXPECT_EQ(screen->findChild<Busy*>()->accessibleName(), QStringLiteral("Measuring the tooth"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
}

TEST_F(Leaving, an_attempt_that_is_being_opened_is_called_off_and_shows_that) {
  hand->opens = std::make_shared<Gate>();
  QSignalSpy left(screen.get(), &DrillScreen::left);
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->open.load(); }, kComesWithinMs));
  EXPECT_FALSE(screen->running());
  ASSERT_TRUE(screen->working()) << "the window that closes asks";
  close();
  EXPECT_TRUE(shows("Leaving the attempt"));
  ASSERT_TRUE(closes());
  EXPECT_EQ(left.count(), 1);
  EXPECT_FALSE(screen->working());
  EXPECT_FALSE(hand->opens->gave_up());
  hand->opens->open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs));
}

TEST_F(Leaving, an_attempt_that_waits_for_the_disk_is_waited_for) {
  DeskRecords records;
  begin_recorded(records);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->run("BEGIN IMMEDIATE"));  // as another program may
  screen->ask_leave();
  answer(true);
  EXPECT_FALSE(screen->running());
  ASSERT_TRUE(screen->working()) << "the window that closes asks";
  close();
  EXPECT_FALSE(closed);
  EXPECT_EQ(screen->findChild<Busy*>()->accessibleName(), QStringLiteral("Leaving the attempt"));
  ASSERT_TRUE(database->run("COMMIT"));
  EXPECT_TRUE(closes());
  screen.reset();  // before its records
}

TEST_F(Leaving, a_window_stays_over_an_attempt_whose_end_the_record_refuses) {
  DeskRecords records;
  begin_recorded(records);
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(wait_for_card("Resume then writes"));
  screen->ask_finish();
  answer(true);
  close();
  ASSERT_TRUE(wait_for_card("Try again then writes"));
  ASSERT_TRUE(take_rows(*database, "trace_chunks"));
  button(card(), "Try again")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
  EXPECT_FALSE(closed) << "who tried again wants to see the result";
  screen.reset();  // before its records
}

}  // namespace
}  // namespace cusp::test
