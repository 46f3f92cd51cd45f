// What a tick may do when a cut ends: edges are found some a tick, and the rest carried on as part of the state.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/step/state.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


constexpr double kResolvingRadiusMm = 0.4;

std::shared_ptr<const Scene> resolving_scene() {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.5, 1.5, 1.2)); }), Method::surface, kResolvingRadiusMm, 6.0);
  return scene;
}

/// Scratches side by side across the top, each up and down on its way: ridges between them and across them.
StepInput scratching(int k) {
  const int line = k / 200;
  const double along = k % 200 / 200.0;
  return input_at({-0.5 + (line % 2 == 0 ? along : 1.0 - along), -0.5 + 0.17 * line,
                   1.2 + kResolvingRadiusMm - 0.35 + 0.12 * std::sin(0.11 * k)},
                  CutButton::pressed);
}
constexpr int kScratching = 7 * 200 - 100;

std::uint64_t resolved(StepState& state) { return state.inner().surface->cut_surface().cells_resolved(); }

int unresolved_parts(StepState& state) {
  int count = 0;
  for (const std::int32_t brick : state.volume().cut_bricks())
    count += std::popcount(state.inner().surface->cut_surface().unresolved(state.volume(), brick));
  return count;
}

StepState scratched(const std::shared_ptr<const Scene>& scene) {
  StepState state(scene);
  step(state, input_at({-0.9, -0.6, 2.4}));
  for (int k = 0; k < kScratching; ++k) step(state, scratching(k));
  return state;
}

/// The bur stays at its place of the button's release.
StepInput resting() {
  StepInput out = scratching(kScratching - 1);
  out.buttons = 0;
  return out;
}

TEST(Resolving, releasing_the_button_finds_no_more_edges_a_tick_than_it_has_time_for) {
  StepState state = scratched(resolving_scene());
  ASSERT_GT(state.volume().cut_bricks().size(), 8u);
  std::uint64_t before = resolved(state), most = 0, all = 0;
  int unresolved = unresolved_parts(state), most_parts = 0, busy = 0;
  for (int k = 0; k < 300; ++k) {
    step(state, resting());
    const std::uint64_t now = resolved(state);
    most = std::max(most, now - before);
    all += now - before;
    before = now;
    const int left = unresolved_parts(state);
    most_parts = std::max(most_parts, unresolved - left);
    busy += left < unresolved;
    unresolved = left;
  }
  // 32 voxels that the surface passes, or a slice of 64: of those a cell each at most. Found all at once it takes one tick
  // for all.
  EXPECT_LE(most, 64u);
  EXPECT_GT(all, 20u);
  EXPECT_LE(2 * most, all);
  EXPECT_GE(busy, 4) << "measured " << busy;
  EXPECT_LT(most_parts, 60);
}

TEST(Resolving, all_about_the_bur_is_resolved_soon_after) {
  StepState state = scratched(resolving_scene());
  ASSERT_GT(unresolved_parts(state), 0);
  int ticks = 0, left = unresolved_parts(state), last = -1;
  for (; left != last || ticks < 5; ++ticks) {
    last = left;
    step(state, resting());
    left = unresolved_parts(state);
    ASSERT_LT(ticks, 200);
  }
  // What is far from the bur waits until it comes there.
  EXPECT_GT(left, 0);
  const std::uint64_t before = resolved(state);
  for (int k = 0; k < 50; ++k) step(state, resting());
  EXPECT_EQ(resolved(state), before);
}

TEST(Resolving, a_key_state_taken_half_way_goes_on_to_the_same_hash) {
  const auto scene = resolving_scene();
  StepState whole = scratched(scene);
  for (int k = 0; k < 4; ++k) step(whole, resting());
  const int unresolved = unresolved_parts(whole);
  auto resumed = StepState::restore(scene, whole.save());
  ASSERT_TRUE(resumed);
  EXPECT_EQ(unresolved_parts(*resumed), unresolved);
  EXPECT_EQ(resumed->hash(), whole.hash());
  EXPECT_EQ(resumed->save(), whole.save());
  for (int k = 0; k < 400; ++k) {
    // Rests, then goes back over the ridges, with the button down for some of the way.
    StepInput input = k < 100 ? resting() : scratching(kScratching - 1 - 4 * (k - 100));
    if (k < 250 || k > 300) input.buttons = 0;
    const StepOutput x = step(whole, input);
    const StepOutput y = step(*resumed, input);
    ASSERT_EQ(x.proxy_mm, y.proxy_mm) << k;
    ASSERT_EQ(x.force_n, y.force_n) << k;
    if (k == 20) {
      EXPECT_LT(unresolved_parts(whole), unresolved);  // it goes on
    }
  }
  EXPECT_EQ(resumed->hash(), whole.hash());
}

TEST(Resolving, what_is_resolved_is_in_the_hash) {
  StepState a = scratched(resolving_scene());
  step(a, resting());
  step(a, resting());
  auto b = StepState::restore(a.inner().scene, a.save());
  ASSERT_TRUE(b);
  ASSERT_EQ(a.hash(), b->hash());
  b->inner().surface->load_resolved(b->volume(), Resolving::on, [](std::int32_t) { return CutSurface::kAllParts; });
  EXPECT_NE(a.hash(), b->hash());
}

TEST(Resolving, a_search_that_would_go_on_and_on_goes_on_in_the_next_tick) {
  // A bur of 2.3 mm in a trough of 2.32 mm has hundreds of points all round: the device goes 4 mm along it.
  constexpr double kWide = 1.15, kTrough = 1.16;
  const auto trough = [](Vec3 p) { return std::max(p.z, kTrough - std::hypot(p.y, p.z)); };
  StepState state(scene_of(from_distance(6.0, 0.05, trough), Method::surface, kWide));
  approach(state, {-2.0, 0.0, 2.0}, {-2.0, 0.0, -0.1});
  StepOutput out = step(state, input_at({2.0, 0.0, -0.1}));
  EXPECT_TRUE(out.deferred);
  EXPECT_GT(out.proxy_mm.x, -1.5);
  for (int k = 0; k < 8 && out.deferred; ++k) out = step(state, input_at({2.0, 0.0, -0.1}));
  EXPECT_FALSE(out.deferred);
  EXPECT_NEAR(out.proxy_mm.x, 2.0, 1e-3);
  EXPECT_NEAR(out.proxy_mm.z, kWide - kTrough, 1e-3);
}

}  // namespace
}  // namespace cusp::test
