/// The torques that carry the weight of the grip and of the arms, so that a hand does not. Pure. Source: facts 1.15; no
/// open program has it, and its two numbers are known of no Falcon: zero until they are measured on one [M].
#pragma once

#include <optional>
#include <span>

#include "device/falcon/kinematics.h"

namespace cusp::device::falcon {

struct GravityCalibration {
  double grip_kg = 0.0;   // what hangs on the grip: grip, platform and a share of the shins
  double arm_kg_m = 0.0;  // an arm's mass times the distance of its middle from the base pivot
  friend bool operator==(const GravityCalibration&, const GravityCalibration&) = default;
};

/// Torques (N m) that hold the device still against its weight. The base stands upright: y is up. Haptic thread.
Vec3 gravity_torque_nm(const Geometry& geometry, const Pose& pose, const GravityCalibration& calibration) noexcept;

/// One place at which a slack controller held the grip, and the mean torque that it took.
struct HeldPose {
  Pose pose;
  Vec3 torque_nm{0.0};
};

/// The two numbers by least squares. Nothing when there are fewer than three places, when they lie so that the numbers
/// cannot be told apart, or when the fit is not finite or negative.
std::optional<GravityCalibration> fit_gravity(const Geometry& geometry, std::span<const HeldPose> held) noexcept;

}  // namespace cusp::device::falcon
