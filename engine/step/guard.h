/// The last stage of the step: what keeps the hand safe. Force may fall at any rate; it rises no faster than the slew,
/// never beyond the limit, from zero after a start; a fault takes it away until it is re-armed. Thread: haptic.
#pragma once

#include "engine/step/scene.h"
#include "engine/step/step.h"

namespace cusp {

struct GuardState {
  Fault fault = Fault::none;
  double ramp_ms = 0.0;     // since start, burr change or re-arm
  double force_n = 0.0;     // magnitude given in the tick before
};

/// A fault of this input, or none. `jump_mm`: how far the device point moved since the input before.
Fault judge(const GuardSettings& settings, const StepInput& input, double jump_mm, bool first) noexcept;

/// Force for the hand (N). A raw force that is not finite latches Fault::not_finite.
Vec3 guarded(const GuardSettings& settings, GuardState& state, Vec3 raw_n, double dt_ms) noexcept;

}  // namespace cusp
