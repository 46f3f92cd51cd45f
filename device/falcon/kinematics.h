/// Geometry of the Falcon: three arms on the base, each joined to the grip by a parallelogram. Pure functions; haptic
/// thread or any other; no allocation, bounded. Frame of the device: x right, y up, z out towards the user, origin on
/// the base plane. Metres, radians, newtons, newton metres: millimetres begin at workspace.h. Source: facts 1.11
/// and 1.12 (the mechanism is R. E. Stamper's, Univ. of Maryland Ph.D. 97-4).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/base/vec.h"

namespace cusp::device::falcon {

/// Lengths of the mechanism (m) and what its encoders count.
struct Geometry {
  double arm = 0.060;           // a: base pivot to knee
  double shin = 0.1025;         // b: the parallelogram
  double wrist_out = 0.01443;   // c: wrist to the middle of the grip, along the leg
  double wrist_side = -0.025;   // f: across it
  double links = 0.0225;        // d + e: the offset links at both ends of the parallelogram
  double base_out = 0.0400;     // r: base pivot, along the leg
  double base_side = -0.02309;  // s: across it
  std::array<double, 3> leg_rad = {1.8325957145940461, -0.26179938779914943,
                                   -2.3561944901923448};  // 105, -15, -135 deg
  double rad_per_tick = 6.359047629780476e-4;             // 360 deg / (1280 counts * 110 mm / 14.25 mm)
  double zero_rad = 0.6108652381980153;  // about 35 deg at tick 0; Calibration::trim_rad corrects it
};

/// mm at the grip for one count, across the axis at z 0.150 m, where it is coarsest. From published figures; tests hold it.
inline constexpr double kCoarsestMmPerTick = 0.057;

using Jacobian = std::array<Vec3, 3>;  // rows: d(arm i)/d(x, y, z), rad/m

/// The three legs with the grip at one place. Component i belongs to arm i+1 (top, right, left).
struct Legs {
  Vec3 arm_rad{0.0};   // theta 1: the driven one
  Vec3 knee_rad{0.0};  // theta 2
  Vec3 side_rad{0.0};  // theta 3: lean of the parallelogram
};

/// Joint angles for a position of the grip; nullopt if a leg does not reach it.
std::optional<Legs> inverse(const Geometry& geometry, Vec3 grip_m) noexcept;

/// Exact. nullopt if a leg is stretched or folded: no force can be commanded there.
std::optional<Jacobian> jacobian(const Geometry& geometry, const Legs& legs) noexcept;

/// A position of the grip with its joint angles and Jacobian.
struct Pose {
  Vec3 grip_m{0.0};
  Legs legs;
  Jacobian rows{};
};

/// The position with these arm angles, by Newton from `start_m`, then from kMiddleM if that fails. At most kForwardSteps
/// iterations altogether; each calls inverse() once per halving of the step, at most 8 times.
std::optional<Pose> forward(const Geometry& geometry, Vec3 arm_rad, Vec3 start_m) noexcept;

/// Middle of the workspace.
inline constexpr Vec3 kMiddleM{0.0, 0.0, 0.125};
inline constexpr int kForwardSteps = 40;

/// Torques of the arms that push the grip with this force: tau = J^-T F.
Vec3 torque_nm(const Jacobian& rows, Vec3 force_n) noexcept;
/// The force on the grip that these torques make: F = J^T tau.
Vec3 force_n(const Jacobian& rows, Vec3 torque_nm) noexcept;
/// Arm speeds for a speed of the grip, and back.
Vec3 arm_rad_s(const Jacobian& rows, Vec3 grip_m_s) noexcept;
Vec3 grip_m_s(const Jacobian& rows, Vec3 arm_rad_s) noexcept;

/// Calibration of one Falcon; measured once (README, "First contact").
struct Calibration {
  Vec3 trim_rad{0.0};          // added to each arm's angle
  double counts_per_nm = 1e4;  // of the torque words
  double force_gain = 1.0;     // newtons asked for a newton felt, by a spring scale
  friend bool operator==(const Calibration&, const Calibration&) = default;
};

Vec3 arm_rad_of_ticks(const Geometry& geometry, const Calibration& calibration,
                      std::array<std::int16_t, 3> ticks) noexcept;
/// Not rounded, and not limited to 16 bits.
Vec3 ticks_of_arm_rad(const Geometry& geometry, const Calibration& calibration, Vec3 arm_rad) noexcept;

/// Torque words. A positive word turns an arm inward, so the sign changes. If one exceeds the limit, all three shrink by
/// the same factor, which keeps the force's direction. A value that is not finite gives zero torque.
std::array<std::int16_t, 3> counts_of_torque(const Calibration& calibration, Vec3 torque_nm) noexcept;
Vec3 torque_of_counts(const Calibration& calibration, std::array<std::int16_t, 3> counts) noexcept;

}  // namespace cusp::device::falcon
