#include "tests/modules.h"
#include "ui/drill/session_foot.h"

#include <gtest/gtest.h>

#include <QWidget>

namespace cusp::test {
namespace {

LiveView recorded() {
  LiveView live;
  live.recording = RecordingState::recording;
  live.seconds = 60.0;
  live.shown_seconds = 59.98;
  return live;
}

struct Foot {
  QWidget panel;
  SessionFoot* foot = new SessionFoot;
  Foot() { panel.setLayout(foot); }
};

QString text_of(const LiveView& live) {
  const Foot shown;
  shown.foot->show_values(live);
  return shown.foot->text();
}

TEST(SessionFoot, says_that_the_attempt_is_kept_while_nothing_waits) {
  EXPECT_EQ(session_news(recorded()), SessionNews::recording);
  EXPECT_TRUE(text_of(recorded()).contains("every second"));
  EXPECT_EQ(session_news({}), SessionNews::off);
}

TEST(SessionFoot, says_how_far_the_picture_is_behind_from_a_second_on) {
  LiveView live = recorded();
  live.shown_seconds = live.seconds - 0.99;
  EXPECT_EQ(session_news(live), SessionNews::recording);
  live.shown_seconds = live.seconds - 4.1;
  EXPECT_EQ(session_news(live), SessionNews::picture_behind);
  EXPECT_TRUE(text_of(live).contains("4")) << text_of(live).toStdString();
}

TEST(SessionFoot, counts_seconds_of_the_session_where_a_slow_computer_makes_long_ticks) {
  LiveView live = recorded();
  live.output.tick = 20'000;
  live.shown_tick = live.output.tick - 1'000;  // of 3 ms each
  live.shown_seconds = live.seconds - 3.0;
  EXPECT_TRUE(text_of(live).contains("3")) << text_of(live).toStdString();
}

TEST(SessionFoot, counts_the_seconds_while_they_grow) {
  LiveView live = recorded();
  const Foot shown;
  for (const int seconds : {2, 7}) {
    live.shown_seconds = live.seconds - seconds;
    shown.foot->show_values(live);
    EXPECT_TRUE(shown.foot->text().contains(QString::number(seconds)));
  }
}

TEST(SessionFoot, warns_before_a_slow_computer_ends_the_attempt) {
  LiveView live = recorded();
  live.shown_seconds = live.seconds - 45.0;
  live.ring_warning = true;
  EXPECT_EQ(session_news(live), SessionNews::too_slow);
  EXPECT_TRUE(text_of(live).contains("too slow"));
}

TEST(SessionFoot, a_record_that_cannot_be_written_comes_before_a_late_picture) {
  LiveView live = recorded();
  live.ring_warning = true;
  live.recording = RecordingState::failed;
  EXPECT_EQ(session_news(live), SessionNews::failed);
  live.ring_warning = false;
  live.recording = RecordingState::behind;
  EXPECT_EQ(session_news(live), SessionNews::disk_behind);
  live.shown_seconds = 0;
  EXPECT_EQ(session_news(live), SessionNews::picture_behind);
}

TEST(SessionFoot, before_the_first_step_nothing_is_behind) {
  LiveView live;
  live.shown_seconds = 5;
  EXPECT_EQ(picture_behind_s(live), 0.0);
}

}  // namespace
}  // namespace cusp::test
