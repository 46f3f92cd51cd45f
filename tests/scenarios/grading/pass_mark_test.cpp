/// The pass mark: whoever has it passes, also where rounding leaves the sum short of it.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "scenarios/grading/grader.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(PassMark, IsReachedByItsOwnValueAndMissedByTheLeastStepThatPeopleRead) {
  EXPECT_TRUE(reaches(70.0, 70.0));
  EXPECT_TRUE(reaches(69.99999999999999, 70.0));
  EXPECT_FALSE(reaches(69.99, 70.0));
  EXPECT_FALSE(reaches(69.9, 70.0));
  EXPECT_FALSE(reaches(std::numeric_limits<double>::quiet_NaN(), 70.0));
}

/// Weights and shares in tenths, so that whole numbers tell whether the mark is reached.
TEST(PassMark, DecidesAsExactArithmeticDoes) {
  std::mt19937 random(20261120);
  const auto draw = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  int short_of_mark = 0;
  for (int round = 0; round < 20'000; ++round) {
    Scenario s;
    std::vector<Measure> measures;
    long long points = 0, most = 0;
    for (int i = draw(3, 7); i > 0; --i) {
      const int weight = draw(1, 30), tenths = draw(4, 10);
      const std::string metric = "width_" + std::to_string(i);
      s.rubric.criteria.push_back({metric, static_cast<double>(weight), Bands{0, 5, 10, 10, 10, 10}});  // share = value / 10
      measures.push_back({metric, true, static_cast<double>(tenths), 0.0, "mm", {}});
      points += weight * tenths;
      most += 10 * weight;
    }
    const long long mark = 100 * points / most;
    s.rubric.pass = static_cast<double>(mark);
    const Grade at = grade(s, measures);
    EXPECT_TRUE(at.passed) << at.score << " of " << mark;
    short_of_mark += at.score < s.rubric.pass ? 1 : 0;
    s.rubric.pass = static_cast<double>(mark) + 1;
    EXPECT_FALSE(grade(s, measures).passed);
  }
  EXPECT_GT(short_of_mark, 10) << "the draws hold sums that rounding leaves short";
}

}  // namespace
}  // namespace cusp::test
