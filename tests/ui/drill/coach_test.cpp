#include "tests/modules.h"
#include "ui/drill/coach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/session/bur_depth.h"

namespace cusp::test {
namespace {

/// A slot 1.6 mm wide along x, floor 2 mm below the face at z = 0.
TargetShape slot() {
  Outline target;
  target.shape = "channel";
  target.paths = {{{-4, 0, -2}, {4, 0, -2}}};
  target.width_mm = 1.6;
  target.depth_mm = 2.0;
  target.top_mm = 0.0;
  return TargetShape(region_of(target));
}

LiveView drilling(Vec3 pivot, double radius) {
  LiveView live;
  live.removed_mm3[index_of(Tissue::plastic)] = 1.0;
  live.output.contact = true;
  live.output.proxy_mm = pivot;
  live.bur_depth_mm = -(pivot.z - radius);
  return live;
}

TEST(BurDepth, of_a_bur_that_leans_is_that_of_its_lowest_edge) {
  Bur bur;
  bur.radius_mm = 0.5;
  const OnHalf outline[] = {{-0.5, 0.0}, {-0.5, 0.5}, {2.0, 0.5}, {2.0, 0.0}};
  for (std::size_t i = 0; i < 3; ++i) ASSERT_TRUE(bur.head.add({outline[i], outline[i + 1], {}, 0.0}));
  StepOutput output;
  output.proxy_mm = {0, 0, -1};
  EXPECT_NEAR(bur_depth_mm(slot(), output, bur), 1.5, 1e-12);
  const double sine = 0.5, cosine = std::sqrt(0.75);  // 30 degrees
  output.axis = {sine, 0, cosine};
  EXPECT_NEAR(bur_depth_mm(slot(), output, bur), 1.0 + 0.5 * cosine + 0.5 * sine, 1e-12);
  bur.head = {};
  EXPECT_NEAR(bur_depth_mm(slot(), output, bur), 1.5, 1e-12) << "of a ball it is its radius";
}

const Leeway kLeeway{0.3, 0.3};
constexpr double kRadius = 0.5;

TEST(Coach, before_anything_is_cut_it_shows_how_to_begin) {
  EXPECT_EQ(coach({}, slot(), kLeeway, kRadius).what, Coach::begin);
}

TEST(Coach, above_the_floor_it_shows_how_much_is_left) {
  const CoachLine line = coach(drilling({0, 0, -0.9}, kRadius), slot(), kLeeway, kRadius);
  EXPECT_EQ(line.what, Coach::deeper);
  EXPECT_NEAR(line.mm, 0.6, 1e-9);  // floor at 2.0, tip at 0.9 + 0.5
}

TEST(Coach, near_the_floor_it_speaks_before_it_is_reached_and_no_more_on_it) {
  const CoachLine line = coach(drilling({0, 0, -1.2}, kRadius), slot(), kLeeway, kRadius);
  EXPECT_EQ(line.what, Coach::nearly);
  EXPECT_NEAR(line.mm, 0.3, 1e-9);
  EXPECT_EQ(tone_of(line, kLeeway), CoachTone::look);
  EXPECT_EQ(coach(drilling({0, 0, -1.5}, kRadius), slot(), kLeeway, kRadius).what, Coach::sideways);
}

TEST(Coach, of_a_step_it_knows_the_floor_under_the_bur) {
  Region region;
  region.kind = RegionKind::joined;
  for (const double depth : {1.5, 3.0}) {
    Outline half;
    half.shape = "channel";
    half.paths = {{{depth < 2 ? -4.0 : 1.0, 0, -1}, {depth < 2 ? 0.0 : 4.0, 0, -1}}};
    half.width_mm = 1.6;
    half.depth_mm = depth;
    half.top_mm = 0.0;
    region.parts.push_back(region_of(half));
  }
  const TargetShape step(region);
  EXPECT_EQ(coach(drilling({-3, 0, -1.0}, kRadius), step, kLeeway, kRadius).what, Coach::sideways);
  EXPECT_EQ(coach(drilling({3, 0, -1.0}, kRadius), step, kLeeway, kRadius).what, Coach::deeper);
}

TEST(Coach, at_the_floor_it_shows_sideways_and_below_it_how_far_too_deep) {
  EXPECT_EQ(coach(drilling({0, 0, -1.45}, kRadius), slot(), kLeeway, kRadius).what, Coach::sideways);
  const CoachLine line = coach(drilling({0, 0, -1.75}, kRadius), slot(), kLeeway, kRadius);
  EXPECT_EQ(line.what, Coach::too_deep);
  EXPECT_NEAR(line.mm, 0.25, 1e-9);
}

TEST(Coach, beyond_the_leeway_at_the_side_comes_before_depth) {
  // Pivot 0.7 mm off the middle, wall at 0.8: the bur's side is 0.4 mm beyond it.
  const CoachLine line = coach(drilling({0, 0.7, -0.9}, kRadius), slot(), kLeeway, kRadius);
  EXPECT_EQ(line.what, Coach::outside);
  EXPECT_NEAR(line.mm, 0.4, 1e-9);
}

TEST(Coach, an_open_pulp_comes_before_all_else_and_thin_dentine_before_depth) {
  LiveView live = drilling({0, 0.7, -1.9}, kRadius);
  live.over_pulp_mm = 0.3;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius), (CoachLine{Coach::over_pulp, 0.3}));
  live.pulp_exposed = true;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::pulp_open);
}

TEST(Coach, with_nearly_all_out_it_shows_finish_and_lifted_off_it_is_quiet) {
  LiveView live = drilling({0, 0, -1.4}, kRadius);
  live.target_removed_percent = 98;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::finish);
  live.target_removed_percent = 50;
  live.output.contact = false;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::carry_on);
}

TEST(Coach, without_a_target_it_has_nothing_to_say) {
  EXPECT_EQ(coach(drilling({0, 0, -1}, kRadius), TargetShape(Region{}), kLeeway, kRadius).what, Coach::quiet);
}

TEST(Coach, of_a_place_that_the_bur_has_left_it_shows_nothing) {
  LiveView live = drilling({0, 0.7, -2.9}, kRadius);
  live.over_pulp_mm = 0.3;
  live.target_removed_percent = 50;
  ASSERT_NE(coach(live, slot(), kLeeway, kRadius).what, Coach::carry_on);
  live.output.contact = false;  // it hangs in the air
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::carry_on);
  live.pulp_exposed = true;  // of the tooth, wherever the bur is
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::pulp_open);
}

TEST(Coach, a_cut_that_counts_for_nothing_comes_before_all_else_and_needs_no_target) {
  LiveView live = drilling({0, 0.7, -1.9}, kRadius);
  live.pulp_exposed = live.cut_ignored = true;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::held_cut);
  EXPECT_EQ(coach(live, TargetShape(Region{}), kLeeway, kRadius).what, Coach::held_cut);
  live.phase = LoopPhase::paused;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::quiet) << "first comes Resume";
}

TEST(Coach, while_the_attempt_stands_or_its_device_is_gone_it_is_quiet) {
  for (const LoopPhase phase : {LoopPhase::paused, LoopPhase::held}) {
    LiveView live = drilling({0, 0, -2.9}, kRadius);
    live.phase = phase;
    EXPECT_TRUE(stands_still(live));
    EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::quiet);
  }
  LiveView live = drilling({0, 0, -2.9}, kRadius);
  live.device = Sample::Status::gone;
  EXPECT_EQ(coach(live, slot(), kLeeway, kRadius).what, Coach::quiet);
}

TEST(Coach, below_the_floor_is_worth_a_look_within_the_leeway_and_wrong_beyond_it) {
  EXPECT_EQ(tone_of({Coach::too_deep, 0.2}, kLeeway), CoachTone::look);
  EXPECT_EQ(tone_of({Coach::too_deep, 0.3}, kLeeway), CoachTone::look);
  EXPECT_EQ(tone_of({Coach::too_deep, 2.7}, kLeeway), CoachTone::bad);
  EXPECT_EQ(tone_of({Coach::outside, 0.4}, kLeeway), CoachTone::bad);
  EXPECT_EQ(tone_of({Coach::pulp_open, 0}, kLeeway), CoachTone::bad);
  EXPECT_EQ(tone_of({Coach::over_pulp, 0.4}, kLeeway), CoachTone::look);
  for (const Coach good : {Coach::begin, Coach::deeper, Coach::sideways, Coach::finish, Coach::carry_on, Coach::held_cut, Coach::quiet}) {
    EXPECT_EQ(tone_of({good, 0.6}, kLeeway), CoachTone::good);
  }
}

TEST(Coach, speaks_again_when_the_kind_changes_or_the_value_by_two_tenths) {
  EXPECT_TRUE(worth_saying({Coach::deeper, 0.6}, {Coach::sideways, 0.6}));
  EXPECT_FALSE(worth_saying({Coach::too_deep, 0.3}, {Coach::too_deep, 0.4}));
  EXPECT_TRUE(worth_saying({Coach::too_deep, 0.3}, {Coach::too_deep, 0.5}));
  EXPECT_TRUE(worth_saying({Coach::deeper, 0.5}, {Coach::deeper, 0.3}));
  EXPECT_FALSE(worth_saying({Coach::finish, 0}, {Coach::finish, 0}));
}

}  // namespace
}  // namespace cusp::test
