#include "device/falcon/gravity.h"

#include <cmath>

namespace cusp::device::falcon {

namespace {

constexpr double kGravity = 9.80665;  // m/s^2, standard

Vec3 of_grip(const Pose& pose) noexcept { return torque_nm(pose.rows, Vec3(0.0, kGravity, 0.0)); }

Vec3 of_arms(const Geometry& geometry, const Pose& pose) noexcept {
  Vec3 torque;
  for (int i = 0; i < 3; ++i) {
    torque[i] = -kGravity * std::sin(geometry.leg_rad[static_cast<std::size_t>(i)]) * std::sin(pose.legs.arm_rad[i]);
  }
  return torque;
}

}  // namespace

Vec3 gravity_torque_nm(const Geometry& geometry, const Pose& pose, const GravityCalibration& calibration) noexcept {
  return calibration.grip_kg * of_grip(pose) + calibration.arm_kg_m * of_arms(geometry, pose);
}

std::optional<GravityCalibration> fit_gravity(const Geometry& geometry, std::span<const HeldPose> held) noexcept {
  if (held.size() < 3) return std::nullopt;
  double gg = 0, ga = 0, aa = 0, gt = 0, at = 0;
  for (const HeldPose& place : held) {
    const Vec3 grip = of_grip(place.pose), arms = of_arms(geometry, place.pose);
    gg += glm::dot(grip, grip);
    ga += glm::dot(grip, arms);
    aa += glm::dot(arms, arms);
    gt += glm::dot(grip, place.torque_nm);
    at += glm::dot(arms, place.torque_nm);
  }
  const double det = gg * aa - ga * ga;
  if (!(det > 1e-4 * gg * aa)) return std::nullopt;  // the two columns are next to parallel
  const GravityCalibration fit{(gt * aa - at * ga) / det, (at * gg - gt * ga) / det};
  if (!(fit.grip_kg >= 0.0 && fit.arm_kg_m >= 0.0 && std::isfinite(fit.grip_kg + fit.arm_kg_m))) return std::nullopt;
  return fit;
}

}  // namespace cusp::device::falcon
