#include "device/falcon/workspace.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace cusp::device::falcon {
namespace {

TEST(FalconWorkspace, turns_the_device_s_axes_into_the_specimen_s) {
  const auto space = Workspace::from({.origin_mm = Vec3(1, 2, 3), .scale = 1.0});
  ASSERT_TRUE(space);
  EXPECT_EQ(space->specimen_mm({0, 0, 0.125}), Vec3(1, 2, 3));
  EXPECT_LT(glm::length(space->specimen_mm({0.01, 0, 0.125}) - Vec3(11, 2, 3)), 1e-12);  // right is x
  EXPECT_LT(glm::length(space->specimen_mm({0, 0.01, 0.125}) - Vec3(1, 2, 13)), 1e-12);  // up is up
  EXPECT_LT(glm::length(space->specimen_mm({0, 0, 0.135}) - Vec3(1, -8, 3)), 1e-12);     // to the user is -y
}

TEST(FalconWorkspace, a_push_does_the_same_work_on_both_sides) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto space = Workspace::from({.scale = 0.5, .yaw_rad = 0.7});
  for (int i = 0; i < 100; ++i) {
    const Vec3 at(unit(random) * 0.03, unit(random) * 0.03, 0.125), step(unit(random), unit(random), unit(random));
    const Vec3 force(unit(random), unit(random), unit(random));
    const Vec3 moved = space->specimen_mm(at + step) - space->specimen_mm(at);
    // Work in the specimen is the device's times 1000 mm/m and the scale.
    EXPECT_NEAR(glm::dot(force, moved), glm::dot(space->device_n(force), step) * 500, 1e-9);
    EXPECT_NEAR(glm::length(space->device_n(force)), glm::length(force), 1e-12);
    EXPECT_LT(glm::length(space->grip_m(space->specimen_mm(at)) - at), 1e-15);
  }
}

TEST(FalconWorkspace, the_clutch_lets_the_grip_come_back_without_the_bur) {
  auto space = Workspace::from({});
  const Vec3 far(0.03, 0.01, 0.13), back(0, 0, 0.125), then(0.002, 0, 0.125);
  const Vec3 stood = space->specimen_mm(far);
  space->hold(far);
  EXPECT_EQ(space->specimen_mm(back), stood);
  space->hold(back);  // held already: nothing moves
  EXPECT_EQ(space->specimen_mm(back), stood);
  space->release(back);
  EXPECT_LT(glm::length(space->specimen_mm(back) - stood), 1e-12);
  EXPECT_LT(glm::length(space->specimen_mm(then) - stood - Vec3(1, 0, 0)), 1e-12);  // 2 mm at half scale
  space->release(far);
  EXPECT_LT(glm::length(space->specimen_mm(back) - stood), 1e-12);  // not held: nothing moves
}

TEST(FalconWorkspace, refuses_numbers_that_are_none) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Workspace::from({.scale = 0.0}));
  EXPECT_FALSE(Workspace::from({.scale = -1.0}));
  EXPECT_FALSE(Workspace::from({.scale = 1.5}));
  EXPECT_FALSE(Workspace::from({.scale = kNan}));
  EXPECT_FALSE(Workspace::from({.centre_m = Vec3(kNan)}));
  EXPECT_FALSE(Workspace::from({.yaw_rad = kNan}));
}

}  // namespace
}  // namespace cusp::device::falcon
