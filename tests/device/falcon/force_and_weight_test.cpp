// The pushes that a hand feels on the device page, and the weighing, on emulated Falcons whose weight is known.
#include <gtest/gtest.h>

#include "device/falcon/force_test.h"
#include "device/falcon/weighing.h"
#include "tests/device/falcon/trial_bench.h"

namespace cusp::device::falcon {
namespace {

using test::TrialBench;

TEST(FalconForceTest, pushes_six_ways_in_turn_to_what_was_asked_and_never_jumps) {
  ForceTest trial(2.0);
  TrialReading reading{.grip_m = kMiddleM};
  std::array<Vec3, 6> most{};
  Vec3 before(0.0);
  for (int i = 0; i < 60000 && trial.end() == TrialEnd::none; ++i) {
    reading.t_s = i * 1e-3;
    const ForceWay way = trial.way();
    const Vec3 now = trial.advance(reading);
    EXPECT_LT(glm::length(now - before), 0.01);  // 2 N over half a second is 4 mN a millisecond
    before = now;
    Vec3& seen = most[static_cast<std::size_t>(way)];
    if (glm::length(now) > glm::length(seen)) seen = now;
  }
  EXPECT_EQ(trial.end(), TrialEnd::done);
  EXPECT_EQ(trial.force_n(), Vec3(0.0));
  for (const auto& [way, wanted] : {std::pair{ForceWay::right, Vec3(2, 0, 0)}, {ForceWay::up, Vec3(0, 2, 0)},
                                    {ForceWay::away, Vec3(0, 0, -2)}}) {
    EXPECT_LT(glm::length(most[static_cast<std::size_t>(way)] - wanted), 0.01);
  }
}

TEST(FalconForceTest, asks_for_no_more_than_it_may) {
  for (const double asked : {-1.0, 100.0, std::nan("")}) {
    ForceTest trial(asked);
    double most = 0;
    for (int i = 0; i < 4000; ++i) most = std::max(most, glm::length(trial.advance({.t_s = i * 1e-3, .grip_m = kMiddleM})));
    EXPECT_LE(most, ForceTest::kMostN + 1e-9);
    EXPECT_EQ(most > 0, asked > 0);
  }
}

TEST(FalconForceTest, a_grip_that_nobody_holds_ends_it) {
  TrialBench bench({.damping_ns_per_m = 0.5, .friction_n = 0.0});
  ForceTest trial(3.0);
  bench.run(trial);
  EXPECT_TRUE(trial.end() == TrialEnd::too_fast || trial.end() == TrialEnd::out_of_range);
}

TEST(FalconWeighing, finds_the_weight_that_was_set) {
  const GravityCalibration set{0.2, 0.003};
  TrialBench bench({.friction_n = 0.0, .weight = set});
  Weighing trial({}, {});
  bench.run(trial);
  ASSERT_EQ(trial.end(), TrialEnd::done) << static_cast<int>(trial.end());
  const auto found = trial.result();
  ASSERT_TRUE(found);
  // Measured off: 1 g and 0.00002 kg m: torque words are whole numbers.
  EXPECT_NEAR(found->grip_kg, set.grip_kg, 0.01);
  EXPECT_NEAR(found->arm_kg_m, set.arm_kg_m, 0.0002);
}

TEST(FalconWeighing, stopped_it_gives_no_result) {
  TrialBench bench({});
  Weighing trial({}, {});
  for (int i = 0; i < 3000; ++i) bench.push(trial.advance(bench.read()));
  trial.stop();
  EXPECT_EQ(trial.advance(bench.read()), Vec3(0.0));
  EXPECT_FALSE(trial.result());
}

}  // namespace
}  // namespace cusp::device::falcon
