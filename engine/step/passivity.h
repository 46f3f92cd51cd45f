/// Passivity controller of the guard (time domain). It watches what the held force gives to the hand, and softens the
/// coupling between proxy and device point while that is more than a spring would give back. It never adds force.
///
///   observer    energy given = sum of the force that was held times the device's motion, both through the same low-pass,
///               so that an encoder's dither is not taken for motion (Hannaford and Ryu, "Time-domain passivity control
///               of haptic interfaces", IEEE Trans. Robotics and Automation 18(1), 2002)
///   reference   the energy of the softened spring, U = 1/2 scale K |proxy - device|^2: what may come back follows it
///               all the way (after Ryu, Preusche, Hannaford, Hirzinger, "Time domain passivity control with reference
///               energy following", IEEE Trans. Control Systems Technology 13(5), 2005), so that the controller corrects
///               a little each tick and never waits for a debt and kicks
///   controller  a debt lowers `scale` by what it takes out of U; no velocity enters the force. What the hand puts in by
///               pressing on, against the spring and a damper that stands for what the spring lost, raises it again
///
/// While nothing is owed scale is 1, and the force is exactly K (proxy - device). A delay has to be given
/// (GuardSettings::delay_ms): each motion is then held against the force that the device held by then. Thread: haptic.
#pragma once

#include <array>

#include "engine/scene/scene.h"

namespace cusp::engine {

inline constexpr int kMostDelayTicks = 8;

struct PassivityState {
  bool primed = false;              // device_mm has begun
  double scale = 1.0;               // share of the coupling's stiffness that the hand gets, [0, 1]
  double room_mj = 0.0;             // what may be fed before scale falls; below 0: owed
  double bank_mj = 0.0;             // what the hand put in and the loop did not give back: scale recovers from it
  Vec3 device_mm{0.0};              // low-passed
  Vec3 spring_mm{0.0};              // proxy - device, low-passed
  double stiffness_n_per_mm = 0.0;  // last one touched
  std::array<Vec3, kMostDelayTicks + 1> held_n{};  // newest first: forces that the device may hold by now
  friend bool operator==(const PassivityState&, const PassivityState&) = default;
};

/// A tick as the guard sees it.
struct GuardTick {
  Vec3 raw_n{0.0};  // of the method, before the guard
  Vec3 device_mm{0.0};
  Vec3 proxy_mm{0.0};
  double stiffness_n_per_mm = 0.0;  // blended; 0 without contact
  bool contact = false;
  double dt_ms = 1.0;
  double ramp = 1.0;  // share of the force that the ramp-in lets through
};

/// Reckons with the motion since the last tick; then the force that may be given now, of `tick.raw_n` and not above it.
Vec3 passive(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept;

/// What the hand gets in the end, to be called after passive() with what limit, slew and ramp left of it.
void hold(PassivityState& state, Vec3 force_n, Vec3 spring_mm) noexcept;

}  // namespace cusp::engine
