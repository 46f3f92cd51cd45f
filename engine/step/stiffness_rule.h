/// Largest stiffness of a scene on a device that a hand holds: half of the bound by damping, delay, the softest grip
/// and the voxels. A pure function; not for the haptic thread.
///
///   loop     K < (b + b of the grip) / (T / 2 + delay). A sampled and held wall answers half a tick late, and its
///            energy grows by K times that lateness times speed squared; damping has to outweigh it. For a small mass
///            this is the limit of stability (Gil, Sanchez, Hulin, Preusche, Hirzinger, "Stability boundary for haptic
///            rendering: influence of damping and delay", J. Computing and Information Science in Engineering 9(1),
///            2009). Tests compare it with the sampled system's eigenvalues.
///   voxels   for readings whose proxy moves from voxel to voxel: 1/2 K voxel^2 < 0.05 mJ [M]. A distance field's
///            surface has no such jump.
#pragma once

#include <cstdint>

#include "engine/base/haptic_port.h"
#include "engine/scene/scene.h"

namespace cusp::engine {

/// The bound that decided.
enum class StiffnessBound : std::uint8_t {
  none,    // no mass in the loop: a mouse, a script
  device,  // the device's own declared or calibrated most
  loop,    // damping, delay and grip
  voxels,  // the proxy's jump from voxel to voxel
};

struct StiffnessRule {
  double most_n_per_mm = 20.0;
  StiffnessBound bound = StiffnessBound::none;
  bool assumed = false;  // the device's damping or delay is unknown: calibration may raise the bound
};

/// For a scene of this method and voxel size.
StiffnessRule stiffness_rule(const DeviceLimits& device, Method method, double voxel_mm) noexcept;

}  // namespace cusp::engine
