/// Passivity controller of the guard (time domain). It compares the energy that the held force gives to the hand with
/// the energy that a spring returns. While the first is larger, it softens the coupling between proxy and device point.
/// It never adds force.
///
///   observer    energy given = sum of the held force times the device's motion, both through the same low-pass, so
///               that an encoder's dither is no motion (Hannaford and Ryu, "Time-domain passivity control of haptic
///               interfaces", IEEE Trans. Robotics and Automation 18(1), 2002)
///   reference   the energy of the softened spring, U = 1/2 scale K |proxy - device|^2. The returned energy follows it
///               all the way (after Ryu, Preusche, Hannaford, Hirzinger, "Time domain passivity control with reference
///               energy following", IEEE Trans. Control Systems Technology 13(5), 2005), so that the controller
///               corrects a little each tick
///   controller  a deficit lowers `scale` by what it takes out of U; no velocity enters the force. Energy that the hand
///               puts in raises it again: against the spring, and against a damper in place of the spring's lost part
///
/// Without a deficit scale is 1, and the force is exactly K (proxy - device). GuardSettings::delay_ms must hold the
/// delay: the observer multiplies each motion by the force that the device held by then. Thread: haptic.
#pragma once

#include <array>

#include "engine/scene/scene.h"

namespace cusp::engine {

inline constexpr int kMostDelayTicks = 8;

struct PassivityState {
  bool primed = false;              // device_mm has begun
  double scale = 1.0;               // share of the coupling's stiffness that remains, [0, 1]
  double margin_mj = 0.0;           // energy that may be fed before scale falls; below 0: the deficit
  double surplus_mj = 0.0;          // energy that the hand put in and the loop did not return; raises scale
  Vec3 device_mm{0.0};              // low-passed
  Vec3 spring_mm{0.0};              // proxy - device, low-passed
  double stiffness_n_per_mm = 0.0;  // last one touched
  std::array<Vec3, kMostDelayTicks + 1> held_n{};  // newest first: forces that the device may hold by now
};

/// The guard's input of a tick.
struct GuardTick {
  Vec3 raw_n{0.0};  // of the method, before the guard
  Vec3 device_mm{0.0};
  Vec3 proxy_mm{0.0};
  double stiffness_n_per_mm = 0.0;  // blended; 0 without contact
  bool contact = false;
  double dt_ms = 1.0;
  double ramp = 1.0;  // share of the force that the ramp-in lets through
};

/// Accounts for the motion since the last tick. Returns the part of `tick.raw_n` that is passive.
Vec3 passive(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept;

/// Records the force that the device holds: after limit, slew and ramp. To be called after passive().
void hold(PassivityState& state, Vec3 force_n, Vec3 spring_mm) noexcept;

}  // namespace cusp::engine
