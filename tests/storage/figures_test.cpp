/// Figures over graded attempts, against closed forms and published values.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "storage/summary/figures.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

GradedAttempt attempt(int student, int number, double score, double seconds = 300) {
  GradedAttempt a{.attempt = number, .score = score, .passed = true, .elapsed_us = static_cast<std::uint64_t>(seconds * 1e6)};
  a.student.uuid.bytes[15] = static_cast<std::uint8_t>(student);
  return a;
}
Figures figures_of(const std::vector<GradedAttempt>& attempts) {
  FigureCount count;
  for (const GradedAttempt& a : attempts) count.add(a);
  return count.figures();
}

TEST(Quantile, interpolates_between_order_statistics) {
  // Type 7 of 1, 2, 3, 4: R's quantile(1:4, c(.25, .5, .75)) is 1.75, 2.5, 3.25.
  std::vector<double> values = {4, 1, 3, 2};
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(values, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 4);
  values = {7};
  EXPECT_DOUBLE_EQ(quantile(values, 0.9), 7);
}

/// Of more values than are sorted: in steps, as a sort would give them.
TEST(Quartiles, of_many_values_are_those_of_the_sorted_ones) {
  const unsigned seed = 20261124;
  std::mt19937 random(seed);
  std::normal_distribution<double> scores(75, 12);
  std::lognormal_distribution<double> times(6, 2);
  for (const std::size_t n : {8'193u, 20'000u, 50'001u}) {
    std::vector<double> spread, skewed, few;
    for (std::size_t i = 0; i < n; ++i) {
      spread.push_back(std::clamp(scores(random), 0.0, 100.0));
      skewed.push_back(times(random));
      few.push_back(static_cast<double>(random() % 3));
    }
    for (std::vector<double>& values : {std::ref(spread), std::ref(skewed), std::ref(few)}) {
      const Quartiles found = quartiles(values);
      EXPECT_EQ(found.low, quantile(values, 0.25)) << "seed " << seed;
      EXPECT_EQ(found.median, quantile(values, 0.5)) << "seed " << seed;
      EXPECT_EQ(found.high, quantile(values, 0.75)) << "seed " << seed;
    }
  }
  EXPECT_EQ(quartiles(std::vector<double>(10'000, 3.5)).high, 3.5);
}

TEST(StudentNumbers, give_each_student_one_number) {
  StudentNumbers numbers;
  std::vector<UserId> students;
  EXPECT_FALSE(numbers.knows(UserId::make()));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    students.push_back(UserId::make());
    EXPECT_EQ(numbers.number(students.back()), i);
  }
  for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(numbers.number(students[i]), i);
  EXPECT_EQ(numbers.size(), 1000u);
  EXPECT_TRUE(numbers.knows(students[999]));
  EXPECT_FALSE(numbers.knows(UserId::make()));
}

TEST(Wilson, gives_the_published_interval) {
  // Newcombe 1998, table I: 81 of 263 -> 0.2553 to 0.3662; 0 of 20 -> 0 to 0.1611.
  EXPECT_NEAR(wilson_95(81, 263).low, 0.2553, 5e-5);
  EXPECT_NEAR(wilson_95(81, 263).high, 0.3662, 5e-5);
  EXPECT_NEAR(wilson_95(0, 20).low, 0.0, 1e-12);
  EXPECT_NEAR(wilson_95(0, 20).high, 0.1611, 5e-5);
}

TEST(DesignEffect, is_the_published_one) {
  // Litters of Weil 1970 in Rao and Scott 1992, table 1: control 1.232, treated 3.953; package PF of R: 1.232495 and 3.952861.
  const std::vector<PassCount> control = {{13, 13}, {12, 12}, {9, 9},  {9, 9},  {8, 8},   {8, 8}, {13, 12}, {12, 11},
                                          {10, 9},  {10, 9},  {9, 8},  {13, 11}, {5, 4},  {7, 5}, {10, 7},  {10, 7}};
  const std::vector<PassCount> treated = {{12, 12}, {11, 11}, {10, 10}, {9, 9}, {11, 10}, {10, 9}, {10, 9}, {9, 8},
                                          {9, 8},   {5, 4},   {9, 7},   {7, 4}, {10, 5},  {6, 3},  {10, 3}, {7, 0}};
  EXPECT_NEAR(design_effect(control), 1.232495, 5e-7);
  EXPECT_NEAR(design_effect(treated), 3.952861, 5e-7);
}

TEST(SharePassed, of_students_with_many_attempts_each_is_as_sure_as_fewer_independent_ones) {
  // 6 of 12; the squares sum to 9, the variance is 4/3 * 9/144 = 1/12, the effect 12 * 1/12 / 0.25 = 4.
  // Wilson of 3 at 0.5: z / (2 sqrt(3 + z^2)) to either side.
  const Interval found = *share_passed_95(std::vector<PassCount>{{3, 3}, {3, 3}, {3, 0}, {3, 0}});
  EXPECT_NEAR(found.low, 0.5 - 0.374665, 1e-5);
  EXPECT_NEAR(found.high, 0.5 + 0.374665, 1e-5);
}

TEST(SharePassed, of_one_attempt_each_is_wilson_s_and_of_one_student_there_is_none) {
  const Interval one_each = *share_passed_95(std::vector<PassCount>{{1, 1}, {1, 1}, {1, 0}});
  EXPECT_EQ(one_each.low, wilson_95(2, 3).low);
  EXPECT_EQ(one_each.high, wilson_95(2, 3).high);
  EXPECT_EQ(share_passed_95(std::vector<PassCount>{{10, 10}, {10, 10}})->low, wilson_95(2, 2).low) << "all passed: two students";
  EXPECT_EQ(share_passed_95(std::vector<PassCount>{{10, 0}, {10, 0}})->high, wilson_95(0, 2).high);
  EXPECT_FALSE(share_passed_95(std::vector<PassCount>{{90, 54}}));
  EXPECT_FALSE(share_passed_95({}));
}

TEST(SharePassed, is_never_surer_than_independent_attempts) {
  // Every student passes half: less spread than chance.
  EXPECT_EQ(share_passed_95(std::vector<PassCount>{{2, 1}, {2, 1}, {2, 1}})->low, wilson_95(3, 6).low);
}

TEST(Figures, count_attempts_students_and_passes) {
  std::vector<GradedAttempt> attempts = {attempt(1, 1, 60, 100), attempt(1, 2, 80, 200), attempt(2, 1, 90, 300)};
  attempts.front().passed = false;
  const Figures f = figures_of(attempts);
  EXPECT_EQ(f.attempts, 3);
  EXPECT_EQ(f.students, 2);
  EXPECT_EQ(f.passed, 2);
  EXPECT_EQ(f.passed_95->low, share_passed_95(std::vector<PassCount>{{2, 1}, {1, 1}})->low);
  EXPECT_EQ(f.last_attempt, 2);
  EXPECT_DOUBLE_EQ(*f.median_score, 80);
  EXPECT_DOUBLE_EQ(f.middle_half.low, 70);
  EXPECT_DOUBLE_EQ(*f.median_time_s, 200);
  EXPECT_FALSE(figures_of({}).median_score.has_value());
}

TEST(Figures, have_a_pass_mark_only_if_all_attempts_share_it) {
  std::vector<GradedAttempt> attempts = {attempt(1, 1, 60), attempt(2, 1, 70)};
  EXPECT_FALSE(figures_of(attempts).pass_mark);
  for (GradedAttempt& a : attempts) a.pass_mark = 70;
  EXPECT_EQ(figures_of(attempts).pass_mark, 70.0);
  attempts.back().pass_mark = 60;
  EXPECT_FALSE(figures_of(attempts).pass_mark);
}

TEST(Spread, counts_every_attempt_once_also_at_the_ends) {
  const Figures f = figures_of({attempt(1, 1, -3), attempt(1, 2, 0), attempt(1, 3, 44.9), attempt(1, 4, 45), attempt(1, 5, 100)});
  EXPECT_EQ(f.spread[0], 2);
  EXPECT_EQ(f.spread[8], 1);
  EXPECT_EQ(f.spread[9], 1);
  EXPECT_EQ(f.spread[19], 1);
}

TEST(Spread, a_sum_that_passes_stands_on_the_mark_s_side) {
  const double sum = 9.7 + 10.1 + 11.3 + 12.6 + 8.9 + 7.3 + 10.1;  // 69.99999999999999
  ASSERT_LT(sum, 70);
  const Figures f = figures_of({attempt(1, 1, sum), attempt(2, 1, 69.9)});
  EXPECT_EQ(f.spread[14], 1);
  EXPECT_EQ(f.spread[13], 1);
}

TEST(Learning, needs_three_students_for_a_median) {
  const auto points =
      figures_of({attempt(1, 1, 50), attempt(2, 1, 60), attempt(3, 1, 70), attempt(1, 2, 80), attempt(2, 2, 90)}).learning;
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].attempt, 1);
  EXPECT_DOUBLE_EQ(points[0].median, 60);
  EXPECT_DOUBLE_EQ(points[0].middle_half.low, 55);
}

TEST(Learning, three_attempts_of_two_students_are_no_three_students) {
  // The same attempt number at two exercises.
  EXPECT_TRUE(figures_of({attempt(1, 1, 50), attempt(2, 1, 60), attempt(1, 1, 70)}).learning.empty());
}

}  // namespace
}  // namespace cusp::test
