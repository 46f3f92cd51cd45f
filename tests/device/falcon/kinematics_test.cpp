#include "device/falcon/kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

#include "device/falcon/protocol.h"

namespace cusp::device::falcon {
namespace {

constexpr double kDegree = 57.295779513082323;
const Geometry kFalcon;
const Calibration kAsBuilt;

/// CUSP_RESIDUALS=1 prints what was measured beside the bound.
void report(const char* what, double measured, double bound) {
  if (std::getenv("CUSP_RESIDUALS") != nullptr) std::cout << what << ": " << measured << " (bound " << bound << ")\n";
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// 0 where the legs can no longer move the grip in some direction, 1 where they are at right angles.
double freedom(const Jacobian& rows) {
  return std::abs(glm::dot(rows[0], glm::cross(rows[1], rows[2]))) /
         (glm::length(rows[0]) * glm::length(rows[1]) * glm::length(rows[2]));
}

/// From the inner stop (about z 0.065) out, 55 mm about the axis, up to where the legs are all but stretched. Larger
/// than the 40 mm and 0.125 +- 0.045 that are used.
std::vector<Vec3> whole_workspace(double step_m) {
  std::vector<Vec3> out;
  for (double z = 0.066; z <= 0.182; z += step_m)
    for (double x = -0.055; x <= 0.0551; x += step_m)
      for (double y = -0.055; y <= 0.0551; y += step_m) {
        if (x * x + y * y > 0.055 * 0.055) continue;
        const auto legs = inverse(kFalcon, {x, y, z});
        if (!legs) continue;
        const auto rows = jacobian(kFalcon, *legs);
        if (rows && freedom(*rows) > 0.05) out.push_back({x, y, z});
      }
  return out;
}

struct Place {
  Vec3 grip_m, arm_deg, ticks, knee_deg, side_deg;
};

// facts 1.12, test vectors.
const Place kPlaces[] = {
    {{0, 0, 0.11}, Vec3(16.188), Vec3(-516.32), Vec3(131.730), Vec3(91.068)},
    {{0.02, -0.015, 0.13},
     {45.3710, 19.8678, 36.0620},
     {284.65, -415.33, 29.15},
     {135.028, 118.211, 129.341},
     {99.743, 96.286, 77.125}},
    {{-0.03, 0.03, 0.10},
     {-13.2482, 41.3432, 19.1986},
     {-1324.24, 174.10, -433.69},
     {112.549, 150.652, 135.692},
     {79.145, 79.145, 115.630}},
    {{0.04, 0.01, 0.15},
     {57.3425, 33.5062, 71.0132},
     {613.22, -41.00, 988.43},
     {120.517, 108.695, 130.780},
     {114.887, 79.828, 79.145}},
    {{0, 0, 0.165}, Vec3(61.1326), Vec3(717.25), Vec3(115.872), Vec3(91.068)},
};

TEST(FalconKinematics, inverse_gives_the_published_angles) {
  for (const Place& place : kPlaces) {
    const auto legs = inverse(kFalcon, place.grip_m);
    ASSERT_TRUE(legs);
    // The vectors are printed to 1e-3 degrees (arm: 1e-4, but for the two on the axis) and 1e-2 ticks.
    EXPECT_LT(largest(legs->arm_rad * kDegree - place.arm_deg), 6e-4);
    EXPECT_LT(largest(legs->knee_rad * kDegree - place.knee_deg), 6e-4);
    EXPECT_LT(largest(legs->side_rad * kDegree - place.side_deg), 6e-4);
    EXPECT_LT(largest(ticks_of_arm_rad(kFalcon, kAsBuilt, legs->arm_rad) - place.ticks), 6e-3);
  }
}

TEST(FalconKinematics, forward_gives_the_published_places) {
  // facts 1.12: ticks (0,0,0) and (-500, 200, 350); printed to a micrometre.
  const auto rest = forward(kFalcon, arm_rad_of_ticks(kFalcon, kAsBuilt, {0, 0, 0}), kMiddleM);
  ASSERT_TRUE(rest);
  EXPECT_LT(largest(rest->grip_m - Vec3(0, 0, 0.134602)), 6e-7);
  const auto aside = forward(kFalcon, arm_rad_of_ticks(kFalcon, kAsBuilt, {-500, 200, 350}), kMiddleM);
  ASSERT_TRUE(aside);
  EXPECT_LT(largest(aside->grip_m - Vec3(-0.003062, 0.031129, 0.130661)), 6e-7);
}

TEST(FalconKinematics, force_gives_the_published_torques_and_counts) {
  // facts 1.12: p = (0.02, -0.015, 0.13), F = (1, 2, -3) N.
  const auto legs = inverse(kFalcon, {0.02, -0.015, 0.13});
  ASSERT_TRUE(legs);
  const auto rows = jacobian(kFalcon, *legs);
  ASSERT_TRUE(rows);
  const Vec3 torque = torque_nm(*rows, {1, 2, -3});
  EXPECT_LT(largest(torque - Vec3(-0.157857, -0.141744, 0.074629)), 6e-7);
  EXPECT_EQ(counts_of_torque(kAsBuilt, torque),
            (std::array<std::int16_t, 3>{1579, 1417, -746}));  // 1578.6, 1417.4, -746.3
}

TEST(FalconKinematics, forward_of_inverse_comes_back_from_any_warm_start) {
  const auto places = whole_workspace(0.0075);
  ASSERT_GT(places.size(), 1500u);
  std::mt19937 random(7);
  double worst = 0;
  std::size_t tried = 0;
  for (const Vec3& place : places) {
    const auto legs = inverse(kFalcon, place);
    for (int start = 0; start < 12; ++start) {
      const Vec3& from = start == 0 ? kMiddleM : places[random() % places.size()];
      const auto pose = forward(kFalcon, legs->arm_rad, from);
      ASSERT_TRUE(pose) << place.x << " " << place.y << " " << place.z << " from " << from.x << " " << from.y << " "
                        << from.z;
      worst = std::max(worst, glm::length(pose->grip_m - place));
      ++tried;
    }
  }
  report("forward of inverse, m", worst, 1e-6);
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(tried, 18000u);
}

TEST(FalconKinematics, forward_starts_anew_where_a_start_is_senseless) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto legs = inverse(kFalcon, {0.01, 0.02, 0.12});
  for (const Vec3 start : {Vec3(kNan), Vec3(0.0), Vec3(1e9), Vec3(0, 0, -0.12), Vec3(0.3, 0, 0.1)}) {
    const auto pose = forward(kFalcon, legs->arm_rad, start);
    ASSERT_TRUE(pose);
    EXPECT_LT(glm::length(pose->grip_m - Vec3(0.01, 0.02, 0.12)), 1e-6);
  }
}

TEST(FalconKinematics, angles_that_no_place_has_are_refused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(forward(kFalcon, Vec3(kNan, 0, 0), kMiddleM));
  EXPECT_FALSE(forward(kFalcon, Vec3(std::numeric_limits<double>::infinity()), kMiddleM));
  // Arms folded back through the base: no place of the grip has that on the side on which a Falcon is built.
  EXPECT_FALSE(forward(kFalcon, Vec3(-150) / kDegree, kMiddleM));
  EXPECT_FALSE(inverse(kFalcon, {0, 0, 0.3}));
  EXPECT_FALSE(inverse(kFalcon, {0.2, 0, 0.1}));
  EXPECT_FALSE(inverse(kFalcon, Vec3(kNan)));
}

TEST(FalconKinematics, every_possible_encoder_reading_ends_in_bounded_time_and_finite) {
  std::mt19937 random(11);
  int solved = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<std::int16_t, 3> ticks{};
    for (auto& tick : ticks) tick = static_cast<std::int16_t>(random());
    const auto pose = forward(kFalcon, arm_rad_of_ticks(kFalcon, kAsBuilt, ticks), kMiddleM);
    if (!pose) continue;
    ++solved;
    ASSERT_TRUE(std::isfinite(glm::dot(pose->grip_m, Vec3(1.0))));
    ASSERT_LT(glm::length(pose->grip_m), 0.3);
  }
  EXPECT_GT(solved, 0);
}

TEST(FalconKinematics, the_jacobian_is_the_derivative) {
  double worst = 0;
  for (const Vec3& place : whole_workspace(0.011)) {
    const auto legs = inverse(kFalcon, place);
    const auto rows = jacobian(kFalcon, *legs);
    if (freedom(*rows) < 0.2) continue;  // where legs are nearly stretched a difference of 1 um is no derivative
    constexpr double kStep = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0.0);
      step[axis] = kStep;
      const auto plus = inverse(kFalcon, place + step), minus = inverse(kFalcon, place - step);
      if (!plus || !minus) continue;
      const Vec3 slope = (plus->arm_rad - minus->arm_rad) / (2 * kStep);
      for (int leg = 0; leg < 3; ++leg) {
        const double exact = (*rows)[static_cast<std::size_t>(leg)][axis];
        worst = std::max(worst, std::abs(slope[leg] - exact) / glm::length((*rows)[static_cast<std::size_t>(leg)]));
      }
    }
  }
  // Central differences of 1 um: rounding about 1e-16 / 1e-6 against 10 rad/m, truncation near the stretched edge.
  report("jacobian against differences, relative", worst, 1e-6);
  EXPECT_LT(worst, 1e-6);
}

TEST(FalconKinematics, power_in_equals_power_out) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worst = 0, worst_back = 0;
  for (const Vec3& place : whole_workspace(0.0075)) {
    const auto rows = jacobian(kFalcon, *inverse(kFalcon, place));
    ASSERT_TRUE(rows);
    const Vec3 force(unit(random) * 5, unit(random) * 5, unit(random) * 5);
    const Vec3 speed(unit(random) * 0.3, unit(random) * 0.3, unit(random) * 0.3);
    const Vec3 torque = torque_nm(*rows, force);
    const Vec3 turning = arm_rad_s(*rows, speed);
    const double watts = glm::length(force) * glm::length(speed);
    worst = std::max(worst, std::abs(glm::dot(torque, turning) - glm::dot(force, speed)) / watts);
    worst_back = std::max(worst_back, glm::length(force_n(*rows, torque) - force) / glm::length(force));
    worst_back = std::max(worst_back, glm::length(grip_m_s(*rows, turning) - speed) / glm::length(speed));
  }
  report("power, relative", worst, 1e-12);
  EXPECT_LT(worst, 1e-12);
  EXPECT_LT(worst_back, 1e-12);
}

TEST(FalconKinematics, a_force_too_large_keeps_its_direction) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 torque(unit(random) * 3, unit(random) * 3, unit(random) * 3);
    const auto words = counts_of_torque(kAsBuilt, torque);
    const Vec3 given = torque_of_counts(kAsBuilt, words);
    const double most = largest(Vec3(words[0], words[1], words[2]));
    ASSERT_LE(most, kMaxTorqueCounts);
    if (largest(torque) * 1e4 > kMaxTorqueCounts) {
      ASSERT_EQ(most, kMaxTorqueCounts);
    }
    // Each word is rounded to a count: that much may the direction differ.
    const double share = glm::dot(given, torque) / glm::dot(torque, torque);
    ASSERT_LT(largest(given - share * torque) * 1e4, 1.0);
    ASSERT_GT(share, 0.0);
  }
}

TEST(FalconKinematics, what_is_not_finite_gives_no_torque) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::array<std::int16_t, 3> none{};
  EXPECT_EQ(counts_of_torque(kAsBuilt, Vec3(kNan, 0, 0)), none);
  EXPECT_EQ(counts_of_torque(kAsBuilt, Vec3(0, std::numeric_limits<double>::infinity(), 1)), none);
  EXPECT_EQ(counts_of_torque({.force_gain = kNan}, Vec3(0.1)), none);
  EXPECT_EQ(counts_of_torque(kAsBuilt, Vec3(1e300)), (std::array<std::int16_t, 3>{-4095, -4095, -4095}));
}

TEST(FalconKinematics, encoders_and_angles_are_one_another_s_inverse) {
  const Calibration trimmed{.trim_rad = Vec3(0.01, -0.02, 0.005)};
  const std::array<std::int16_t, 3> ticks = {-1463, 336, 1056};
  const Vec3 back = ticks_of_arm_rad(kFalcon, trimmed, arm_rad_of_ticks(kFalcon, trimmed, ticks));
  EXPECT_LT(largest(back - Vec3(-1463, 336, 1056)), 1e-9);
  // facts 1.11: 9880.7 counts a turn of the arm, 35 degrees at zero.
  EXPECT_NEAR(2 * 3.14159265358979 / kFalcon.rad_per_tick, 9880.7, 0.05);
  EXPECT_NEAR(arm_rad_of_ticks(kFalcon, kAsBuilt, {0, 0, 0}).x * kDegree, 35.0, 1e-9);
}

TEST(FalconKinematics, a_degree_of_offset_moves_the_middle_by_1_32_mm) {
  const auto here = inverse(kFalcon, kMiddleM);
  const auto there = forward(kFalcon, here->arm_rad + Vec3(1 / kDegree), kMiddleM);
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->grip_m.z - kMiddleM.z, 1.32e-3, 0.02e-3);  // facts 1.11
}

TEST(FalconKinematics, the_strongest_force_is_what_was_reckoned) {
  // facts 1.13: at z 0.125 on the axis 6.8, 6.9 and 16.2 N along x, y and z, 6.1 N in the worst direction.
  const auto most = [](Vec3 place, Vec3 direction) {
    const auto rows = jacobian(kFalcon, *inverse(kFalcon, place));
    return kMaxTorqueCounts / kAsBuilt.counts_per_nm / largest(torque_nm(*rows, direction));
  };
  EXPECT_NEAR(most(kMiddleM, {1, 0, 0}), 6.8, 0.05);
  EXPECT_NEAR(most(kMiddleM, {0, 1, 0}), 6.9, 0.05);
  EXPECT_NEAR(most(kMiddleM, {0, 0, 1}), 16.2, 0.05);
  double worst = 1e9;
  for (int i = 0; i < 20000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 20000, turn = i * 2.399963;  // a spiral over the sphere
    const double across = std::sqrt(1 - z * z);
    worst = std::min(worst, most(kMiddleM, {across * std::cos(turn), across * std::sin(turn), z}));
  }
  EXPECT_NEAR(worst, 6.1, 0.05);
}

}  // namespace
}  // namespace cusp::device::falcon
