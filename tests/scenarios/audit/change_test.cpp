// How far two models' grades differ.

#include "scenarios/audit/audit.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(Change, AnOperatorBeyondTheToleranceGetsNoMoreAttempts) {
  const auto attempts = [](std::initializer_list<double> scores) {
    ModelResult out;
    for (const double score : scores) out.attempts.push_back({{"novice", 1}, {}, 0, 0}), out.attempts.back().grade.score = score;
    return out;
  };
  const ModelResult from = attempts({50, 50, 50, 50});
  EXPECT_EQ(attempts_to_decide(from, attempts({55, 54, 55, 54}), "novice", 2.0), 0);  // 4.5 ± 0.3: beyond
  EXPECT_EQ(attempts_to_decide(from, attempts({51, 50, 51, 50}), "novice", 2.0), 0);  // 0.5 ± 0.3: within
  EXPECT_EQ(attempts_to_decide(from, attempts({53, 51, 53, 51}), "novice", 2.0), 6);  // 2 ± 0.577: 4 * (0.577 / 0.5)² = 5.3
  EXPECT_EQ(attempts_to_decide(from, attempts({53, 50, 52, 49}), "novice", 2.0), 14);  // 1 ± 0.913: within, but by one error alone
  EXPECT_EQ(attempts_to_decide(from, attempts({53, 50, 52, 49}), "novice", 0.0), std::numeric_limits<int>::max());  // 1 ± 0.913
  EXPECT_EQ(attempts_to_decide(from, attempts({53, 50, 52, 49}), "novice", 1e-6), std::numeric_limits<int>::max());
  GradeChange change;
  change.score = -3.2;
  change.standard_error = 0.6;
  EXPECT_TRUE(change.decided(2.0));
  change.score = -3.1;
  EXPECT_FALSE(change.decided(2.0));
  change.score = 0.8;
  EXPECT_TRUE(change.decided(2.0));
}

TEST(Change, AMeanThatMayLieBeyondTheToleranceIsNoProof) {
  GradeChange change;
  change.score = -1.5;
  EXPECT_TRUE(change.within(2.0));
  change.standard_error = 0.6;
  EXPECT_FALSE(change.within(2.0));
  change.score = 1.5;
  EXPECT_FALSE(change.within(2.0));
}

/// Means by hand: the expert +1, +3 (mean 2, standard error 1), the novice -1, -1, 0 (mean -2/3, standard error 1/3).
TEST(Change, AMeanIsOfOneOperatorAndAPassOfMostOfItsAttempts) {
  const auto attempts = [](std::initializer_list<std::pair<const char*, double>> scores) {
    ModelResult out;
    for (const auto& [name, score] : scores) {
      ModelAttempt attempt;
      attempt.by.name = name;
      attempt.grade.score = score;
      attempt.grade.passed = score >= 70;
      out.attempts.push_back(attempt);
    }
    return out;
  };
  const ModelResult from = attempts({{"expert", 90}, {"expert", 90}, {"novice", 70}, {"novice", 71}, {"novice", 60}});
  const GradeChange change = mean_change_between(from, attempts({{"expert", 91}, {"expert", 93}, {"novice", 69}, {"novice", 70}, {"novice", 60}}));
  EXPECT_NEAR(change.score, 2.0, 1e-9);
  EXPECT_NEAR(change.standard_error, 1.0, 1e-9);
  EXPECT_EQ(change.attempts_per_operator, 2);
  EXPECT_FALSE(change.passes_alike) << "two of three novices passed, now one does";
  const GradeChange one_less = mean_change_between(from, attempts({{"expert", 90}, {"expert", 60}, {"novice", 70}, {"novice", 71}, {"novice", 60}}));
  EXPECT_FALSE(one_less.passes_alike) << "half of them is not most of them";
  EXPECT_TRUE(mean_change_between(from, attempts({{"expert", 90}, {"expert", 90}, {"novice", 71}, {"novice", 72}, {"novice", 60}})).passes_alike);
}

TEST(Change, ACriterionThatIsNoLongerMeasuredIsNoSmallChange) {
  ModelResult a, b;
  ModelAttempt attempt;
  CriterionGrade c;
  c.id = "remaining_over_pulp";
  attempt.grade.criteria = {c};
  a.attempts = {attempt};
  attempt.grade.criteria[0].measure.measured = false;
  b.attempts = {attempt};
  EXPECT_FALSE(change_between(a, b).within(100));
  EXPECT_TRUE(change_between(a, a).within(0));
}

}  // namespace
}  // namespace cusp::test
