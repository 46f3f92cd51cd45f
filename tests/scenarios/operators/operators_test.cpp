#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scenarios/operators/expert.h"
#include "scenarios/operators/faults.h"
#include "scenarios/library/library.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/shapes/target.h"
#include "scenarios/specimens/specimens.h"
#include "tests/engine/volume/carved.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/scenarios/operators/attempt.h"

namespace cusp::test {
namespace {

/// A small block of dentine with pulp below, and a slot of 1.4 x 0.8 x 0.8 mm in it: an attempt takes seconds.
Scenario small_slot() {
  Scenario s;
  s.tissues = {{Tissue::dentine, 2, 2}, {Tissue::pulp, 1, 4}};
  Bur bur;
  bur.radius_mm = 0.3;
  bur.neck_radius_mm = 0.15;  // a neck of two thirds of the head is held by what a side stroke of 0.25 mm leaves above it
  s.instruments = {bur};
  s.target.outline.paths = {{Vec3(-0.3, 0, 0), Vec3(0.3, 0, 0)}};
  s.target.outline.width_mm = 0.8;
  s.target.outline.depth_mm = 0.8;
  s.target.outline.corner_radius_mm = 0.3;
  s.leeway.floor_mm = 0.2;
  s.leeway.side_mm = 0.2;
  s.rubric.pass = 70;
  s.rubric.criteria = {{"target_removed", 40, {80, 90, 97, 100, 100, 100}},
                       {"depth_mean", 20, {0.4, 0.6, 0.7, 0.9, 1.0, 1.2}},
                       {"overcut_beyond_floor", 20, {0, 0, 0, 0.02, 0.1, 0.3}},
                       {"overcut_beyond_side", 20, {0, 0, 0, 0.02, 0.1, 0.3}}};
  s.rubric.critical = {"pulp_exposure"};
  return s;
}
std::shared_ptr<const Specimen> small_block() {
  Grid g;
  g.voxel_mm = 0.1;
  g.size = IVec3(50, 46, 44);
  g.origin_mm = Vec3(-2.45, -2.25, -3.45);
  return carved::specimen(
      g, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -1.5), Vec3(2.0, 1.8, 1.5)); },
      [](Vec3 p) { return p.z < -2.2 ? Tissue::pulp : Tissue::dentine; });
}

struct Bench {
  Scenario scenario = small_slot();
  std::shared_ptr<const Specimen> specimen = small_block();
  Reference reference{scenario, specimen};
  attempt::Result run(std::string_view name, std::uint64_t seed = 1) const {
    return attempt::run(scenario, reference, specimen, *operator_by_name(name, scenario, *specimen, seed), 2000);
  }
  static std::string reason(const attempt::Result& r, std::string_view id) {
    for (const CriterionGrade& c : r.grade.criteria)
      if (c.id == id) return c.reason_code;
    return "no such criterion";
  }
};

TEST(Expert, DrillsWithATurbineAndKeepsTheToothCoolAndTheSameOperatorWithoutCoolantFails) {
  Bench bench;
  bench.scenario.phenomena = {"spindle-turbine", "vibration", "heat"};
  bench.scenario.tissues = {{Tissue::dentine, 2, 0.2}, {Tissue::pulp, 1, 4}};  // slow: dry for long enough, whatever the path
  bench.scenario.rubric.critical.push_back("dry_cutting");
  bench.scenario.rubric.criteria.push_back({"dry_cutting_time", 10, {0, 0, 0, 1, 5, 10}});
  const Reference reference(bench.scenario, bench.specimen);
  const auto run = [&](std::string_view name) {
    return attempt::run(bench.scenario, reference, bench.specimen, *operator_by_name(name, bench.scenario, *bench.specimen), 2000);
  };
  const attempt::Result wet = run("expert"), dry = run("dry");
  EXPECT_TRUE(wet.grade.passed) << wet.grade.score;
  EXPECT_EQ(wet.get("dry_cutting_time").value, 0.0);
  EXPECT_LT(wet.get("temperature_rise_peak").value, 0.5);
  EXPECT_FALSE(dry.grade.passed) << dry.get("temperature_rise_peak").value;
  EXPECT_EQ(dry.grade.critical, std::vector<std::string>{"dry_cutting"});
  EXPECT_GT(dry.get("dry_cutting_time").value, 10.0);
  EXPECT_TRUE(dry.get("dry_cutting").where_mm.has_value());
  EXPECT_EQ(Bench::reason(dry, "dry_cutting_time"), "too_dry");
}

TEST(Plan, KeepsTheBurInsideTheTarget) {
  Scenario s = small_slot();
  const auto block = small_block();
  for (const char* shape : {"channel", "outline", "box"}) {
    s.target.outline.shape = shape;
    s.target.outline.box_size_mm = {2.0, 1.2, 0};
    if (s.target.outline.shape == "outline") s.target.outline.paths = {{Vec3(-0.8, 0, 0), Vec3(0, 0.3, 0), Vec3(0.8, 0, 0)}, {Vec3(0, 0.3, 0), Vec3(0, 1, 0)}};
    const Plan plan = plan_target(s, *block);
    const TargetShape target(s.target);
    ASSERT_GT(plan.strokes.size(), 10u) << shape;
    Vec3 from = plan.start_mm;
    for (const Stroke& stroke : plan.strokes) {
      for (int i = 0; i <= 8 && stroke.cut; ++i) {
        const Vec3 p = from + (stroke.to_mm - from) * (i / 8.0);
        EXPECT_LE(target.outline_mm({p.x, p.y}), -0.3 + 1e-9) << shape;
        EXPECT_GE(p.z, target.floor_mm() + 0.3 - 1e-9) << shape;
      }
      from = stroke.to_mm;
    }
    EXPECT_GT(from.z, 0.3) << "ends above the specimen";
  }
}

TEST(Plan, TakesTheLargestBurThatFits) {
  Scenario s = small_slot();
  Bur small, large;
  small.radius_mm = 0.2;
  large.radius_mm = 0.5;
  s.instruments = {small, s.instruments[0], large};
  EXPECT_EQ(plan_target(s, *small_block()).bur, 1);
  s.target.outline.corner_radius_mm = 0.1;  // none fits: the smallest
  EXPECT_EQ(plan_target(s, *small_block()).bur, 0);
}

TEST(Plan, IsEmptyWithoutTargetOrInstruments) {
  Scenario s = small_slot();
  s.instruments.clear();
  EXPECT_TRUE(plan_target(s, *small_block()).strokes.empty());
  s = small_slot();
  s.target.outline.paths.clear();
  EXPECT_TRUE(plan_target(s, *small_block()).strokes.empty());
  EXPECT_TRUE(expert(s, *small_block()).done());
}

TEST(Plan, FollowsTheReadingOfTheMethod) {
  const auto strokes = [](Method method) {
    Scenario s = small_slot();
    s.method = method;
    std::vector<Vec3> out;
    for (const Stroke& stroke : plan_target(s, *small_block()).strokes) out.push_back(stroke.to_mm);
    return out;
  };
  EXPECT_EQ(strokes(Method::ray), strokes(Method::occupancy));
  EXPECT_EQ(strokes(Method::penalty), strokes(Method::surface));
  EXPECT_EQ(strokes(Method::gradient), strokes(Method::surface));
  EXPECT_NE(strokes(Method::ray), strokes(Method::surface));
}

/// A world with a ledge at x = 0: below the block's top nothing passes it from left to right but what came from above.
/// `closed`: nor from above.
enum class Ledge : std::uint8_t { open_above, closed };
struct LedgeAttempt {
  std::size_t skipped = 0;  // strokes
  std::size_t lifts = 0;    // to above the block
  double clock_s = 0;
};
LedgeAttempt over_a_ledge(Ledge ledge) {
  const Scenario s = small_slot();
  ScriptedOperator scripted = expert(s, *small_block());
  StepOutput o;
  o.proxy_mm = o.device_mm = scripted.start_mm();
  LedgeAttempt out;
  bool above = true, was_above = true;
  while (!scripted.done()) {
    const Sample sample = scripted.next(o, 0.002);
    Vec3 to = sample.position_mm;
    above = o.proxy_mm.z > 0.4;
    if (!above && o.proxy_mm.x <= 0.0 && to.x > 0.0) to = Vec3(0.0, to.y, to.z);
    if (ledge == Ledge::closed && above) to.z = std::max(to.z, 0.41);
    out.lifts += above && !was_above ? 1 : 0;
    was_above = above;
    o.device_mm = sample.position_mm;
    o.proxy_mm = to;
    o.contact = glm::length(to - sample.position_mm) > 1e-9;
    o.stiffness_n_per_mm = o.contact ? 2.0 : 0.0;
    o.force_n = o.contact ? 2.0 * (to - sample.position_mm) : Vec3(0.0);
  }
  out.skipped = scripted.strokes_skipped();
  out.clock_s = scripted.clock_s();
  return out;
}
TEST(ScriptedOperator, RepositionsTheBurFurtherAlongTheStrokeIfItIsHeld) {
  const LedgeAttempt attempt = over_a_ledge(Ledge::open_above);
  EXPECT_EQ(attempt.skipped, 0u);
  EXPECT_GT(attempt.lifts, 2u);
}
TEST(ScriptedOperator, SkipsAStrokeThatCannotBeReachedFromAbove) {
  const LedgeAttempt attempt = over_a_ledge(Ledge::closed);
  EXPECT_GT(attempt.skipped, 0u);
  EXPECT_LT(attempt.clock_s, 1200.0) << "it was through before its time was";
}

/// An operator in a tissue as hard as enamel, with a turbine that stalls at little more than the full force; two minutes.
struct TurbineAttempt {
  double stood_s = 0;  // pressed, and the handpiece still
  std::size_t skipped = 0;
};
enum class Push : std::uint8_t { light, heavy };
TurbineAttempt with_a_turbine(Push push) {
  Bench bench;
  bench.scenario.tissues = {{Tissue::dentine, 3, 0.5}, {Tissue::pulp, 1, 4}};
  bench.scenario.device.full_force_n = 3.9;  // stalls at 2.5 N x 0.5 mm / 0.3 mm
  bench.scenario.phenomena = {"spindle-turbine"};
  OperatorStyle style = steady_style(bench.scenario, *bench.specimen, 1);
  style.muscles.tremor_mm = 0.05;
  style.light = push == Push::light;
  style.max_s = 120.0;
  OperatorPort port(ScriptedOperator(plan_target(bench.scenario, *bench.specimen, {}), style, bench.scenario), 0.008);
  StepState state(attempt::scene_of(bench.scenario, bench.specimen));
  StepInput last;
  TurbineAttempt out;
  for (Sample sample = port.wait({}); sample.status != Sample::Status::gone; sample = port.wait({})) {
    last = quantise(sample, 8000, last);
    const StepOutput o = step(state, last);
    if (last.cutting() && o.contact && !(o.spindle_rpm > 0.0f)) out.stood_s += 0.008;
    port.write({o.force_n, o.proxy_mm, o.stiffness_n_per_mm, Vec3(0, 0, 1), o.contact, o.faulted});
  }
  out.skipped = port.scripted_operator().strokes_skipped();
  return out;
}
TEST(ScriptedOperator, PushesATurbineNoHarderThanRemovesMostAndReleasesAStall) {
  const TurbineAttempt light = with_a_turbine(Push::light), heavy = with_a_turbine(Push::heavy);
  EXPECT_LT(light.stood_s, 0.3 * heavy.stood_s);  // 3.6 and 24.2 s of 120
  EXPECT_LT(light.skipped, heavy.skipped);      // 3 and 10
}

/// A world in which the proxy follows the device no faster than `speed`.
std::size_t skipped_at(double speed_mm_s, double& clock_s, std::uint64_t seed = 1) {
  const Scenario s = small_slot();
  ScriptedOperator scripted = expert(s, *small_block(), seed);
  StepOutput o;
  o.proxy_mm = o.device_mm = scripted.start_mm();
  while (!scripted.done()) {
    const Sample sample = scripted.next(o, 0.002);
    const Vec3 gap = sample.position_mm - o.proxy_mm;
    const double far = glm::length(gap);
    const double reach = speed_mm_s * 0.002;
    o.device_mm = sample.position_mm;
    o.proxy_mm += far > reach ? gap * (reach / far) : gap;
    o.contact = far > reach;
    o.stiffness_n_per_mm = o.contact ? 2.0 : 0.0;
    o.force_n = 2.0 * (o.proxy_mm - o.device_mm);
  }
  clock_s = scripted.clock_s();
  return scripted.strokes_skipped();
}

TEST(ScriptedOperator, ReachesEveryPlaceIfNothingResists) {
  double clock = 0;
  EXPECT_EQ(skipped_at(1e9, clock), 0u);
  EXPECT_LT(clock, 60.0);
}

TEST(ScriptedOperator, SkipsBlockedStrokesAndEnds) {
  double clock = 0;
  EXPECT_GT(skipped_at(0.0, clock), 10u);
  EXPECT_LE(clock, OperatorStyle{}.max_s + 0.01);
}

TEST(ScriptedOperator, IsTheSameForTheSameSeedAndNotForAnother) {
  double a = 0, b = 0, other = 0;
  skipped_at(1e9, a, 5);
  skipped_at(1e9, b, 5);
  skipped_at(1e9, other, 6);
  EXPECT_EQ(a, b);
  EXPECT_NE(a, other);
}

TEST(ScriptedOperator, HasAName) {
  const Scenario s = small_slot();
  const auto block = small_block();
  for (const char* name : {"expert", "novice", "competent", "too_deep", "too_shallow", "shaky", "off_outline", "pulp", "dry"})
    EXPECT_TRUE(operator_by_name(name, s, *block).has_value()) << name;
  EXPECT_FALSE(operator_by_name("Expert", s, *block).has_value());
}

TEST(Expert, EarnsTheMarksByDrilling) {
  const Bench bench;
  const attempt::Result r = bench.run("expert");
  EXPECT_TRUE(r.grade.passed) << r.grade.score;
  EXPECT_LT(r.get("overcut_beyond_floor").value + r.get("overcut_beyond_side").value, 0.01);  // 0 for seeds 1 to 10
  EXPECT_EQ(r.overflow, 0u);
  EXPECT_FALSE(r.faulted);
  // Four of sixty seeds dig deeper than this, where the hand sets down again, and sixteen leave 0.2 to 3.4 percent: the median of
  // three counts.
  std::array<double, 3> depth{}, removed{};
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const attempt::Result one = bench.run("expert", i + 1);
    depth[i] = one.get("depth_mean").value;
    removed[i] = one.get("target_removed").value;
  }
  std::ranges::sort(depth);
  std::ranges::sort(removed);
  EXPECT_NEAR(depth[1], 0.8, 0.05);
  EXPECT_GT(removed[1], 97.0);
}

TEST(Expert, EarnsTheMarksWithTheOtherMethodsOnABandToo) {
  for (const Method method : {Method::penalty, Method::gradient}) {
    Bench bench;
    bench.scenario.method = method;
    const attempt::Result r = bench.run("expert");
    EXPECT_TRUE(r.grade.passed) << key_of(method) << " " << r.grade.score;  // measured 100 and 100
    EXPECT_EQ(r.overflow, 0u) << key_of(method);
  }
}

/// What it loses it loses on the bands' slopes: a small change of the cut shows in its marks.
/// Whether it passes is left to the exercise: here it has 69 points of the 70 that a pass takes, the others 100 and 0.
TEST(Faults, TheCompetentOperatorLosesSomeMarks) {
  const Bench bench;
  const attempt::Result competent = bench.run("competent");
  EXPECT_LT(competent.grade.score, bench.run("expert").grade.score - 3.0);
  EXPECT_GT(competent.grade.score, bench.run("novice").grade.score + 3.0);
  // Attempts differ by some 0.02 mm, by where the hand retracts and sets down again.
  const int attempts = full_run() ? 3 : 1;
  double depth = competent.get("depth_mean").value;
  for (std::uint64_t seed = 2; seed <= static_cast<std::uint64_t>(attempts); ++seed) depth += bench.run("competent", seed).get("depth_mean").value;
  EXPECT_NEAR(depth / attempts, 0.8 + 0.6 * bench.scenario.leeway.floor_mm, 0.05);
}

/// An attempt that fails, with this reason for each of these criteria.
attempt::Result failed_attempt(std::string_view name, const std::map<std::string, std::string>& reasons) {
  attempt::Result r = Bench().run(name);
  EXPECT_FALSE(r.grade.passed) << name;
  for (const auto& [criterion, reason] : reasons) EXPECT_EQ(Bench::reason(r, criterion), reason) << name << " " << criterion;
  return r;
}

TEST(Faults, TooDeepIsGradedTooDeep) {
  const auto r = failed_attempt("too_deep", {{"depth_mean", "too_deep"}, {"overcut_beyond_floor", "too_much"}});
  EXPECT_NEAR(r.get("depth_mean").value, 1.6, 0.05);
}

TEST(Faults, TooShallowIsGradedTooShallow) {
  failed_attempt("too_shallow", {{"depth_mean", "too_shallow"}, {"target_removed", "too_little"}});
}

TEST(Faults, OffTheOutlineIsGradedAtTheSide) {
  // The floor was kept, but that counts only as far as the target came out.
  failed_attempt("off_outline", {{"overcut_beyond_side", "too_much"}, {"overcut_beyond_floor", "little_drilled"}});
}

TEST(Faults, ThePulpIsACriticalEventThoughTheScoreStands) {
  const Bench bench;
  const attempt::Result r = bench.run("pulp");
  EXPECT_FALSE(r.grade.passed);
  EXPECT_EQ(r.grade.critical, std::vector<std::string>{"pulp_exposure"});
}

TEST(Faults, TheNoviceFailsDeepAndOverTheEdge) {
  failed_attempt("novice", {{"depth_mean", "too_deep"}, {"overcut_beyond_side", "too_much"}});
}

TEST(PaperBlock, TheExpertPassesAndTheNoviceFailsTooDeep) {
  const auto scenario = load_builtin("paper-block");
  ASSERT_TRUE(scenario);
  const auto dense = make_specimen(scenario->specimen, ".");
  ASSERT_TRUE(dense);
  const auto specimen = Specimen::build(*dense, reading_of(scenario->method));
  const Reference reference(*scenario, specimen);
  const attempt::Result good = attempt::run(*scenario, reference, specimen, *operator_by_name("expert", *scenario, *specimen));
  EXPECT_TRUE(good.grade.passed) << good.grade.score;
  const attempt::Result bad = attempt::run(*scenario, reference, specimen, *operator_by_name("novice", *scenario, *specimen));
  EXPECT_FALSE(bad.grade.passed) << bad.grade.score;
  EXPECT_EQ(Bench::reason(bad, "depth_mean"), "too_deep");
}

}  // namespace
}  // namespace cusp::test
