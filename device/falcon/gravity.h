/// Torques that carry the weight of grip and arms. Pure. Source: facts 1.15. Both numbers are zero until measured on a
/// Falcon [M].
#pragma once

#include <optional>
#include <span>

#include "device/falcon/kinematics.h"

namespace cusp::device::falcon {

struct GravityCalibration {
  double grip_kg = 0.0;   // grip, platform and a share of the shins
  double arm_kg_m = 0.0;  // mass of an arm times the distance of its centre from the base pivot
  friend bool operator==(const GravityCalibration&, const GravityCalibration&) = default;
};

/// Torques (N m) that hold the device still against its weight. The base stands upright: y is up. Haptic thread.
Vec3 gravity_torque_nm(const Geometry& geometry, const Pose& pose, const GravityCalibration& calibration) noexcept;

/// One position at which a soft controller held the grip, with the mean torque.
struct HeldPose {
  Pose pose;
  Vec3 torque_nm{0.0};
};

/// Both numbers by least squares. nullopt for fewer than three positions, a singular fit, or a negative result.
std::optional<GravityCalibration> fit_gravity(const Geometry& geometry, std::span<const HeldPose> held) noexcept;

}  // namespace cusp::device::falcon
