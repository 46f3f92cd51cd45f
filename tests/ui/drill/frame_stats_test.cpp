#include "tests/modules.h"
#include "ui/view/frame_stats.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

namespace cusp::test {
namespace {

using std::chrono::milliseconds;
using Clock = FrameStats::Clock;

TEST(FrameStats, frames_that_show_a_cut_are_counted_over_the_time_that_they_took) {
  FrameStats stats;
  const Clock::time_point start{};
  for (int i = 0; i <= 100; ++i) {
    const auto shown = start + milliseconds(40 * i);
    stats.frame(shown, {shown - milliseconds(30)}, 12.0);
  }
  const FrameFigures f = stats.figures();
  EXPECT_EQ(f.frames, 101u);
  EXPECT_NEAR(f.fps_while_cutting, 25.0, 1e-6);
  EXPECT_NEAR(f.latency_p50_ms, 30.0, 1e-3);
  EXPECT_NEAR(f.draw_p95_ms, 12.0, 1e-3);
}

TEST(FrameStats, a_rest_of_the_hand_and_frames_without_a_change_do_not_count_as_slow) {
  FrameStats stats;
  const Clock::time_point start{};
  for (int i = 0; i <= 10; ++i) stats.frame(start + milliseconds(20 * i), {start + milliseconds(20 * i - 10)}, 1.0);
  for (int i = 0; i < 5; ++i) stats.frame(start + milliseconds(1000 + 300 * i), {}, 1.0);
  for (int i = 0; i <= 10; ++i)
    stats.frame(start + milliseconds(5000 + 20 * i), {start + milliseconds(5000 + 20 * i - 10)}, 1.0);
  EXPECT_NEAR(stats.figures().fps_while_cutting, 50.0, 1e-6);
  EXPECT_EQ(stats.figures().frames, 27u);
}

TEST(FrameStats, a_frame_between_two_changes_counts_though_the_bur_alone_has_moved) {
  FrameStats stats;
  const Clock::time_point start{};
  for (int i = 0; i <= 100; ++i) {
    const auto shown = start + milliseconds(50 * i);
    stats.frame(shown, i % 4 == 0 ? std::vector{shown - milliseconds(10)} : std::vector<Clock::time_point>{}, 1.0);
  }
  EXPECT_NEAR(stats.figures().fps_while_cutting, 20.0, 1e-6);
  EXPECT_EQ(stats.figures().changed_frames, 26u);
}

TEST(FrameStats, the_slow_tail_is_in_p95_and_not_in_the_median) {
  FrameStats stats;
  const Clock::time_point start{};
  for (int i = 0; i < 100; ++i) {
    const auto shown = start + milliseconds(30 * i);
    stats.frame(shown, {shown - milliseconds(i % 10 == 0 ? 200 : 40)}, 1.0);
  }
  EXPECT_NEAR(stats.figures().latency_p50_ms, 40.0, 1e-3);
  EXPECT_NEAR(stats.figures().latency_p95_ms, 200.0, 1e-3);
}

TEST(FrameStats, nothing_shown_is_zero_and_not_a_number_out_of_nowhere) {
  const FrameFigures f = FrameStats().figures();
  EXPECT_EQ(f.fps_while_cutting, 0);
  EXPECT_EQ(f.latency_p95_ms, 0);
}

TEST(FrameStats, the_file_that_the_environment_names_gets_them_as_json) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("frames.json"));
  FrameStats stats;
  stats.frame(Clock::time_point{}, {Clock::time_point{} - milliseconds(35)}, 9.0);
  qputenv("CUSP_FRAME_STATS", path.toUtf8());
  stats.write_where_asked();
  qunsetenv("CUSP_FRAME_STATS");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QJsonObject read = QJsonDocument::fromJson(file.readAll()).object();
  EXPECT_EQ(read[QStringLiteral("frames")].toInt(), 1);
  EXPECT_NEAR(read[QStringLiteral("latency_p50_ms")].toDouble(), 35.0, 1e-3);
}

}  // namespace
}  // namespace cusp::test
