// Another bur comes into use where a hand could change it: in the air, and where it fits.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "engine/removal/carve.h"
#include "engine/step/state.h"
#include "engine/tool/heads.h"
#include "engine/tool/swept.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr std::uint16_t kThin = 0;

Bur ball(double radius_mm) {
  Bur bur;
  bur.name = "ball";
  bur.radius_mm = radius_mm;
  bur.neck_radius_mm = 0.5 * radius_mm;
  return bur;
}

Bur with_head(double radius_mm, std::optional<Profile> head) {
  Bur bur = ball(radius_mm);
  bur.head = *head;
  return bur;
}

/// A ball for the hole, then wider ones, another head of its width, and a thinner one.
std::shared_ptr<Scene> scene_with_burs(Method method) {
  auto scene = scene_of(block_of(0.1), method, 0.4, 10.0);
  scene->burs.push_back(ball(0.5));
  scene->burs.push_back(ball(0.9));
  scene->burs.push_back(with_head(0.4, flat_head(0.4, 0.4, 1.5)));
  scene->burs.push_back(with_head(0.7, pear_head(0.7, 0.3, 0.4, 1.8)));
  scene->burs.push_back(ball(0.25));
  return scene;
}

StepInput wanting(std::uint16_t bur, Vec3 device_mm, CutButton button = CutButton::up) {
  StepInput input = input_at(device_mm, button);
  input.bur = bur;
  return input;
}

TEST(BurChanges, leave_no_voxel_that_another_head_lowers_with_the_sweep_of_a_ball) {
  auto specimen = Specimen::build(block_of(0.1), Reading::banded);
  Volume volume(specimen);
  volume.keep_sweeps();
  Sweeps sweeps(Vec3(0.0), 1000);
  const Vec3 from(-0.5, 0.0, 1.8), to(-0.45, 0.0, 1.8), below(0.0, 0.0, -0.2);
  const std::int32_t id = sweeps.add(from, to, 0.5);
  carve_run(volume, sweeps, {id, id});
  const Volume before = volume;
  carve_sweep(volume, from + below, to + below, with_head(0.5, flat_head(0.5, 0.5, 1.0)), Vec3(0.0, 0.0, 1.0));
  int lowered = 0, naming = 0;
  const IVec3 size = volume.grid().size;
  IVec3 v;
  for (v.z = 0; v.z < size.z; ++v.z)
    for (v.y = 0; v.y < size.y; ++v.y)
      for (v.x = 0; v.x < size.x; ++v.x) {
        if (volume.cut(v) >= before.cut(v)) continue;
        ++lowered;
        const std::int32_t* ids = volume.sweeps_of(specimen->brick_index(v >> 3));
        if (ids != nullptr && ids[brick_offset(v.x & 7, v.y & 7, v.z & 7)] != Volume::kNoSweep) ++naming;
      }
  EXPECT_GT(lowered, 2000);
  EXPECT_EQ(naming, 0) << "a later ball would be held by a wall that is gone";
}

/// mm: how deep the deepest solid voxel's centre lies in the head.
double depth_in_tissue(const StepState& state) {
  const Bur& bur = state.scene().burs[state.last().bur];
  const Grid& grid = state.volume().grid();
  double deepest = 0.0;
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x)
        if (state.volume().s(v) > kSolid / 2)
          deepest = std::max(deepest, -head_distance(bur, state.last().axis, grid.centre_mm(v) - state.last().proxy_mm));
  return deepest;
}

/// A hole as wide as the thin ball, 1.2 mm deep in the block; the bur stands on its floor, pressed.
Vec3 drill_a_hole(StepState& state) {
  Vec3 at(0.0, 0.0, 2.6);
  for (int k = 0; k < 4000 && !(state.last().tick > 0 && state.last().proxy_mm.z < 1.2); ++k) {
    at.z = std::max(1.0, at.z - 0.005);
    step(state, wanting(kThin, at, CutButton::pressed));
  }
  return at;
}

class BurChange : public testing::TestWithParam<Method> {};

TEST_P(BurChange, waits_while_the_bur_is_held_against_tissue) {
  StepState state(scene_with_burs(GetParam()));
  approach(state, {0, 0, 3.0}, {0, 0, 2.2});
  ASSERT_TRUE(state.last().contact);
  for (int k = 0; k < 50; ++k) EXPECT_EQ(step(state, wanting(5, {0, 0, 2.2})).bur, kThin);
  for (int k = 0; k < 100; ++k) step(state, wanting(5, {0, 0, 2.2 + 0.02 * k}));
  EXPECT_EQ(state.last().bur, 5) << "in the air it is changed";
}

INSTANTIATE_TEST_SUITE_P(Methods, BurChange, testing::Values(Method::surface, Method::occupancy, Method::ray, Method::gradient));

class WiderBur : public testing::TestWithParam<std::uint16_t> {};

TEST_P(WiderBur, waits_in_a_hole_that_holds_it_not_and_removes_nothing_there) {
  StepState state(scene_with_burs(Method::surface));
  Vec3 at = drill_a_hole(state);
  ASSERT_LT(state.last().proxy_mm.z, 1.25);
  for (int k = 0; k < 100; ++k) ASSERT_EQ(step(state, wanting(GetParam(), at, CutButton::pressed)).bur, kThin) << "pressed, tick " << k;
  // Lifted within the hole, with the handpiece running, then out of it.
  bool looked = false;
  for (; at.z < 5.0; at.z += 0.01) {
    const StepOutput out = step(state, wanting(GetParam(), at, CutButton::pressed));
    if (at.z < 1.7) {
      ASSERT_EQ(out.bur, kThin) << "at " << at.z;
    }
    ASSERT_FALSE(out.infeasible) << "at " << at.z;
    if (out.bur == GetParam() && (!std::exchange(looked, true) || out.tick % 25 == 0)) {
      ASSERT_LT(depth_in_tissue(state), 0.002) << "at " << at.z;
    }
  }
  EXPECT_EQ(state.last().bur, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Burs, WiderBur, testing::Values(std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}, std::uint16_t{4}));

TEST(ThinnerBur, is_changed_in_the_hole_once_it_touches_nothing) {
  StepState state(scene_with_burs(Method::surface));
  Vec3 at = drill_a_hole(state);
  for (; at.z < 1.6; at.z += 0.01) step(state, wanting(5, at));
  EXPECT_EQ(state.last().bur, 5);
  EXPECT_LT(state.last().proxy_mm.z, 1.7) << "still in the hole";
}

TEST(BurChanges, are_the_same_whatever_is_kept_from_tick_to_tick) {
  StepState keeps(scene_with_burs(Method::surface)), forgets(scene_with_burs(Method::surface));
  for (int k = 0; k < 3000; ++k) {
    const Vec3 at(0.5 * std::sin(0.011 * k), 0.4 * std::sin(0.017 * k), 2.1 + 0.8 * std::sin(0.009 * k));
    const StepInput input = wanting(static_cast<std::uint16_t>(k / 170 % 6), at, k % 300 < 200 ? CutButton::pressed : CutButton::up);
    forgets.inner().surface->forget();
    const StepOutput a = step(keeps, input), b = step(forgets, input);
    ASSERT_EQ(a.bur, b.bur) << "tick " << k;
    ASSERT_EQ(a.proxy_mm, b.proxy_mm) << "tick " << k;
  }
  EXPECT_EQ(keeps.hash(), forgets.hash());
}

}  // namespace
}  // namespace cusp::test
