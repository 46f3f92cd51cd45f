#include "ui/replay/playback_bar.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include "tests/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

struct PlaybackBarTest : testing::Test {
  PlaybackBarTest() { bar.set_length(30); }
  PlaybackBar bar;
};

TEST_F(PlaybackBarTest, runs_with_the_watcher_s_time_at_the_chosen_speed) {
  bar.set_playing(true);
  bar.advance(2, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 2);
  bar.findChild<Segments*>()->choose(2);  // twice as fast
  bar.advance(2, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 6);
  bar.set_playing(false);
  bar.advance(2, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 6);
}

TEST_F(PlaybackBarTest, a_held_space_acts_once) {
  auto* slider = bar.findChild<QSlider*>();
  QKeyEvent first(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier), again(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QString(), true);
  QApplication::sendEvent(slider, &first);
  QApplication::sendEvent(slider, &again);
  EXPECT_TRUE(bar.playing());
}

TEST_F(PlaybackBarTest, waits_for_what_is_not_ready) {
  bar.set_playing(true);
  for (int i = 0; i < 100; ++i) bar.advance(0.05, 1.0);
  EXPECT_GT(bar.position_s(), 1.0);
  EXPECT_LT(bar.position_s(), 1.0 + 2 * PlaybackBar::kAhead_s);
}

TEST_F(PlaybackBarTest, stops_at_the_end_and_begins_anew_from_there) {
  bar.seek(29.9);
  bar.set_playing(true);
  bar.advance(1, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 30);
  EXPECT_FALSE(bar.playing());
  bar.set_playing(true);
  EXPECT_DOUBLE_EQ(bar.position_s(), 0);
}

TEST_F(PlaybackBarTest, obeys_the_keys_of_a_replay_on_its_slider_too) {
  auto* slider = bar.findChild<QSlider*>();
  bar.seek(10);
  EXPECT_TRUE(bar.press_key(Qt::Key_Right, Qt::NoModifier));
  EXPECT_DOUBLE_EQ(bar.position_s(), 11);
  QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(bar.position_s(), 10.9);
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_DOUBLE_EQ(bar.position_s(), 0);
  QTest::keyClick(slider, Qt::Key_End);
  EXPECT_DOUBLE_EQ(bar.position_s(), 30);
  QTest::keyClick(slider, Qt::Key_Space);
  EXPECT_TRUE(bar.playing());
  EXPECT_FALSE(bar.press_key(Qt::Key_A, Qt::NoModifier));
}

TEST_F(PlaybackBarTest, obeys_the_arrows_on_its_button_too) {
  bar.show();
  QPushButton* play = bar.findChild<QPushButton*>();
  play->setFocus();
  bar.seek(10);
  QTest::keyClick(play, Qt::Key_Right);
  EXPECT_DOUBLE_EQ(bar.position_s(), 11);
  EXPECT_EQ(bar.focusWidget(), play);
  QTest::keyClick(play, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(bar.position_s(), 10.9);
  QTest::keyClick(play, Qt::Key_Space);
  EXPECT_TRUE(bar.playing());
  QTest::keyClick(play, Qt::Key_Space);
  EXPECT_FALSE(bar.playing());
}

TEST_F(PlaybackBarTest, stands_while_its_slider_is_held) {
  auto* slider = bar.findChild<QSlider*>();
  bar.set_playing(true);
  slider->setSliderDown(true);
  slider->setSliderPosition(100);
  bar.advance(2, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 10);
  slider->setSliderDown(false);
  EXPECT_TRUE(bar.playing());
  bar.advance(2, 30);
  EXPECT_DOUBLE_EQ(bar.position_s(), 12);
}

TEST_F(PlaybackBarTest, shows_and_speaks_position_and_length) {
  auto* slider = bar.findChild<QSlider*>();
  QSignalSpy moved(&bar, &PlaybackBar::position_changed);
  slider->setValue(125);
  ASSERT_EQ(moved.count(), 1);
  EXPECT_DOUBLE_EQ(moved[0][0].toDouble(), 12.5);
  QString read = slider->accessibleDescription();
  for (const char16_t mark : {u'\x2066', u'\x2069'}) read.remove(QChar(mark));
  EXPECT_EQ(read.toStdString(), "0:12 of 0:30");
  EXPECT_EQ(slider->accessibleName().toStdString(), "Position");
}

}  // namespace
}  // namespace cusp::test
