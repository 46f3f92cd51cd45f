/// The bur's axis that an exercise sets, the same to the bit on every processor: a scene is part of a replay.
#pragma once

#include "engine/base/vec.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Of an angle in degrees, clamped to a quarter turn. libm's sine differs between processors; this series does not. Error below 1e-16.
struct SineCosine {
  double sine, cosine;
};
[[nodiscard]] SineCosine sine_cosine(double degrees) noexcept;

/// Unit, from the head towards the shank, of a handpiece at rest: vertical, tilted towards buccal (+y). Exactly +z at 0 degrees.
[[nodiscard]] Vec3 resting_axis(double tool_tilt_deg) noexcept;

}  // namespace cusp::scenarios
