// Largest cost of a tick, counted and not timed: a cavity of many short sweeps, and a button pressed and released again and
// again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/step/state.h"
#include "engine/tool/heads.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kWorkRadiusMm = 0.5;

/// What was counted, as microseconds of an EPYC at 2.6 GHz: measured over a session of ten minutes there.
struct Work {
  std::int64_t visited = 0;
  std::uint64_t made = 0, resolved = 0;
  double microseconds() const {
    return 0.025 * static_cast<double>(visited) + 0.45 * static_cast<double>(made) + 10.0 * static_cast<double>(resolved);
  }
};
Work work_of(StepState& state) {
  const SurfaceContact& surface = *state.inner().surface;
  return {surface.candidates_visited(), surface.cut_surface().cells_made(), surface.cut_surface().cells_resolved()};
}
Work operator-(const Work& a, const Work& b) { return {a.visited - b.visited, a.made - b.made, a.resolved - b.resolved}; }

std::shared_ptr<const Scene> work_scene() {
  return scene_of(from_distance(4.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.8, 1.8, 1.4)); }), Method::surface, kWorkRadiusMm, 4.0);
}

/// Back and forth over a box of 1.6 by 1.2 mm, deeper and deeper, shaking; the button is up for 12 ticks of every 90,
/// and at times the device jerks across the cavity.
StepInput digging(int k) {
  const double a = 0.0131 * k, b = 0.00217 * k;
  const double shake = 0.03 * std::sin(2.3 * k);
  Vec3 at(0.8 * std::sin(a) + shake, 0.6 * std::sin(b), 1.4 + kWorkRadiusMm - 0.1 - 0.00003 * k + 0.15 * std::sin(0.07 * k));
  if (k % 700 > 690) at.x = -at.x;
  return input_at(at, k % 90 < 78 ? CutButton::pressed : CutButton::up);
}
constexpr int kDigging = 36000;

TEST(TickWork, a_dense_cavity_costs_a_tick_no_more_than_its_budget) {
  StepState state(work_scene());
  step(state, input_at({0.0, 0.0, 2.6}));
  approach(state, {0.0, 0.0, 2.6}, {0.0, 0.0, 2.1});
  Work most, before = work_of(state);
  double worst = 0.0;
  int worst_at = 0;
  for (int k = 0; k < kDigging; ++k) {
    step(state, digging(k));
    const Work now = work_of(state), tick = now - before;
    before = now;
    most = {std::max(most.visited, tick.visited), std::max(most.made, tick.made), std::max(most.resolved, tick.resolved)};
    if (tick.microseconds() > worst) {
      worst = tick.microseconds();
      worst_at = k;
    }
  }
  EXPECT_GT(state.inner().sweeps.size(), 10000);
  EXPECT_GT(state.volume().cut_bricks().size(), 30u);
  // A part of 32 cells is the most that is resolved at once; two searches may take all
  // their candidates, the second where the proxy outruns its device.
  EXPECT_LE(most.resolved, 32u);
  // Measured 966: a ball that leaves its own sweep needs the cells about it at once, and again once it has carved.
  EXPECT_LE(most.made, 1000u);
  EXPECT_LE(most.visited, 2 * SurfaceContact::kExploring.candidates);
  EXPECT_LT(worst, 500.0) << "in tick " << worst_at;
}

TEST(TickWork, a_head_that_mills_at_a_hands_pace_costs_a_tick_a_short_search_and_defers_seldom) {
  auto scene = std::make_shared<Scene>(*work_scene());
  scene->burs[0].head = flat_head(kWorkRadiusMm, 0.35, 1.0).value();
  StepState state(scene);
  step(state, input_at({0.0, 0.0, 2.6}));
  approach(state, {0.0, 0.0, 2.6}, {0.0, 0.0, 2.1});
  std::int64_t most = 0, deferred = 0;
  constexpr int kMilling = 24000;
  for (int k = 0; k < kMilling; ++k) {
    // 5 mm/s over 1.6 mm, 0.05 mm of tremor at 9 to 11 Hz, a layer of 0.06 mm a second.
    const double across = std::fmod(0.005 * k, 3.2);
    const Vec3 tremor(std::sin(0.057 * k), std::sin(0.063 * k + 1.0), std::sin(0.069 * k + 2.0));
    const Vec3 at = Vec3(across < 1.6 ? across - 0.8 : 2.4 - across, 0.6 * std::sin(0.001 * k), 1.9 - 0.00006 * k) + 0.05 * tremor;
    const std::int64_t before = work_of(state).visited;
    const StepOutput out = step(state, input_at(at, CutButton::pressed));
    most = std::max(most, work_of(state).visited - before);
    deferred += out.deferred ? 1 : 0;
  }
  EXPECT_LE(most, 18000);  // measured 15,564; 39,140 with the passes of a fast stroke
  EXPECT_LT(deferred, kMilling / 100);  // measured 185: such a tick cuts nothing
}

/// Six cavities: how often a search goes on in the next tick hangs on the ridges that happen to be left.
TEST(TickWork, a_rim_in_the_cavity_that_it_has_milled_costs_a_tick_little_more_and_defers_seldom) {
  auto scene = std::make_shared<Scene>(*work_scene());
  scene->burs[0].head = flat_head(kWorkRadiusMm, 0.35, 1.0).value();
  constexpr int kCavities = 6, kMilling = 6000, kExploring = 6000;
  std::int64_t most = 0, deferred = 0;
  for (int first = 0; first < 61 * kCavities; first += 61) {
    StepState state(scene);
    step(state, input_at({0.0, 0.0, 2.6}));
    approach(state, {0.0, 0.0, 2.6}, {0.0, 0.0, 2.1});
    for (int k = first; k < first + kMilling; ++k) step(state, digging(k));
    const StepInput end = digging(first + kMilling);
    approach(state, end.position_mm(), {0.0, 0.0, 1.6});
    for (int k = 0; k < kExploring; ++k) {
      // 50 mm/s over floor and walls, pressed into them.
      const double a = 0.06 * k, r = 0.9 + 0.3 * std::sin(0.013 * k);
      const std::int64_t before = work_of(state).visited;
      const StepOutput out = step(state, input_at({r * std::cos(a), r * std::sin(a), 1.2 + 0.3 * std::sin(0.031 * k)}));
      most = std::max(most, work_of(state).visited - before);
      deferred += out.deferred ? 1 : 0;
    }
  }
  // Measured 22,740: two searches of eight passes. 42,490 with as many passes as while cutting.
  EXPECT_LE(most, 25000);
  EXPECT_LT(deferred, kCavities * kExploring / 100);  // measured 275, 1 to 132 in a cavity
}

}  // namespace
}  // namespace cusp::test
