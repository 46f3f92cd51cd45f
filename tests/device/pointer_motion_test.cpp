#include "device/pointer/pointer_motion.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

#include "tests/device/toy_tissue.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using test::Plane;
using test::ToyTissue;

constexpr double kTick = 0.001;

/// The hand, the law of motion and a toy tissue in a closed loop of 1 kHz.
struct Bench {
  explicit Bench(Vec3 start) : hand(start), motion(start) { felt = tissue.feel(start); }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kTick + 0.5); ++i) tick();
  }
  void tick() {
    const Vec3 before = motion.device_mm();
    const Vec3 device = motion.advance(hand.latest(), felt, kTick);
    most_step_mm = std::max(most_step_mm, glm::length(device - before));
    const double before_n = glm::length(felt.force_n);
    felt = tissue.feel(device);
    most_force_n = std::max(most_force_n, glm::length(felt.force_n));
    most_rise_n = std::max(most_rise_n, glm::length(felt.force_n) - before_n);
  }
  ToyTissue tissue;
  PointerHand hand;
  PointerMotion motion;
  Feedback felt;
  double most_step_mm = 0, most_force_n = 0, most_rise_n = 0;
};

TEST(PointerMotion, LiftedItHoversOverThePlaceThatIsShown) {
  Bench bench(Vec3(0, 0, 5));
  bench.hand.move_to(Vec3(2, -1, 0));
  bench.run(3);
  // hover_mm of PointerTuning above the shown place.
  EXPECT_NEAR(bench.motion.device_mm().x, 2, 1e-6);
  EXPECT_NEAR(bench.motion.device_mm().y, -1, 1e-6);
  EXPECT_NEAR(bench.motion.device_mm().z, 3, 1e-6);
  EXPECT_EQ(bench.most_force_n, 0);
}

TEST(PointerMotion, APushPressesWithTheNewtonsThatWereAsked) {
  for (const double stiffness : {0.5, 2.0, 20.0}) {
    for (const double push : {0.2, 1.0, 3.0}) {
      Bench bench(Vec3(0, 0, 1));
      bench.tissue.stiffness_n_per_mm = stiffness;
      bench.hand.set_push(push);
      bench.run(2.5);
      EXPECT_NEAR(bench.felt.force_n.z, push, 1e-9) << stiffness << " N/mm";  // F = K * (push / K), eq. (2)
      EXPECT_LE(bench.most_force_n, push + 1e-9) << stiffness << " N/mm: it overshot";
    }
  }
}

TEST(PointerMotion, APushBuildsUpNoFasterThanItsRise) {
  Bench bench(Vec3(0, 0, 1));
  bench.tissue.stiffness_n_per_mm = 20.0;
  bench.hand.set_push(3);
  bench.run(2);
  // push_rise_n_s = 20 N/s, so 0.02 N a tick; the first tick that touches comes with at most descend * dt * K = 0.2 N.
  EXPECT_LE(bench.most_rise_n, 0.2 + 1e-9);
}

TEST(PointerMotion, AReleaseLiftsOff) {
  Bench bench(Vec3(0, 0, 1));
  bench.hand.move_to(Vec3(0, 0, 0));
  bench.hand.set_push(2);
  bench.run(1);
  ASSERT_TRUE(bench.felt.in_contact);
  bench.hand.lift();
  bench.run(0.02);
  EXPECT_FALSE(bench.felt.in_contact);
  bench.run(1);
  EXPECT_NEAR(bench.motion.device_mm().z, 3, 1e-6);
}

TEST(PointerMotion, ALedgeOnTheWayOutFeelsNoMoreThanTheLateralForce) {
  Bench bench(Vec3(0, 0, 0.1));
  bench.hand.set_push(1);
  bench.run(1);
  ASSERT_TRUE(bench.felt.in_contact);
  bench.tissue.planes.push_back({Vec3(0, 0, 0.05), Vec3(0, 0, -1)});
  bench.most_force_n = 0;
  bench.hand.set_push(0);
  bench.run(1);
  ASSERT_TRUE(bench.felt.in_contact);
  EXPECT_NEAR(bench.felt.force_n.z, -1.0, 1e-9) << "lateral_n of PointerTuning";
  EXPECT_LE(bench.most_force_n, 1.0 + 1e-9);
}

TEST(PointerMotion, ItSlidesOverTheSurfaceWithThePointerAndKeepsItsPush) {
  Bench bench(Vec3(0, 0, 1));
  bench.hand.set_push(1);
  bench.run(1);
  bench.hand.move_to(Vec3(5, 0, 0));
  bench.run(0.1);
  // 20 mm/s (slide_mm_s) after a smoothing of 25 ms: on its way, not there.
  EXPECT_GT(bench.motion.device_mm().x, 1.0);
  EXPECT_LT(bench.motion.device_mm().x, 2.0 + 1e-9);
  bench.run(1);
  EXPECT_NEAR(bench.motion.device_mm().x, 5, 1e-6);
  EXPECT_NEAR(bench.felt.force_n.z, 1, 1e-9);
}

TEST(PointerMotion, ASlopeDoesNotCarryItAway) {
  const double angle = 0.5;  // rad
  Bench bench(Vec3(0, 0, 1));
  bench.tissue.planes = {Plane{Vec3(0.0), Vec3(std::sin(angle), 0, std::cos(angle))}};
  bench.hand.set_push(1);
  bench.run(3);
  // Without friction the force stands on the surface; its part along the approach is the push, so the part across is
  // push * tan(angle) = 0.546 N, less than lateral_n: the point stays.
  EXPECT_NEAR(bench.motion.device_mm().x, 0, 1e-9);
  EXPECT_NEAR(bench.felt.force_n.z, 1, 1e-6);
  EXPECT_NEAR(bench.felt.force_n.x, std::tan(angle), 1e-6);

  // The naive law, a point straight below the proxy, slides down the same slope: the test can fail.
  Vec3 naive(0, 0, -0.01);
  for (int i = 0; i < 1000; ++i) naive = bench.tissue.feel(naive).proxy_mm - Vec3(0, 0, 1.0 / 2.0);
  EXPECT_GT(glm::length(naive), 100);
}

TEST(PointerMotion, AgainstAWallItPullsWithNoMoreThanItsLateralForce) {
  Bench bench(Vec3(0, 0, 1));
  bench.tissue.planes.push_back(Plane{Vec3(1, 0, 0), Vec3(-1, 0, 0)});
  bench.hand.set_push(1);
  bench.run(1);
  bench.hand.move_to(Vec3(30, 0, 0));
  bench.run(3);
  EXPECT_NEAR(bench.felt.proxy_mm.x, 1, 1e-9);
  EXPECT_NEAR(bench.felt.force_n.x, -1.0, 1e-9);  // lateral_n
  EXPECT_NEAR(bench.felt.force_n.z, 1, 1e-9);
}

TEST(PointerMotion, AWallThatIsTouchedDoesNotMakeItFall) {
  Bench bench(Vec3(0, 0, 5));
  bench.tissue.planes = {Plane{Vec3(1, 0, 0), Vec3(-1, 0, 0)}};  // a wall and no floor
  bench.hand.move_to(Vec3(3, 0, 5));
  bench.hand.set_push(3);
  bench.run(0.5);
  ASSERT_TRUE(bench.felt.in_contact);
  const double before = bench.motion.device_mm().z;
  bench.run(0.1);
  EXPECT_GE(bench.motion.device_mm().z, before - 1.0 - 1e-9);  // descend_mm_s = 10
}

TEST(PointerMotion, APushThatMeetsNothingStopsAtItsReach) {
  Bench bench(Vec3(0, 0, 5));
  bench.tissue.planes.clear();
  bench.hand.move_to(Vec3(0, 0, 0));
  bench.hand.set_push(1);
  bench.run(4);
  EXPECT_NEAR(bench.motion.device_mm().z, -12, 1e-6);  // reach_mm
}

TEST(PointerMotion, ItFollowsTissueThatGivesWayAtAConstantPush) {
  Bench bench(Vec3(0, 0, 1));
  bench.hand.set_push(1.5);
  bench.run(1);
  const double speed_mm_s = 1.2;  // of the paper's softest material
  for (int i = 0; i < 2000; ++i) {
    bench.tissue.planes[0].point_mm.z -= speed_mm_s * kTick;
    bench.felt = bench.tissue.feel(bench.motion.device_mm());
    bench.tick();
    // The floor recedes by 1.2 µm between contact and answer: at 2 N/mm that is 2.4 mN.
    ASSERT_NEAR(bench.felt.force_n.z, 1.5, 0.0025);
  }
  EXPECT_NEAR(bench.felt.proxy_mm.z, -2.4, 1e-9);
}

TEST(PointerMotion, HarderTissueUnderTheBurDoesNotKickTheHand) {
  Bench bench(Vec3(0, 0, 1));
  bench.tissue.stiffness_n_per_mm = 1;
  bench.hand.set_push(1);
  bench.run(1.5);
  bench.tissue.stiffness_n_per_mm = 4;  // device 1 mm deep: for a moment 4 N, then the point backs off
  bench.felt = bench.tissue.feel(bench.motion.device_mm());
  bench.run(0.02);
  EXPECT_NEAR(bench.felt.force_n.z, 1, 1e-9);
  EXPECT_LE(bench.most_step_mm, 0.15 + 1e-12);
}

TEST(PointerMotion, AFaultTakesTheHandOff) {
  Bench bench(Vec3(0, 0, 1));
  bench.hand.set_push(2);
  bench.run(1);
  for (int i = 0; i < 100; ++i) {
    bench.felt.faulted = true;
    bench.tick();
  }
  EXPECT_FALSE(bench.felt.in_contact);
}

TEST(PointerMotion, NoTickMovesItFurtherThanItsStepWhateverComes) {
  const unsigned seed = 20240611;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-50, 50);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Bench bench(Vec3(0, 0, 1));
  for (int i = 0; i < 100000; ++i) {
    const Vec3 before = bench.motion.device_mm();
    bench.hand.move_to(Vec3(place(random), place(random), place(random)));
    bench.hand.set_push(place(random));
    if (i % 7 == 0) bench.hand.set_view(Vec3(place(random), place(random), place(random)), Vec3(1, 0, 0));
    Feedback felt = bench.tissue.feel(before);
    if (i % 11 == 0) felt.proxy_mm = Vec3(place(random), place(random), place(random));
    if (i % 13 == 0) felt.proxy_mm = Vec3(nan, 0, infinity);
    if (i % 17 == 0) felt.stiffness_n_per_mm = i % 2 == 0 ? nan : 0.0;
    felt.in_contact = felt.in_contact || i % 5 == 0;
    const double dt = i % 19 == 0 ? nan : place(random) / 1000;
    const Vec3 device = bench.motion.advance(bench.hand.latest(), felt, dt);
    ASSERT_TRUE(std::isfinite(device.x) && std::isfinite(device.y) && std::isfinite(device.z)) << i;
    ASSERT_LE(glm::length(device - before), 0.15 + 1e-12) << i;  // max_step_mm; the step's own fault is at 5 mm
  }
}

TEST(PointerMotion, AStallMovesItNoFurtherThanFourMilliseconds) {
  Bench bench(Vec3(0, 0, 5));
  bench.hand.set_push(1);
  const double before = bench.motion.device_mm().z;
  bench.motion.advance(bench.hand.latest(), bench.felt, 2.0);
  EXPECT_NEAR(bench.motion.device_mm().z, before - 0.04, 1e-12);  // 10 mm/s for 4 ms
}

TEST(PointerMotion, ThePushGoesAlongTheApproachThatTheViewGives) {
  Bench bench(Vec3(3, 0, 0));
  bench.tissue.planes = {Plane{Vec3(0.0), Vec3(1, 0, 0)}};
  bench.hand.set_view(Vec3(-2, 0, 0), Vec3(0, 1, 0));
  bench.hand.set_push(1);
  bench.run(2);
  EXPECT_NEAR(bench.felt.force_n.x, 1, 1e-9);
  EXPECT_NEAR(bench.motion.device_mm().z, 0, 1e-9);
}

}  // namespace
}  // namespace cusp::test
