#include "scenarios/grading/maxima.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "scenarios/grading/changes.h"
#include "scenarios/grading/grader.h"
#include "scenarios/grading/report_json.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using ::testing::ElementsAre;

const Bands kAll{0, 0, 0, 100, 100, 100};
const Bands kMostRemoved{80, 90, 97, 100, 100, 100};

Scenario weighted(const std::vector<double>& weights) {
  Scenario s;
  for (std::size_t i = 0; i < weights.size(); ++i)
    s.rubric.criteria.push_back({"metric_" + std::to_string(i), weights[i], kAll});
  return s;
}

Grade graded(const std::vector<std::pair<double, double>>& points) {
  Grade g;
  double sum = 0, most = 0;
  for (const auto& [p, max] : points) {
    CriterionGrade& c = g.criteria.emplace_back();
    c.points = p;
    c.points_max = max;
    c.measure.measured = max > 0;
    sum += p;
    most += max;
  }
  g.score = most > 0 ? 100 * sum / most : 0;
  return g;
}

double sum_of_maxima(const std::vector<ScaledPoints>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0, [](double s, const ScaledPoints& p) { return s + p.points_max; });
}
double sum_of_points(const std::vector<ScaledPoints>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0, [](double s, const ScaledPoints& p) { return s + p.points; });
}

TEST(ScaledMaxima, WeightsOf110AreShownOf100) {
  // 30/110 = 27.27, 15/110 = 13.64, 10/110 = 9.09, 5/110 = 4.55: floors sum to 99.6, four tenths go to .64, .55, .55, .55.
  const auto maxima = scaled_maxima(weighted({30, 15, 10, 5, 5, 20, 20, 5}));
  EXPECT_NEAR(std::accumulate(maxima.begin(), maxima.end(), 0.0), 100.0, 1e-9);
  EXPECT_DOUBLE_EQ(maxima[0], 27.3);
  EXPECT_DOUBLE_EQ(maxima[2], 9.1);
}

TEST(ScaledMaxima, WeightsOf100StayWhatTheyAre) {
  EXPECT_THAT(scaled_maxima(weighted({35, 15, 10, 10, 10, 10, 10})), ElementsAre(35, 15, 10, 10, 10, 10, 10));
}

TEST(ScaledMaxima, ThirdsGiveTheOddTenthToTheFirst) {
  EXPECT_THAT(scaled_maxima(weighted({1, 1, 1})), ElementsAre(33.4, 33.3, 33.3));
}

TEST(ScaledMaxima, NothingIsSharedWhereNothingHasAWeight) {
  EXPECT_THAT(scaled_maxima(weighted({})), ElementsAre());
  EXPECT_THAT(scaled_maxima(weighted({0, 0})), ElementsAre(0, 0));
  EXPECT_THAT(scaled_maxima(weighted({0, 5, NAN, -3})), ElementsAre(0, 100, 0, 0));
}

TEST(ScaledMaxima, SumToAHundredAndStayWithinATenthOfTheirShare) {
  const std::uint64_t seed = 19;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> weights(1 + random() % 12);
    for (double& w : weights) w = random() % 4 == 0 ? 0.001 * double(1 + random() % 1000) : double(1 + random() % 40);
    const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto maxima = scaled_maxima(weighted(weights));
    EXPECT_NEAR(std::accumulate(maxima.begin(), maxima.end(), 0.0), 100.0, 1e-9);
    for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(maxima[i], 100 * weights[i] / whole, 0.1 + 1e-9);
  }
}

TEST(ScaledPoints, OfAnOldGradeInWeightsSumToItsScore) {
  const auto p = scaled_points(graded({{30, 30}, {7.5, 15}, {0, 10}, {5, 5}, {2, 50}}));
  EXPECT_NEAR(sum_of_maxima(p), 100.0, 1e-9);
  EXPECT_NEAR(sum_of_points(p), 40.5, 1e-9);  // 44.5 / 110 = 40.45
  EXPECT_EQ(p[0].points, p[0].points_max);
  EXPECT_EQ(p[2].points, 0.0);
  EXPECT_EQ(p[3].points, p[3].points_max);
}

TEST(ScorePerPoint, IsReadFromTheGreatestPoints) {
  Grade old = graded({{30, 30}, {7.5, 15}, {0, 5}});
  old.evaluator = "1";  // before the first one whose change is described
  EXPECT_EQ(score_per_point(old), 2.0);
  EXPECT_NEAR(old.criteria[1].points * score_per_point(old), scaled_points(old)[1].points, 0.05);
  for (CriterionGrade& c : old.criteria) c.points = 0;
  EXPECT_EQ(score_per_point(old), 2.0) << "a score of 0 is of both";
  old.criteria.clear();
  EXPECT_EQ(score_per_point(old), 1.0);
}

TEST(PointsOfScore, AreFullWhereTheTableShowsFullOnes) {
  Grade thirds = graded({{1, 10}, {10, 10}, {10, 10}});
  for (std::size_t i = 0; i < 3; ++i) thirds.criteria[i].id = std::to_string(i);
  EXPECT_EQ(points_of_score(thirds, "0", 10), 33.4);
  EXPECT_EQ(points_of_score(thirds, "1", 10), 33.3);
  EXPECT_NEAR(points_of_score(thirds, "0", 9), 30, 1e-9);
  EXPECT_EQ(points_of_score(thirds, "0", 0), 0);
  EXPECT_NEAR(points_of_score(thirds, "another", 3), 10, 1e-9);
}

TEST(ScorePerPoint, IsOneOfWhatIsGradedToday) {
  const Scenario s = weighted({30, 15, 10, 5, 5, 20, 20, 5});  // they sum to 110
  std::vector<Measure> measures;
  for (const Criterion& c : s.rubric.criteria) measures.push_back({c.metric, true, 1, 0, "mm", {}});
  EXPECT_EQ(score_per_point(grade(s, measures)), 1.0);
  measures.resize(3);  // the rest could not be measured
  EXPECT_EQ(score_per_point(grade(s, measures)), 1.0);
}

TEST(ScaledPoints, WhatWasNotMeasuredHasNoneOfNone) {
  const auto p = scaled_points(graded({{30, 30}, {0, 0}, {10, 10}}));
  EXPECT_EQ(p[0].points_max, 75.0);
  EXPECT_EQ(p[1].points_max, 0.0);
  EXPECT_EQ(p[2].points, 25.0);
}

TEST(ScaledPoints, AreNeverMoreThanTheirMaximumNorFullOrNoneWhenTheyAreNot) {
  const std::uint64_t seed = 20;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int n = 0; n < 2000; ++n) {
    std::vector<std::pair<double, double>> all(1 + random() % 10);
    bool some_between = false;
    for (auto& [p, max] : all) {
      max = random() % 8 == 0 ? 0.0 : double(1 + random() % 40);
      const auto kind = random() % 3;
      p = kind == 0 ? max : kind == 1 ? 0.0 : max * 0.001 * double(random() % 1000);
      some_between = some_between || (p > 0.05 * max && p < 0.95 * max);
    }
    const Grade g = graded(all);
    const auto shown = scaled_points(g);
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_LE(shown[i].points, shown[i].points_max);
      EXPECT_GE(shown[i].points, 0.0);
      if (all[i].first == all[i].second) {
        EXPECT_EQ(shown[i].points, shown[i].points_max);
      }
      if (all[i].first == 0.0) {
        EXPECT_EQ(shown[i].points, 0.0);
      }
    }
    if (g.score > 0) {
      EXPECT_NEAR(sum_of_maxima(shown), 100.0, 1e-9);
    }
    EXPECT_NEAR(sum_of_points(shown), shown_score(g.score), some_between ? 1e-9 : 0.51);
  }
}

TEST(ScaledPoints, AddUpToNoWholePointThatTheScoreHasNotReached) {
  EXPECT_NEAR(shown_score(69.96), 69.9, 1e-12);
  EXPECT_NEAR(sum_of_points(scaled_points(graded({{39.98, 60}, {29.98, 40}}))), 69.9, 1e-9);
  EXPECT_NEAR(sum_of_points(scaled_points(graded({{59.98, 60}, {39.99, 40}}))), 99.9, 1e-9);
  EXPECT_NEAR(sum_of_points(scaled_points(graded({{40, 60}, {30, 40}}))), 70.0, 1e-9);
}

TEST(ScaledPoints, OfABrokenGradeAreNone) {
  Grade g = graded({{1, 1}, {1, 1}});
  g.criteria[0].points = NAN;
  g.criteria[1].points_max = INFINITY;
  const auto p = scaled_points(g);
  EXPECT_EQ(p[0].points, 0.0);
  EXPECT_EQ(p[0].points_max, 100.0);
  EXPECT_EQ(p[1].points_max, 0.0);
}

TEST(Grade, PointsOfAnyWeightsAreOfAHundred) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 80, kMostRemoved}, {"uncut_remainder", 30, kAll}};
  const Grade g = grade(s, {{"target_removed", true, 90, 0, "%", {}}, {"uncut_remainder", true, 1, 0, "mm3", {}}});
  EXPECT_DOUBLE_EQ(g.criteria[0].points_max + g.criteria[1].points_max, 100.0);
  EXPECT_DOUBLE_EQ(g.criteria[0].points + g.criteria[1].points, g.score);
  EXPECT_DOUBLE_EQ(g.criteria[0].reason_args.at("lost"), g.criteria[0].points_max / 2);
}

TEST(Grade, MarksWhatCountsOnlyAsFarAsTheTargetWasCut) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 50, kMostRemoved}, {"overcut_beyond_side", 30, {0, 0, 0, 1, 2, 3}},
                       {"depth_mean", 20, {1, 1.5, 1.8, 2.2, 2.5, 3}}};
  const auto marks = [](const Grade& g) {
    std::vector<bool> out;
    for (const CriterionGrade& c : g.criteria) out.push_back(c.counts_with_target);
    return out;
  };
  Grade g = grade(s, {});
  EXPECT_THAT(marks(g), ElementsAre(false, true, true));
  for (CriterionGrade& c : g.criteria) c.counts_with_target = false;  // as the records give it back
  mark_counted_with_target(g, s.rubric);
  EXPECT_THAT(marks(g), ElementsAre(false, true, true));
  g.evaluator = "3";  // counted the depth whole
  mark_counted_with_target(g, s.rubric);
  EXPECT_THAT(marks(g), ElementsAre(false, true, false));
  s.rubric.criteria.erase(s.rubric.criteria.begin());
  EXPECT_THAT(marks(grade(s, {})), ElementsAre(false, false));
}

TEST(Grade, StatesTheShareByTheRuleOfItsEvaluator) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 50, {80, 90, 96, 100, 100, 100}}, {"depth_mean", 20, {1, 1.5, 1.8, 2.2, 2.5, 3}}};
  Grade g = grade(s, {{"target_removed", true, 24.0, 0.0, "%", {}}});
  EXPECT_DOUBLE_EQ(share_counted(g, s.rubric, "depth_mean"), 0.24);
  g.evaluator = "3";
  EXPECT_DOUBLE_EQ(share_counted(g, s.rubric, "depth_mean"), 0.25);
  s.rubric.criteria.erase(s.rubric.criteria.begin());
  EXPECT_EQ(share_counted(g, s.rubric, "depth_mean"), 1.0);
}

TEST(Grade, OneOfSeveralTargetsThatIsLeftOutCostsItsPoints) {
  Scenario s;
  s.rubric.criteria = {{"target_removed@a", 20, kMostRemoved}, {"depth_mean@a", 20, kAll}, {"target_removed@b", 20, kMostRemoved}, {"depth_mean@b", 20, kAll}};
  std::vector<Measure> cut_one = {{"target_removed@a", true, 100.0, 0.0, "%", {}}, {"depth_mean@a", true, 2.0, 0.0, "mm", {}},
                                  {"target_removed@b", true, 0.0, 0.0, "%", {}},   {"depth_mean@b", false, 0.0, 0.0, "mm", {}}};
  const Grade left_out = grade(s, cut_one);
  EXPECT_DOUBLE_EQ(left_out.score, 50.0) << "a depth that is not there is no full one";
  EXPECT_DOUBLE_EQ(left_out.criteria[3].points_max, 25.0);
  EXPECT_EQ(left_out.criteria[3].reason_code, "little_drilled");
  EXPECT_FALSE(left_out.criteria[3].measure.measured);
  // Cut, but too coarse to be measured: nobody's fault.
  cut_one[2].value = 100.0;
  const Grade unmeasured = grade(s, cut_one);
  EXPECT_DOUBLE_EQ(unmeasured.score, 100.0);
  EXPECT_EQ(unmeasured.criteria[3].reason_code, "not_measured");
}

TEST(Grade, OneOfSeveralTargetsCountsAsFarAsItWasCutItself) {
  Scenario s;
  s.rubric.criteria = {{"target_removed@a", 20, kMostRemoved}, {"depth_mean@a", 20, kAll}, {"target_removed@b", 20, kMostRemoved}, {"depth_mean@b", 20, kAll}};
  const std::vector<Measure> cut_one = {{"target_removed@a", true, 100.0, 0.0, "%", {}}, {"depth_mean@a", true, 2.0, 0.0, "mm", {}},
                                        {"target_removed@b", true, 5.0, 0.0, "%", {}},   {"depth_mean@b", true, 2.0, 0.0, "mm", {}}};
  const Grade g = grade(s, cut_one);
  EXPECT_DOUBLE_EQ(g.criteria[1].points, 25.0);
  EXPECT_DOUBLE_EQ(g.criteria[3].points, 0.05 * 25.0);
  EXPECT_EQ(g.criteria[3].reason_code, "little_drilled");
  EXPECT_DOUBLE_EQ(share_counted(g, s.rubric, "depth_mean@b"), 0.05);
  EXPECT_EQ(share_counted(g, s.rubric, "depth_mean@a"), 1.0);
  // What is of the whole counts with the mean of both.
  s.rubric.criteria.push_back({"ridge_mesial", 20, kAll});
  std::vector<Measure> ridge = cut_one;
  ridge.push_back({"ridge_mesial", true, 2.0, 0.0, "mm", {}});
  EXPECT_DOUBLE_EQ(grade(s, ridge).criteria[4].points, 0.525 * 20.0);
  s.rubric.criteria.pop_back();
  // Without a share of its own it counts with the whole target's.
  s.rubric.criteria[2].metric = "target_removed";
  std::vector<Measure> whole = cut_one;
  whole[2].metric = "target_removed";
  EXPECT_DOUBLE_EQ(grade(s, whole).criteria[3].points, 0.05 * 25.0);
  EXPECT_EQ(grade(s, {{"depth_mean@b", true, 2.0, 0.0, "mm", {}}}).criteria[3].reason_code, "full");
}

TEST(LossReasons, PutTheOpenedPulpFirstThenTheGreatestLoss) {
  Grade g = graded({{29, 30}, {0, 20}, {10, 10}, {0, 30}, {5, 10}});
  g.criteria[3].reason_code = "little_drilled";
  g.critical = {"dry_cutting", "pulp_exposure"};
  std::vector<std::string> order;
  for (const LossReason& r : loss_reasons(g))
    order.push_back(r.critical.empty() ? std::to_string(r.criterion) : r.critical);
  EXPECT_THAT(order, ElementsAre("pulp_exposure", "dry_cutting", "1", "4", "0", "3"));
}

TEST(LossReasons, LeaveOutALossThatDoesNotShow) {
  EXPECT_TRUE(loss_reasons(graded({{29.99, 30}, {70, 70}})).empty());
  EXPECT_EQ(loss_reasons(graded({{29.9, 30}, {70, 70}})).size(), 1u);
  EXPECT_TRUE(loss_reasons({}).empty());
}

TEST(ReportJson, PointsAddUpAndTheirMaximaAreAHundred) {
  Scenario s = weighted({30, 15, 10, 5, 5, 20, 20, 5});
  std::vector<Measure> measures;
  for (const Criterion& c : s.rubric.criteria) measures.push_back({c.metric, true, 1, 0, "mm", {}});
  const auto json = nlohmann::json::parse(report_json({}, grade(s, measures)));
  double most = 0;
  for (const auto& c : json["criteria"]) most += c["points_max"].get<double>();
  EXPECT_NEAR(most, 100.0, 1e-9);
}

TEST(Grade, ATargetThatIsLeftOutCostsItsPointsThoughTheRubricAsksForTheWholeAlone) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 10, kMostRemoved}, {"depth_mean@a", 45, kAll}, {"depth_mean@b", 45, kAll}};
  const std::vector<Measure> cut_one = {{"target_removed", true, 80.0, 0.0, "%", {}}, {"depth_mean@a", true, 2.0, 0.0, "mm", {}},
                                        {"depth_mean@b", false, 0.0, 0.0, "mm", {}}, {"target_removed@b", true, 0.0, 0.0, "%", {}}};
  EXPECT_DOUBLE_EQ(grade(s, cut_one).criteria[2].points_max, 45.0);
  s.rubric.criteria[2].needs_dof = 5;
  EXPECT_EQ(grade(s, cut_one, 3).criteria[2].points_max, 0.0) << "what the device cannot express is not marked";
}

TEST(Changes, NameATargetThatNowCostsItsPoints) {
  Grade before, after;
  before.criteria.resize(1);
  before.criteria[0].id = "depth_mean@b";
  before.criteria[0].measure.measured = false;
  after = before;
  after.criteria[0].points_max = 25;
  EXPECT_EQ(changes(before, after).criteria.size(), 1u);
}

}  // namespace
}  // namespace cusp::test
