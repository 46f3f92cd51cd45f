// Figures of the performance page, against closed forms and published values.

#include <gtest/gtest.h>

#include "tests/modules.h"
#include "ui/admin/figures.h"

namespace cusp::test {
namespace {

HistoryRow attempt(int student, int number, double score, double seconds = 300) {
  HistoryRow r;
  r.student.uuid.bytes[15] = static_cast<std::uint8_t>(student);
  r.attempt = number;
  r.score = score;
  r.passed = true;
  r.elapsed_us = static_cast<std::uint64_t>(seconds * 1e6);
  return r;
}

TEST(Quantile, interpolates_between_order_statistics) {
  // Type 7 of 1, 2, 3, 4: R's quantile(1:4, c(.25, .5, .75)) is 1.75, 2.5, 3.25.
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.9), 7);
}

TEST(Wilson, gives_the_published_interval) {
  // Newcombe 1998, table I: 81 of 263 -> 0.2553 to 0.3662; 0 of 20 -> 0 to 0.1611.
  EXPECT_NEAR(wilson_95(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(wilson_95(81, 263).high, 0.3662, 5e-5);
  EXPECT_NEAR(wilson_95(0, 20).low, 0.0, 1e-12);
  EXPECT_NEAR(wilson_95(0, 20).high, 0.1611, 5e-5);
}

TEST(Figures, count_graded_attempts_only) {
  std::vector<HistoryRow> rows = {attempt(1, 1, 60, 100), attempt(1, 2, 80, 200), attempt(2, 1, 90, 300)};
  rows.front().passed = false;
  rows.push_back(HistoryRow{});  // broke off: no score
  const Figures f = figures_of(rows);
  EXPECT_EQ(f.attempts, 3);
  EXPECT_EQ(f.students, 2);
  EXPECT_EQ(f.passed, 2);
  EXPECT_DOUBLE_EQ(*f.median_score, 80);
  EXPECT_DOUBLE_EQ(*f.median_time_s, 200);
  EXPECT_FALSE(figures_of({}).median_score.has_value());
}

TEST(Spread, counts_every_attempt_once_also_at_the_ends) {
  const std::vector<HistoryRow> rows = {attempt(1, 1, 12), attempt(1, 2, 40), attempt(1, 3, 44.9), attempt(1, 4, 45), attempt(1, 5, 100)};
  const std::vector<int> bars = spread_of(rows, 40, 5);
  ASSERT_EQ(bars.size(), 12u);
  EXPECT_EQ(bars[0], 3);  // 12, 40 and 44.9
  EXPECT_EQ(bars[1], 1);
  EXPECT_EQ(bars[11], 1);
}

TEST(Learning, needs_three_students_for_a_median) {
  const std::vector<HistoryRow> rows = {attempt(1, 1, 50), attempt(2, 1, 60), attempt(3, 1, 70), attempt(1, 2, 80), attempt(2, 2, 90)};
  const auto points = learning_of(rows);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].attempt, 1);
  EXPECT_DOUBLE_EQ(points[0].median, 60);
  EXPECT_DOUBLE_EQ(points[0].middle_half.low, 55);
}

}  // namespace
}  // namespace cusp::test
