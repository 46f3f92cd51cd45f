#include "device/falcon/gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cusp::device::falcon {
namespace {

const Geometry kGeometry;
constexpr GravityCalibration kHeavy{0.25, 0.004};

Pose pose_of(Vec3 grip_m) {
  const auto legs = inverse(kGeometry, grip_m);
  EXPECT_TRUE(legs);
  return {grip_m, *legs, *jacobian(kGeometry, *legs)};
}

/// Height of every mass times its weight, from the drawing: y of the grip; an arm's middle lies l (cos theta) out along
/// a leg that is turned by phi from x, so that its height is l cos(theta) sin(phi).
double potential_j(const Pose& pose) {
  double energy = kHeavy.grip_kg * 9.80665 * pose.grip_m.y;
  for (int i = 0; i < 3; ++i) {
    energy += kHeavy.arm_kg_m * 9.80665 * std::cos(pose.legs.arm_rad[i]) *
              std::sin(kGeometry.leg_rad[static_cast<std::size_t>(i)]);
  }
  return energy;
}

std::vector<Vec3> places() {
  std::vector<Vec3> out;
  for (const double x : {-0.03, 0.0, 0.03})
    for (const double y : {-0.03, 0.0, 0.03})
      for (const double z : {0.09, 0.125, 0.15}) out.push_back({x, y, z});
  return out;
}

TEST(FalconGravity, does_the_work_that_lifting_takes) {
  for (const Vec3 place : places()) {
    const Pose here = pose_of(place);
    const Vec3 torque = gravity_torque_nm(kGeometry, here, kHeavy);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0.0);
      step[axis] = 1e-5;
      const Pose plus = pose_of(place + step), minus = pose_of(place - step);
      const double work = glm::dot(torque, plus.legs.arm_rad - minus.legs.arm_rad);
      // 2e-5 m of up to 3 N: 5e-5 J. The difference of two cosines is exact to 1e-5 of it.
      EXPECT_NEAR(work, potential_j(plus) - potential_j(minus), 1e-9);
    }
  }
}

TEST(FalconGravity, carries_nothing_until_it_is_measured) {
  EXPECT_EQ(gravity_torque_nm(kGeometry, pose_of(kMiddleM), {}), Vec3(0.0));
}

TEST(FalconGravity, lifts_the_grip_upward) {
  const Pose pose = pose_of(kMiddleM);
  const Vec3 lift = force_n(pose.rows, gravity_torque_nm(kGeometry, pose, {0.2, 0.0}));
  EXPECT_NEAR(lift.y, 0.2 * 9.80665, 1e-12);
  EXPECT_NEAR(lift.x, 0, 1e-12);
  EXPECT_NEAR(lift.z, 0, 1e-12);
}

TEST(FalconGravity, is_found_again_from_places_that_were_held) {
  std::vector<HeldPose> held;
  int i = 0;
  for (const Vec3 place : places()) {
    const Pose pose = pose_of(place);
    // A millinewton metre of friction, its sign by turns: what averaging leaves.
    const double friction = (++i % 2 == 0 ? 1e-3 : -1e-3);
    held.push_back({pose, gravity_torque_nm(kGeometry, pose, kHeavy) + Vec3(friction, -friction, friction)});
  }
  const auto fit = fit_gravity(kGeometry, held);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->grip_kg, kHeavy.grip_kg, 0.01);
  EXPECT_NEAR(fit->arm_kg_m, kHeavy.arm_kg_m, 5e-4);
}

TEST(FalconGravity, refuses_poses_that_do_not_determine_both) {
  EXPECT_FALSE(fit_gravity(kGeometry, {}));
  const Pose pose = pose_of(kMiddleM);
  std::vector<HeldPose> two(2, HeldPose{pose, gravity_torque_nm(kGeometry, pose, kHeavy)});
  EXPECT_FALSE(fit_gravity(kGeometry, two));
  std::vector<HeldPose> falling;
  for (const Vec3 place : places()) {
    const Pose at = pose_of(place);
    falling.push_back({at, -gravity_torque_nm(kGeometry, at, kHeavy)});
  }
  EXPECT_FALSE(fit_gravity(kGeometry, falling));  // a negative mass: the sign of the torques is wrong
}

}  // namespace
}  // namespace cusp::device::falcon
