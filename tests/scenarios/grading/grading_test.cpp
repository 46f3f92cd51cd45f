#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenarios/format/keys.h"
#include "scenarios/grading/bands.h"
#include "scenarios/grading/changes.h"
#include "scenarios/grading/default_bands.h"
#include "scenarios/grading/grader.h"
#include "scenarios/grading/report_json.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

// fail 1.0, acceptable 1.4, ideal 1.8 to 2.2, acceptable 2.6, fail 3.0
const Bands kDepth{1.0, 1.4, 1.8, 2.2, 2.6, 3.0};
const Bands kRemoved{80, 90, 97, 100, 100, 100};
const Bands kOver{0, 0, 0, 1, 2, 4};

Measure value(std::string metric, double v, double uncertainty = 0.0) { return {metric, true, v, uncertainty, "mm", {}}; }
Measure missing(std::string metric) { return {metric, false, 0.0, 0.0, "mm", {}}; }

Scenario scenario() {
  Scenario s;
  s.rubric.pass = 70;
  s.rubric.criteria = {{"target_removed", 30, kRemoved}, {"depth_mean", 20, kDepth}, {"overcut_beyond_side", 10, kOver}};
  s.rubric.critical = {"pulp_exposure"};
  return s;
}

TEST(Bands, PointsRunStraightFromFullToHalfToNone) {
  EXPECT_EQ(share_of_points(kDepth, 1.8), 1.0);
  EXPECT_EQ(share_of_points(kDepth, 2.2), 1.0);
  EXPECT_DOUBLE_EQ(share_of_points(kDepth, 1.6), 0.75);
  EXPECT_DOUBLE_EQ(share_of_points(kDepth, 1.4), 0.5);
  EXPECT_DOUBLE_EQ(share_of_points(kDepth, 1.2), 0.25);
  EXPECT_EQ(share_of_points(kDepth, 1.0), 0.0);
  EXPECT_EQ(share_of_points(kDepth, -5.0), 0.0);
  EXPECT_DOUBLE_EQ(share_of_points(kDepth, 2.4), 0.75);
  EXPECT_NEAR(share_of_points(kDepth, 2.8), 0.25, 1e-15);
  EXPECT_EQ(share_of_points(kDepth, 3.0), 0.0);
}

TEST(Bands, ANaturalEndIsFullPointsAtTheEndItself) {
  EXPECT_EQ(share_of_points(kRemoved, 100.0), 1.0);
  EXPECT_EQ(share_of_points(kOver, 0.0), 1.0);
}

TEST(Bands, AValueThatIsNoNumberHasNoPoints) {
  EXPECT_EQ(share_of_points(kDepth, std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(share_of_points(kOver, std::numeric_limits<double>::infinity()), 0.0);
}

TEST(Bands, PointsNeverRiseAwayFromTheIdeal) {
  for (const Bands& b : {kDepth, kRemoved, kOver}) {
    double last = 1.0;
    for (double v = b.ideal_hi; v < b.fail_hi + 1; v += 0.01) {
      EXPECT_LE(share_of_points(b, v), last);
      last = share_of_points(b, v);
    }
  }
}

TEST(Bands, ABandWhoseEdgeIsNearerThanTheUncertaintyIsBorderline) {
  EXPECT_EQ(band_of(kDepth, 2.0, 0.05), "ideal");
  EXPECT_EQ(band_of(kDepth, 2.17, 0.05), "borderline");
  EXPECT_EQ(band_of(kDepth, 2.4, 0.05), "acceptable");
  EXPECT_EQ(band_of(kDepth, 2.63, 0.05), "borderline");
  EXPECT_EQ(band_of(kDepth, 2.8, 0.05), "fail");
  EXPECT_EQ(band_of(kDepth, 2.2, 0.0), "ideal");
}

TEST(Bands, ANaturalEndIsNotAnEdgeAndAStepIsOne) {
  EXPECT_EQ(band_of(kRemoved, 99.9, 0.5, {0, 100}), "ideal");
  Scenario s;
  s.rubric.criteria = {{"remaining_over_pulp", 10, {0.5, 0.5, 0.5, 100, 100, 100}}, {"overcut_beyond_side", 10, kOver}};
  const Grade g = grade(s, {value("remaining_over_pulp", 0.48, 0.05), value("overcut_beyond_side", 0, 0.5)});
  EXPECT_TRUE(g.criteria[0].band == "borderline" && g.criteria[1].band == "ideal") << g.criteria[0].band << g.criteria[1].band;
}

TEST(Grade, IsTheWeightedSumOfPoints) {
  // By hand: 30 · 1 + 20 · 0.75 + 10 · 0.5 = 50 of 60.
  const Grade g = grade(scenario(), {value("target_removed", 98), value("depth_mean", 2.4), value("overcut_beyond_side", 2)});
  EXPECT_NEAR(g.score, 100.0 * 50.0 / 60.0, 1e-12);
  EXPECT_TRUE(g.passed);
  ASSERT_EQ(g.criteria.size(), 3u);
  EXPECT_EQ(g.criteria[0].reason_code, "full");
  EXPECT_EQ(g.criteria[1].reason_code, "too_deep");
  EXPECT_DOUBLE_EQ(g.criteria[1].reason_args.at("limit"), 2.2);
  EXPECT_DOUBLE_EQ(g.criteria[1].reason_args.at("lost"), 5.0 * 100 / 60);
  EXPECT_EQ(g.criteria[2].reason_code, "too_much");
}

TEST(Grade, NamesTooLittleAndTooShallow) {
  const Grade g = grade(scenario(), {value("target_removed", 85), value("depth_mean", 1.2), value("overcut_beyond_side", 0)});
  EXPECT_EQ(g.criteria[0].reason_code, "too_little");
  EXPECT_EQ(g.criteria[1].reason_code, "too_shallow");
}

TEST(Grade, LeavesUnmeasuredCriteriaOutOfTheMaximumAndListsThem) {
  const Grade g = grade(scenario(), {value("target_removed", 98), missing("depth_mean")});
  EXPECT_EQ(g.score, 100.0);
  EXPECT_EQ(g.criteria[1].band, "not_measured");
  EXPECT_EQ(g.criteria[1].points_max, 0.0);
  EXPECT_EQ(g.criteria[2].reason_code, "not_measured");  // no such measure at all
}

TEST(Grade, WithNothingMeasuredNobodyPasses) {
  const Grade g = grade(scenario(), {});
  EXPECT_EQ(g.score, 0.0);
  EXPECT_FALSE(g.passed);
}

TEST(Grade, ACriticalEventFailsTheGoAndTheScoreStands) {
  const std::vector<Measure> good = {value("target_removed", 98), value("depth_mean", 2.0), value("overcut_beyond_side", 0)};
  std::vector<Measure> exposed = good;
  exposed.push_back(value("pulp_exposure", 1));
  const Grade g = grade(scenario(), exposed);
  EXPECT_EQ(g.score, 100.0);
  EXPECT_FALSE(g.passed);
  EXPECT_EQ(g.critical, std::vector<std::string>{"pulp_exposure"});
  exposed.back().value = 0;
  EXPECT_TRUE(grade(scenario(), exposed).passed);
  exposed.back() = missing("pulp_exposure");
  EXPECT_TRUE(grade(scenario(), exposed).passed);
}

TEST(Grade, DryCuttingFailsOrCostsPointsAsTheRubricAsks) {
  Scenario s = scenario();
  s.rubric.criteria.push_back({"dry_cutting_time", 10, {0, 0, 0, 5, 10, 20}});
  s.rubric.criteria.push_back({"temperature_rise_peak", 10, {0, 0, 0, 2, 4, 5.5}});
  s.rubric.critical.push_back("dry_cutting");
  std::vector<Measure> m = {value("target_removed", 98),     value("depth_mean", 2.0), value("overcut_beyond_side", 0),
                            value("dry_cutting_time", 10),   value("temperature_rise_peak", 6),
                            value("dry_cutting", 1)};
  const Grade dry = grade(s, m);
  EXPECT_FALSE(dry.passed);
  EXPECT_THAT(dry.critical, testing::Contains("dry_cutting"));
  EXPECT_EQ(dry.criteria[3].reason_code, "too_dry");
  EXPECT_DOUBLE_EQ(dry.criteria[3].points, 5.0 * 100 / 80);
  EXPECT_DOUBLE_EQ(dry.criteria[3].reason_args.at("limit"), 5.0);
  EXPECT_EQ(dry.criteria[4].reason_code, "too_warm");
  EXPECT_DOUBLE_EQ(dry.criteria[4].points, 0.0);
  m[3].value = m[4].value = m[5].value = 0;
  const Grade wet = grade(s, m);
  EXPECT_TRUE(wet.passed);
  EXPECT_EQ(wet.score, 100.0);
  EXPECT_EQ(wet.criteria[3].reason_code, "full");
}

TEST(Grade, DoesNotDependOnTheOrderOfTheMeasures) {
  std::vector<Measure> m = {value("target_removed", 91), value("depth_mean", 2.5), value("overcut_beyond_side", 1.5)};
  const double score = grade(scenario(), m).score;
  std::reverse(m.begin(), m.end());
  EXPECT_EQ(grade(scenario(), m).score, score);
}

/// Weights and bands of the class I exercise.
Scenario class_one() {
  Scenario s;
  s.rubric.pass = 70;
  s.rubric.criteria = {{"target_removed", 30, {80, 90, 97, 100, 100, 100}},
                       {"depth_mean", 15, {1.2, 1.5, 1.65, 1.95, 2.1, 2.6}},
                       {"depth_most", 10, {0, 0, 0, 2.1, 2.3, 2.8}},
                       {"overcut_leeway_floor", 5, {0, 0, 0, 0.6, 1.2, 2.5}},
                       {"overcut_leeway_side", 5, {0, 0, 0, 2.5, 5, 10}},
                       {"overcut_beyond_floor", 15, {0, 0, 0, 0.05, 0.5, 2}},
                       {"overcut_beyond_side", 15, {0, 0, 0, 0.3, 1.5, 5}},
                       {"remaining_over_pulp", 5, {0.3, 0.5, 1, 100, 100, 100}}};
  return s;
}

/// An attempt whose only fault is that `percent` of the target is out.
std::vector<Measure> faultless(double percent) {
  return {value("target_removed", percent),     value("depth_mean", percent > 0 ? 1.8 : 0.0),
          value("depth_most", percent > 0 ? 1.9 : 0.0), value("overcut_leeway_floor", 0),
          value("overcut_leeway_side", 0),      value("overcut_beyond_floor", 0),
          value("overcut_beyond_side", 0),      value("remaining_over_pulp", 1.6)};
}

TEST(Grade, AToothThatNobodyTouchedEarnsNothing) {
  const Grade g = grade(class_one(), faultless(0));
  EXPECT_EQ(g.score, 0.0);
  for (const CriterionGrade& c : g.criteria) EXPECT_EQ(c.points, 0.0) << c.id;
  EXPECT_EQ(g.criteria[7].reason_code, "little_drilled");
  EXPECT_EQ(g.criteria[7].reason_args, (std::map<std::string, double>{{"share", 0.0}, {"lost", 5.0}}));
}

TEST(Grade, EveryOtherCriterionCountsInProportionToWhatWasDrilled) {
  // All but the target itself: 15 + 10 + 5 + 5 + 15 + 15 + 5 = 70 points. 48.5 is half of the 97 that earn full points.
  const Grade half = grade(class_one(), faultless(48.5));
  EXPECT_NEAR(half.score, 70.0 * 0.485, 1e-12);
  EXPECT_FALSE(half.passed);
  EXPECT_EQ(half.criteria[0].reason_code, "too_little");
  for (std::size_t i : {1u, 2u, 5u}) {
    EXPECT_EQ(half.criteria[i].reason_code, "little_drilled") << half.criteria[i].id;
    EXPECT_DOUBLE_EQ(half.criteria[i].reason_args.at("share"), 0.485);
    EXPECT_TRUE(half.criteria[i].counts_with_target);
    EXPECT_EQ(half.criteria[i].band, "ideal");  // the value itself is
  }
  EXPECT_DOUBLE_EQ(half.criteria[5].reason_args.at("lost"), 15 * 0.515);
  // Between half of the ideal and the ideal the share rises to 1 in a straight line: at 72.75 it is half way there.
  EXPECT_NEAR(grade(class_one(), faultless(72.75)).score, 70.0 * (0.485 + 1.0) / 2, 1e-12);
}

TEST(Grade, ATwentiethOfTheTargetEarnsAtMostFivePointsAndFails) {
  // Whatever the other criteria are, and however little of the target the rubric asks for: faultless in all of them.
  for (const double ideal : {10.0, 40.0, 97.0, 100.0}) {
    Scenario s;
    s.rubric.pass = 6;
    s.rubric.criteria = {{"target_removed", 1, {ideal - 4, ideal - 2, ideal, 100, 100, 100}}};
    std::vector<Measure> m = {value("target_removed", 5)};
    for (const char* metric : {"depth_least", "depth_mean", "depth_most", "isthmus_width", "wall_angle_buccal", "convergence_buccolingual",
                               "floor_tilt", "ridge_mesial", "cavosurface_angle", "box_height", "clearance_gingival", "time", "force_mean"}) {
      s.rubric.criteria.push_back({metric, 20, {0, 1, 2, 4, 5, 6}});
      m.push_back(value(metric, 3));
    }
    const Grade g = grade(s, m);
    EXPECT_LE(g.score, 5.0) << ideal;
    EXPECT_GT(g.score, 4.0) << ideal;
    EXPECT_FALSE(g.passed);
  }
}

TEST(Grade, FromTheIdealOnTheShareChangesNothing) {
  for (const double percent : {97.0, 98.0, 100.0}) EXPECT_EQ(grade(class_one(), faultless(percent)).score, 100.0);
}

TEST(Grade, TheGreaterOfTheTwoLossesIsTheReason) {
  const double share = 0.485 + 0.515 * (87.3 - 48.5) / 48.5;  // 0.897
  std::vector<Measure> m = faultless(87.3);
  m[6] = value("overcut_beyond_side", 1.5);                  // half of 15 by its bands, then a tenth of that
  m[4] = value("overcut_leeway_side", 2.6);                  // 0.05 of 5 by its bands, a tenth of the rest by the share
  const Grade g = grade(class_one(), m);
  EXPECT_NEAR(g.criteria[6].points, 7.5 * share, 1e-12);
  EXPECT_EQ(g.criteria[6].reason_code, "too_much");
  EXPECT_NEAR(g.criteria[6].reason_args.at("lost"), 15 - 7.5 * share, 1e-12);  // all of it, not only the bands'
  EXPECT_EQ(g.criteria[4].reason_code, "little_drilled");
}

TEST(Grade, WithoutATargetCriterionOrItsMeasureNothingIsScaled) {
  Scenario s = class_one();
  std::vector<Measure> m = faultless(10);
  m[0] = missing("target_removed");
  EXPECT_EQ(grade(s, m).score, 100.0);
  s.rubric.criteria.erase(s.rubric.criteria.begin());
  EXPECT_EQ(grade(s, faultless(10)).score, 100.0);
}

TEST(Grade, WhatIsMeasuredOverTheWholeTargetOrLesionIsNotScaled) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 10, kRemoved},
                       {"time", 10, {0, 0, 0, 300, 400, 600}},
                       {"force_peak", 10, {0, 0, 0, 1.5, 2, 3}},
                       {"removed_enamel", 10, {0, 0, 0, 5, 8, 12}},
                       {"removed_carious_dentine", 10, {1, 2, 3, 5, 6, 8}},  // must be removed: its bands ask for it
                       {"caries_left_periphery", 10, {0, 0, 0, 0.1, 1, 2}},
                       {"uncut_remainder", 10, {0, 0, 0, 1, 2, 4}}};
  const Grade idle = grade(s, {value("target_removed", 0), value("time", 0), value("force_peak", 0), value("removed_enamel", 0),
                               value("removed_carious_dentine", 0), value("caries_left_periphery", 5), value("uncut_remainder", 40)});
  EXPECT_EQ(idle.score, 0.0);
  const Grade half = grade(s, {value("target_removed", 48.5), value("removed_carious_dentine", 4), value("caries_left_periphery", 0),
                               value("uncut_remainder", 0.5)});
  for (const std::size_t i : {4u, 5u, 6u}) EXPECT_DOUBLE_EQ(half.criteria[i].points, 10.0 * 100 / 40) << half.criteria[i].id;
}

TEST(Grade, FormAndRidgesOfASmallHoleAreNoMerit) {
  Scenario s;
  s.rubric.criteria = {{"target_removed", 10, kRemoved},
                       {"wall_angle_buccal", 10, {-12, -8, -3, 3, 8, 12}},
                       {"wall_angle_lingual", 10, {1, 2, 3, 6, 8, 12}},  // no points at 0: a tapered bur's own
                       {"floor_flatness", 10, {0, 0, 0, 0.12, 0.25, 0.4}},
                       {"isthmus_width", 10, {0.6, 0.8, 0.9, 1.3, 1.6, 2}},
                       {"ridge_mesial", 10, {1, 1.2, 1.6, 100, 100, 100}}};
  const Grade hole = grade(s, {value("target_removed", 4.85), value("wall_angle_buccal", 0), value("wall_angle_lingual", 4),
                               value("floor_flatness", 0), value("isthmus_width", 1), value("ridge_mesial", 2)});
  EXPECT_DOUBLE_EQ(hole.score, 100.0 * 5 * 0.0485 / 6);  // that share of each but the target's own, which earns none below 80 %
}

TEST(DefaultBands, AreOfferedForEachMeasurementOfFormAndRise) {
  for (const char* metric : {"wall_angle_mesial", "wall_angle_distal", "wall_angle_buccal", "wall_angle_lingual",
                             "convergence_mesiodistal", "convergence_buccolingual", "floor_flatness", "floor_tilt",
                             "isthmus_width", "ridge_mesial", "ridge_distal"})
    for (const int fdi : {0, 34, 36}) {
      const std::optional<Bands> b = default_bands(metric, fdi);
      ASSERT_TRUE(b) << metric;
      const std::array edges = {b->fail_lo, b->acc_lo, b->ideal_lo, b->ideal_hi, b->acc_hi, b->fail_hi};
      EXPECT_TRUE(std::ranges::is_sorted(edges)) << metric;
    }
  for (const MetricKey& key : kMetricKeys)
    if (const auto b = default_bands(key.key, 36)) {
      const std::array edges = {b->fail_lo, b->acc_lo, b->ideal_lo, b->ideal_hi, b->acc_hi, b->fail_hi};
      EXPECT_TRUE(std::ranges::is_sorted(edges)) << key.key;
    }
  EXPECT_EQ(share_of_points(*default_bands("contact_broken", 36), 0.0), 0.0) << "a closed contact earns nothing";
  EXPECT_EQ(share_of_points(*default_bands("surface_within_200", 36), 72.0), 0.5);
  EXPECT_FALSE(default_bands("target_removed", 36));
  EXPECT_FALSE(default_bands("", 0));
  // dental.md 2.2, class I: at least 2.0 mm on a molar, 1.6 on a premolar.
  EXPECT_EQ(default_bands("ridge_mesial", 36)->ideal_lo, 2.0);
  EXPECT_EQ(default_bands("ridge_mesial", 34)->ideal_lo, 1.6);
}

TEST(Grade, PointsRiseWithTheShareAndNeverJump) {
  double last = 0.0;
  for (double percent = 0.5; percent <= 100; percent += 0.5) {
    const double score = grade(class_one(), faultless(percent)).score;
    EXPECT_GE(score, last);
    // Steepest between 90 and 97: 0.5 (15 / 7 + 70 * 0.515 / 48.5) = 1.44.
    EXPECT_LT(score - last, 2.0) << percent;
    last = score;
  }
}

TEST(Changes, NameBothEvaluatorsAndEachCriterionThatDiffers) {
  const std::vector<Measure> m = {value("target_removed", 98), value("depth_mean", 2.4), value("overcut_beyond_side", 2)};
  const Grade now = grade(scenario(), m);
  EXPECT_TRUE(changes(now, now).none());
  Grade before = now;
  before.evaluator = "3";
  before.score -= 2;
  before.passed = false;
  before.criteria[1].points -= 2;
  before.criteria[2].id = "depth_most";
  const GradeChanges c = changes(before, now);
  EXPECT_FALSE(c.none());
  EXPECT_EQ(c.evaluator_before, "3");
  EXPECT_EQ(c.evaluator_after, "14");
  EXPECT_EQ(c.score_after - c.score_before, 2.0);
  EXPECT_TRUE(!c.passed_before && c.passed_after);
  ASSERT_EQ(c.criteria.size(), 3u);
  EXPECT_EQ(c.criteria[0].id, "depth_mean");
  EXPECT_EQ(c.criteria[0].value_before, c.criteria[0].value_after);
  EXPECT_DOUBLE_EQ(*c.criteria[0].points_after - *c.criteria[0].points_before, 2.0);
  EXPECT_EQ(c.criteria[1].id, "depth_most");
  EXPECT_FALSE(c.criteria[1].value_after);
  EXPECT_EQ(c.criteria[2].id, "overcut_beyond_side");
  EXPECT_FALSE(c.criteria[2].value_before);
  before = now;
  before.critical = {"pulp_exposure"};
  EXPECT_EQ(changes(before, now).critical, before.critical);
  EXPECT_FALSE(changes(now, before).none()) << "an event that fails an attempt is a change at equal points";
}

TEST(Grade, ACriterionBeyondTheDevicesAxesIsShownWithoutPoints) {
  Scenario s = scenario();
  s.rubric.criteria[1].needs_dof = 5;
  const std::vector<Measure> measures = {value("target_removed", 98), value("depth_mean", 9.0), value("overcut_beyond_side", 0)};
  EXPECT_LT(grade(s, measures).score, 100.0) << "a device of six axes is marked";
  EXPECT_EQ(grade(s, measures, 5).score, grade(s, measures).score);
  const Grade three = grade(s, measures, 3);
  EXPECT_EQ(three.score, 100.0) << "what the student could not do is not marked";
  const CriterionGrade& depth = three.criteria[1];
  EXPECT_EQ(depth.points_max, 0.0);
  EXPECT_EQ(depth.band, "not_expressible");
  EXPECT_EQ(depth.reason_code, "needs_dof");
  EXPECT_EQ(depth.reason_args.at("value"), 5.0);
  EXPECT_EQ(depth.reason_args.at("limit"), 3.0);
  EXPECT_TRUE(depth.measure.measured) << "its value is shown";
  EXPECT_EQ(depth.measure.value, 9.0);
}

TEST(ReportJson, HasTheFieldsOfTheDesignInItsOrder) {
  std::vector<Measure> m = {value("target_removed", 98.25, 0.5), missing("depth_mean"), value("overcut_beyond_side", 0)};
  m[0].where_mm = Vec3(1, 2, 3);
  ReportHead head;
  head.session = "019a9f3c-0000-7000-8000-000000000001";
  head.student = "demo";
  head.operator_name = "expert";
  const auto json = nlohmann::ordered_json::parse(report_json(head, grade(scenario(), m)));
  std::vector<std::string> keys;
  for (const auto& [key, _] : json.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"session", "scenario", "student", "hand", "engine", "device", "duration_s", "state",
                                            "score", "score_max", "passed", "critical", "volume_hash", "criteria"}));
  keys.clear();
  for (const auto& [key, _] : json["criteria"][0].items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"id", "label", "value", "unit", "uncertainty", "measured", "band", "points",
                                            "points_max", "reason_code", "reason", "where"}));
  EXPECT_EQ(json["criteria"][0]["value"].get<double>(), 98.25);
  EXPECT_EQ(json["criteria"][0]["where"]["mm"][2].get<double>(), 3.0);
  EXPECT_TRUE(json["criteria"][1]["value"].is_null());
  EXPECT_FALSE(json["criteria"][1]["measured"].get<bool>());
}

TEST(ReportJson, TakesItsTextsFromTheCallerAndSurvivesBadUtf8) {
  ReportTexts texts;
  texts.label = [](const CriterionGrade& c) { return "label of " + c.id; };
  texts.reason = [](const CriterionGrade&) { return std::string("\xFF broken"); };
  const auto json = nlohmann::json::parse(report_json({}, grade(scenario(), {value("target_removed", 98)}), texts));
  EXPECT_EQ(json["criteria"][0]["label"], "label of target_removed");
}

}  // namespace
}  // namespace cusp::test
