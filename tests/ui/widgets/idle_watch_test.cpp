// When nobody has used the station for a while.

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QWidget>
#include <chrono>

#include "tests/modules.h"
#include "ui/widgets/idle_watch.h"

namespace cusp::test {
namespace {

TEST(IdleWatch, speaks_once_after_its_time_without_input_and_never_without_a_limit) {
  IdleWatch watch;
  QSignalSpy idle(&watch, &IdleWatch::idle);
  watch.set_limit(std::chrono::milliseconds(40));
  ASSERT_TRUE(idle.wait());
  EXPECT_FALSE(idle.wait(120)) << "once";
  QWidget somewhere;
  QTest::keyClick(&somewhere, Qt::Key_A);
  ASSERT_TRUE(idle.wait());
  watch.set_limit(std::chrono::milliseconds(0));
  QTest::keyClick(&somewhere, Qt::Key_A);
  EXPECT_FALSE(idle.wait(120));
  EXPECT_EQ(idle.count(), 2);
}

TEST(IdleWatch, speaks_after_the_computer_slept_and_the_input_that_woke_it_reaches_nobody) {
  std::chrono::milliseconds now{0};
  IdleWatch watch([&now] { return now; });
  QSignalSpy idle(&watch, &IdleWatch::idle);
  watch.set_limit(std::chrono::minutes(20));
  QLineEdit field;
  now += std::chrono::minutes(19);
  QTest::keyClick(&field, Qt::Key_A);
  EXPECT_EQ(field.text(), QStringLiteral("a"));
  now += std::chrono::hours(8);  // of which the window's timers hear nothing
  QTest::keyClick(&field, Qt::Key_B);
  EXPECT_EQ(field.text(), QStringLiteral("a"));
  ASSERT_TRUE(idle.count() == 1 || idle.wait());
  QTest::keyClick(&field, Qt::Key_C);
  EXPECT_EQ(field.text(), QStringLiteral("ac"));
  EXPECT_EQ(idle.count(), 1);
}

TEST(IdleWatch, counts_input_that_is_no_event_of_the_window) {
  std::chrono::milliseconds now{0};
  IdleWatch watch([&now] { return now; });
  watch.set_limit(std::chrono::minutes(20));
  QLineEdit field;
  now += std::chrono::minutes(19);
  EXPECT_TRUE(watch.count_input());
  now += std::chrono::minutes(19);
  QTest::keyClick(&field, Qt::Key_A);
  EXPECT_EQ(field.text(), QStringLiteral("a"));
  now += std::chrono::minutes(20);
  EXPECT_FALSE(watch.count_input()) << "too late";
}

TEST(IdleWatch, counts_the_key_of_a_shortcut_and_lets_none_act_that_came_too_late) {
  std::chrono::milliseconds now{0};
  IdleWatch watch([&now] { return now; });
  watch.set_limit(std::chrono::minutes(20));
  QWidget window;
  QShortcut shortcut(QKeySequence(Qt::Key_P), &window);
  QSignalSpy acted(&shortcut, &QShortcut::activated);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  now += std::chrono::minutes(19);
  QTest::keyPress(&window, Qt::Key_P);
  EXPECT_EQ(acted.count(), 1);
  EXPECT_EQ(watch.idle_for().count(), 0);
  now += std::chrono::minutes(21);
  QTest::keyPress(&window, Qt::Key_P);
  EXPECT_EQ(acted.count(), 1);
}

TEST(IdleWatch, knows_without_a_limit_how_long_nobody_acted_and_keeps_no_input_back) {
  std::chrono::milliseconds now{0};
  IdleWatch watch([&now] { return now; });
  QLineEdit field;
  now += std::chrono::hours(8);
  QTest::keyClick(&field, Qt::Key_A);
  EXPECT_EQ(field.text(), QStringLiteral("a"));
  EXPECT_EQ(watch.idle_for().count(), 0);
  now += std::chrono::minutes(3);
  EXPECT_EQ(watch.idle_for(), std::chrono::minutes(3));
  EXPECT_TRUE(watch.count_input());
  EXPECT_EQ(watch.idle_for().count(), 0);
}

}  // namespace
}  // namespace cusp::test
