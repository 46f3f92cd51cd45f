#include "engine/step/stiffness_rule.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/lab/sampled_wall.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(StiffnessRule, assumes_half_a_newton_second_and_a_millisecond_of_an_unknown_device) {
  const StiffnessRule rule = stiffness_rule(DeviceLimits{}, Method::surface, 0.08);
  // (0.5 + 2) N s/m over 1.5 ms is 1667 N/m; half of it.
  EXPECT_NEAR(rule.most_n_per_mm, 0.8333, 1e-4);
  EXPECT_EQ(rule.bound, StiffnessBound::loop);
  EXPECT_TRUE(rule.assumed);
}

TEST(StiffnessRule, is_raised_by_calibration) {
  DeviceLimits device;
  device.damping_ns_per_m = 5.0;
  device.delay_ms = 1.0;
  const StiffnessRule rule = stiffness_rule(device, Method::surface, 0.08);
  EXPECT_NEAR(rule.most_n_per_mm, 2.3333, 1e-4);
  EXPECT_FALSE(rule.assumed);
  device.damping_ns_per_m = 20.0;
  EXPECT_EQ(stiffness_rule(device, Method::surface, 0.08).most_n_per_mm, 3.0) << "never above the device's own";
  EXPECT_EQ(stiffness_rule(device, Method::surface, 0.08).bound, StiffnessBound::device);
}

TEST(StiffnessRule, does_not_bind_a_device_without_a_hand_in_the_loop) {
  DeviceLimits mouse;
  mouse.closed_loop = false;
  mouse.max_stiffness_n_per_mm = 20.0;
  EXPECT_EQ(stiffness_rule(mouse, Method::surface, 0.2).most_n_per_mm, 20.0);
  EXPECT_EQ(stiffness_rule(mouse, Method::surface, 0.2).bound, StiffnessBound::none);
}

TEST(StiffnessRule, counts_voxels_where_the_proxy_jumps_from_one_to_the_next) {
  DeviceLimits device;
  device.damping_ns_per_m = 20.0;
  device.delay_ms = 0.0;
  EXPECT_NEAR(stiffness_rule(device, Method::occupancy, 0.2).most_n_per_mm, 1.25, 1e-9);
  EXPECT_EQ(stiffness_rule(device, Method::occupancy, 0.2).bound, StiffnessBound::voxels);
  EXPECT_EQ(stiffness_rule(device, Method::surface, 0.2).most_n_per_mm, 3.0);
}

TEST(StiffnessRule, stays_below_where_the_sampled_system_rings) {
  double closest = 1e9;
  for (const double mass_kg : {0.1, 0.25})
    for (const double damping : {0.5, 2.0, 5.0})
      for (const int delay : {0, 1, 3}) {
        lab::SampledWall wall;
        wall.mass_kg = mass_kg;
        wall.damping_ns_per_m = damping;
        wall.delay_ticks = delay;
        wall.grip = lab::kSoftGrip;
        const double rings = lab::critical_stiffness_n_per_mm(wall);
        DeviceLimits device;
        device.max_stiffness_n_per_mm = 20.0;
        device.damping_ns_per_m = damping;
        device.delay_ms = delay;
        const double most = stiffness_rule(device, Method::surface, 0.08).most_n_per_mm;
        EXPECT_LT(most, rings) << mass_kg << ' ' << damping << ' ' << delay;
        closest = std::min(closest, rings / most);
      }
  RecordProperty("least_margin", std::to_string(closest));
  EXPECT_GT(closest, 1.4) << "about the half that was meant";
}

TEST(StiffnessRule, answers_nonsense_with_no_stiffness_at_all) {
  DeviceLimits device;
  device.damping_ns_per_m = -10.0;
  device.softest_grip_ns_per_m = -10.0;
  EXPECT_EQ(stiffness_rule(device, Method::surface, 0.08).most_n_per_mm, 0.0);
}

}  // namespace
}  // namespace cusp::test
