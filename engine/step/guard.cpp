#include "engine/step/guard.h"

#include <cmath>

namespace cusp {

Fault judge(const GuardSettings& settings, const StepInput& input, double jump_mm, bool first) noexcept {
  if (input.buttons & StepInput::kGone) return Fault::gone;
  if (first || (input.buttons & StepInput::kRearm)) return Fault::none;
  if (input.elapsed_us > settings.late_ms * 1000.0) return Fault::late;
  if (jump_mm > settings.jump_mm) return Fault::jump;
  return Fault::none;
}

Vec3 guarded(const GuardSettings& settings, GuardState& state, Vec3 raw_n, double dt_ms) noexcept {
  const double square = glm::dot(raw_n, raw_n);
  if (!(square <= 1e12)) state.fault = state.fault == Fault::none ? Fault::not_finite : state.fault;  // NaN too
  if (state.fault != Fault::none) {
    state.ramp_ms = 0.0;
    state.force_n = 0.0;
    return Vec3(0.0);
  }
  state.ramp_ms += dt_ms;
  const double wanted = std::sqrt(square);
  const double ramp = settings.ramp_in_ms > 0.0 && state.ramp_ms < settings.ramp_in_ms
                          ? state.ramp_ms / settings.ramp_in_ms
                          : 1.0;
  double given = wanted * ramp;
  if (given > settings.limit_n) given = settings.limit_n;
  const double rise = state.force_n + settings.slew_n_per_ms * dt_ms;
  if (given > rise) given = rise;
  state.force_n = given;
  return wanted > 1e-12 ? raw_n * (given / wanted) : Vec3(0.0);
}

}  // namespace cusp
