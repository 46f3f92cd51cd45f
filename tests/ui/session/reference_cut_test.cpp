// The reference operator's path, played step by step.

#include "ui/session/reference_cut.h"

#include <cstdlib>
#include <gtest/gtest.h>

#include "scenarios/library/library.h"
#include "scenarios/operators/fast_cut.h"
#include "tests/modules.h"
#include "ui/session/plan_blob.h"
#include "ui/session/scene_builder.h"

namespace cusp::test {
namespace {

constexpr double kSeconds = 30;

/// A millimetre through the air, two of cutting, and up again.
Plan small_plan() {
  return {.start_mm = {0, 0, 1}, .bur = 0, .strokes = {{{0, 0, 0}, false}, {{2, 0, 0}, true}, {{2, 0, 3}, false}}};
}

TEST(PathTimeline, CutsAtOneSpeedAndMovesInAirThreeTimesAsFast) {
  const PathTimeline timeline(small_plan(), 10);
  // 1/3 mm-worth of air, 2 of cutting, 1 of air share ten seconds: 1, 6 and 3 s.
  EXPECT_EQ(timeline.at(0).pivot_mm, Vec3(0, 0, 1));
  EXPECT_FALSE(timeline.at(0.5).cut);
  EXPECT_NEAR(timeline.at(0.5).pivot_mm.z, 0.5, 1e-9);
  EXPECT_TRUE(timeline.at(4).cut);
  EXPECT_NEAR(timeline.at(4).pivot_mm.x, 1.0, 1e-9);
  EXPECT_NEAR(timeline.at(8.5).pivot_mm.z, 1.5, 1e-9);
  EXPECT_EQ(timeline.at(10).pivot_mm, Vec3(2, 0, 3));
  EXPECT_FALSE(timeline.at(10).cut);
}

TEST(PathTimeline, HandsOutEachPartOfThePathOnce) {
  const PathTimeline timeline(small_plan(), 10);
  const Plan part = timeline.between(0.5, 4);
  EXPECT_NEAR(part.start_mm.z, 0.5, 1e-9);
  ASSERT_EQ(part.strokes.size(), 2u);
  EXPECT_FALSE(part.strokes[0].cut);
  EXPECT_EQ(part.strokes[0].to_mm, Vec3(0, 0, 0));
  EXPECT_TRUE(part.strokes[1].cut);
  EXPECT_NEAR(part.strokes[1].to_mm.x, 1.0, 1e-9);
  EXPECT_TRUE(timeline.between(4, 4).strokes.empty() || timeline.between(4, 4).strokes[0].to_mm == timeline.at(4).pivot_mm);
}

struct ReferenceCutTest : testing::Test {
  ReferenceCutTest() {
    scenario.specimen.voxel_mm = 0.4;
    specimen = build_specimen(scenario, {}).value();
    plan = plan_by_name("reference", scenario, *specimen).value();
  }
  ReferenceCut cut() const { return ReferenceCut(scenario, specimen, PathTimeline(plan, kSeconds)); }

  Scenario scenario = *load_builtin("channel-1");
  std::shared_ptr<const Specimen> specimen;
  Plan plan;
};

TEST_F(ReferenceCutTest, EndsWithTheVolumeOfThePathCutAtOnce) {
  Volume at_once(specimen);
  ASSERT_TRUE(cut_along(plan, scenario, at_once));
  ReferenceCut stepwise = cut();
  for (int step = 1; step <= stepwise.last_step(); ++step) ASSERT_TRUE(stepwise.go_to(step).has_value());
  EXPECT_EQ(stepwise.last_step(), 600);
  int worst = 0;
  for (const std::int32_t brick : at_once.cut_bricks())
    for (int o = 0; o < kBrickVoxels; ++o)
      worst = std::max(worst, std::abs(int{at_once.cut_in(brick, o)} - int{stepwise.volume().cut_in(brick, o)}));
  EXPECT_LE(worst, 2);  // of 65535, by rounding where a step divides a stroke; measured 1 at four exercises
}

TEST_F(ReferenceCutTest, AStepHasTheSameVolumeHoweverItIsReached) {
  ReferenceCut forth = cut(), about = cut();
  ASSERT_TRUE(forth.go_to(250).has_value());
  for (const int step : {600, 40, 410, 0, 250}) ASSERT_TRUE(about.go_to(step).has_value());
  EXPECT_EQ(about.volume().hash(), forth.volume().hash());
  EXPECT_NE(about.volume().hash(), Volume(specimen).hash());
  ASSERT_TRUE(about.go_to(0).has_value());
  EXPECT_EQ(about.volume().hash(), Volume(specimen).hash());
}

TEST_F(ReferenceCutTest, NamesEveryBrickThatAStepChangedForthAndBack) {
  ReferenceCut moving = cut();
  const IVec3 n = specimen->brick_count();
  int before = 0;
  for (const int step : {120, 300, 299, 600, 10}) {
    ReferenceCut old = cut();
    ASSERT_TRUE(old.go_to(before).has_value());
    const auto named = moving.go_to(step);
    ASSERT_TRUE(named.has_value());
    for (int brick = 0; brick < n.x * n.y * n.z; ++brick) {
      bool differs = false;
      for (int o = 0; o < kBrickVoxels; ++o) differs = differs || old.volume().cut_in(brick, o) != moving.volume().cut_in(brick, o);
      EXPECT_TRUE(!differs || std::ranges::count(*named, brick) == 1) << "brick " << brick << " from step " << before << " to " << step;
    }
    before = step;
  }
}

TEST_F(ReferenceCutTest, APathIsReadFromItsBytesAsItWas) {
  plan.axis = {0.0, 0.6, 0.8};
  const auto bytes = plan_bytes(plan);
  const auto read = plan_from_bytes(bytes, scenario.instruments.size());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->start_mm, plan.start_mm);
  EXPECT_EQ(read->bur, plan.bur);
  EXPECT_EQ(read->axis, plan.axis);
  ASSERT_EQ(read->strokes.size(), plan.strokes.size());
  for (std::size_t i = 0; i < plan.strokes.size(); ++i) {
    EXPECT_EQ(read->strokes[i].to_mm, plan.strokes[i].to_mm);
    EXPECT_EQ(read->strokes[i].cut, plan.strokes[i].cut);
  }
}

TEST_F(ReferenceCutTest, APathIsNotReadFromFewerBytesNorWithABurThatIsMissing) {
  auto bytes = plan_bytes(plan);
  EXPECT_FALSE(plan_from_bytes(bytes, plan.bur));
  bytes.pop_back();
  EXPECT_FALSE(plan_from_bytes(bytes, scenario.instruments.size()));
  EXPECT_FALSE(plan_from_bytes({}, scenario.instruments.size()));
}

}  // namespace
}  // namespace cusp::test
