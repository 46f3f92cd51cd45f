/// How stiff a scene may be on a device that a hand holds: half of what the device's damping and delay, the softest
/// grip and the voxels allow. A pure function; not of the haptic thread.
///
///   loop     K < (b + b of the grip) / (T / 2 + delay): a wall that is sampled and held answers half a tick late, and
///            its energy grows by K times that lateness times speed squared; what is damped has to outweigh it. For a
///            mass that does not matter against it this is where the loop rings (Gil, Sanchez, Hulin, Preusche,
///            Hirzinger, "Stability boundary for haptic rendering: influence of damping and delay", J. Computing and
///            Information Science in Engineering 9(1), 2009); tests hold it against the sampled system's eigenvalues.
///   voxels   for readings whose proxy moves from voxel to voxel: 1/2 K voxel^2 < 0.05 mJ [M]. The surface of a distance
///            field is known far below its voxels.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/haptic_port.h"
#include "engine/scene/scene.h"

namespace cusp::engine {

/// What bounds the stiffness.
enum class StiffnessBound : std::uint8_t {
  none,    // no hand's mass stands in the loop: a mouse, a script
  device,  // the device's own declared or calibrated most
  loop,    // damping, delay and grip
  voxels,  // the proxy's jump from voxel to voxel
};

struct StiffnessRule {
  double most_n_per_mm = 20.0;
  StiffnessBound bound = StiffnessBound::none;
  bool assumed = false;  // damping or delay is not known of this device: calibration may raise it
};

/// For a scene of this method and voxel size.
StiffnessRule stiffness_rule(const DeviceLimits& device, Method method, double voxel_mm) noexcept;

}  // namespace cusp::engine
