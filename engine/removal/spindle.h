/// The handpiece: from the pedal to the bur's speed, what the load takes of it, and the drag that the turning bur
/// gives. Pure functions over an explicit state, exact arithmetic. Thread: haptic; wait-free. Figures are [M]: general
/// knowledge, not verified.
#pragma once

#include "engine/base/vec.h"
#include "engine/scene/phenomena.h"

namespace cusp::engine {

struct SpindleSettings {
  double free_rpm = 0;   // pedal down, nothing touched
  double least_rpm = 0;  // pedal just touched
  double sag = 0;        // share of free_rpm that a load just below the stall takes
  double stall_n = 0;    // push that stops a bur of kStallRadiusMm; a wider one stops sooner, in proportion
  double up_s = 0;       // time constants: running up; giving way to a load; coasting without pedal
  double load_s = 0;
  double coast_s = 0;
};

inline constexpr double kStallRadiusMm = 0.5;

/// `value` between both; not a number gives `low`.
constexpr double within(double value, double low, double high) noexcept { return value > low ? (value < high ? value : high) : low; }

/// All zero for Handpiece::none.
constexpr SpindleSettings settings_of(Handpiece handpiece) noexcept {
  switch (handpiece) {
    case Handpiece::none: return {};
    // 350k free, about 60 % of it under the usual load of 1 N: the straight line through both stalls at 2.5 N.
    case Handpiece::turbine: return {350e3, 0.0, 1.0, 2.5, 0.3, 0.1, 0.25};
    case Handpiece::electric: return {200e3, 0.0, 0.0, 5.0, 0.2, 0.05, 0.1};
    case Handpiece::slow: return {40e3, 20e3, 0.1, 8.0, 0.2, 0.05, 0.1};
  }
  return {};
}

struct SpindleState {
  double rpm = 0.0;
  bool stalled = false;  // stands under load; goes on once the load is below half of what stalls it
};

/// One tick. pedal: 0 to 1. push_n: what presses the bur on, 0 in the air. Values that are no numbers, or out of their
/// range, count as the nearest that is in it; the speed stays within [0, free_rpm].
void advance(SpindleState& state, const SpindleSettings& settings, double pedal, double push_n, double radius_mm,
             double dt_s) noexcept;

/// What the speed leaves of a tissue's removal speed, [0, 1]: removal goes in proportion to it (dental.md 3.3, [M]); a
/// scene's speeds are those at free_rpm.
double removal_factor(const SpindleState& state, const SpindleSettings& settings) noexcept;

/// Tangential speed of the bur's surface at its widest, mm/s.
double surface_speed_mm_s(double rpm, double radius_mm) noexcept;

/// Drag of the turning bur on the hand, N: against its surface's motion where it touches, across the force; none where
/// the end cuts. `force_n`: contact force on the bur. `axis`: unit, towards the shank, seen from which it turns
/// clockwise. Never above kMostDragN, nor above kDragShare of the force.
Vec3 drag_n(Vec3 force_n, Vec3 axis, double speed_share) noexcept;

inline constexpr double kDragShare = 0.03;   // of the push
inline constexpr double kMostDragN = 0.06;

}  // namespace cusp::engine
