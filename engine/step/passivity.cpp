#include "engine/step/passivity.h"

#include <cmath>

namespace cusp::engine {

namespace {

/// Low-pass of 3 ms at any tick, never further behind than half an encoder step: what dithers between two counts weighs
/// little in the energy, and what really moves is seen at once. (A whole step behind, up to 0.09 mJ went out of a
/// groove that rang, before it was seen; half a step: 0.044.)
constexpr double kSmoothMs = 3.0, kBehindSteps = 0.5;
/// How fast the coupling stiffens again: where the hand has put in what that takes; and in the air [M].
constexpr double kRecoverPerMs = 0.0005, kRecoverFreePerMs = 0.005;
/// What a late tick fed is owed for long, but not for ever: 0.45 mJ at most. (Forgotten at 0.015, ticks late by 50 ms
/// fed six times as much.)
constexpr double kMostOwed = 30.0;
/// The damper begins above what one encoder count can look like, so that it does not chatter.
constexpr double kDamperFromMmS = 15.0;
/// A wall softer than this is none. What half of the least damping (0.5 N s/m) bears where the force comes late by
/// half a tick and the delay is passive on any device, and needs no controller.
constexpr double kLeastNPerMm = 0.2, kHalfDampingNsPerMm = 0.25e-3, kHalfTickS = 0.0005;
/// What an encoder's noise costs at most while the bur slides on a slope (measured: 0.004 mJ/s at 2 N/mm, 50 mm/s).
constexpr double kNoiseMjPerMs = 5e-6;

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// Energy of a spring that gives no more than `most_n` (mJ).
double stored_mj(double k_n_per_mm, double stretch_mm, double most_n) noexcept {
  if (!(k_n_per_mm > 0.0)) return 0.0;
  const double bend = most_n / k_n_per_mm;
  return stretch_mm <= bend ? 0.5 * k_n_per_mm * stretch_mm * stretch_mm : most_n * (stretch_mm - 0.5 * bend);
}

}  // namespace

Vec3 passive(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept {
  const Vec3 spring = tick.contact ? tick.proxy_mm - tick.device_mm : Vec3(0.0);
  if (tick.contact) state.stiffness_n_per_mm = tick.stiffness_n_per_mm * tick.ramp;
  if (!state.primed) {
    state.primed = true;
    state.device_mm = tick.device_mm;
    state.room_mj = settings.passivity_mj;
  }

  double follow = tick.dt_ms / (tick.dt_ms + kSmoothMs);
  const double off = length_of(spring - state.spring_mm);
  const double behind_mm = kBehindSteps * settings.encoder_mm;
  if (off * (1.0 - follow) > behind_mm) follow = 1.0 - behind_mm / off;
  if (!tick.contact) follow = 1.0;
  int back = static_cast<int>(settings.delay_ms + 0.5);
  if (!(back > 0)) back = 0;
  if (back > kMostDelayTicks) back = kMostDelayTicks;
  const Vec3 before_device = state.device_mm, before_spring = state.spring_mm;
  state.device_mm += (tick.device_mm - state.device_mm) * follow;
  state.spring_mm += (spring - state.spring_mm) * follow;

  const double most = settings.has(GuardPart::limit) ? settings.limit_n : 1e6;
  const double stretch = length_of(state.spring_mm), stretch_before = length_of(before_spring);
  // A tissue's stiffness may change under the bur, and the ramp rises: that is meant, and not owed.
  const double k = state.stiffness_n_per_mm;
  const double stored = stored_mj(state.scale * k, stretch, most);
  const double given = glm::dot(state.held_n[static_cast<std::size_t>(back)], state.device_mm - before_device);
  state.room_mj -= given + stored - stored_mj(state.scale * k, stretch_before, most) - kNoiseMjPerMs * tick.dt_ms;
  if (state.room_mj > settings.passivity_mj) {
    state.bank_mj += state.room_mj - settings.passivity_mj;
    state.room_mj = settings.passivity_mj;
  }
  const double rate_mm_s = tick.dt_ms > 0.0 ? (stretch - stretch_before) / (tick.dt_ms * 1e-3) : 0.0;
  if (!tick.contact) {
    state.bank_mj = 0.0;
    state.scale += kRecoverFreePerMs * tick.dt_ms;
    if (state.scale > 1.0) state.scale = 1.0;
    const double forgive = kRecoverFreePerMs * tick.dt_ms < 1.0 ? kRecoverFreePerMs * tick.dt_ms : 1.0;
    state.room_mj += forgive * (settings.passivity_mj - state.room_mj);
    return tick.raw_n * tick.ramp;
  }
  if (state.room_mj < 0.0) {
    const double bears = kHalfDampingNsPerMm / (kHalfTickS + 1e-3 * back);
    const double least_n_per_mm = bears < kLeastNPerMm ? bears : kLeastNPerMm;
    const double least = k > least_n_per_mm ? least_n_per_mm / k : 1.0;
    double scale = stored > -state.room_mj ? state.scale * (1.0 + state.room_mj / stored) : 0.0;
    if (scale < least) scale = least;
    if (scale < state.scale) state.scale = scale;
    state.room_mj += stored - stored_mj(state.scale * k, stretch, most);
    const double most_owed_mj = kMostOwed * settings.passivity_mj;
    if (state.room_mj < -most_owed_mj) state.room_mj = -most_owed_mj;
  } else if (state.scale < 1.0) {
    double rise = rate_mm_s > kDamperFromMmS ? 1.0 : kRecoverPerMs * tick.dt_ms;
    if (rise > 1.0 - state.scale) rise = 1.0 - state.scale;
    const double cost = stored_mj((state.scale + rise) * k, stretch, most) - stored;
    if (cost > state.bank_mj) rise = state.bank_mj > 0.0 ? rise * (state.bank_mj / cost) : 0.0;
    state.scale += rise;
    state.bank_mj -= cost < state.bank_mj ? cost : state.bank_mj;
  }
  if (!(state.scale < 1.0)) return tick.raw_n * tick.ramp;

  // What the softened spring lacks, a bounded damper gives in part: never more than the method's own force.
  double share = state.scale;
  const double raw = length_of(tick.raw_n) * tick.ramp;
  if (settings.has(GuardPart::coupling) && raw > 1e-9) {
    // What comes late has to be softer: with 3 ms and 10 N s/m a device of 0.1 kg hums (0.14 mm), with 4 it does not.
    const double damper = settings.coupling_ns_per_m * 1e-3 / (1.0 + 0.5 * back);
    const double over = rate_mm_s > kDamperFromMmS    ? rate_mm_s - kDamperFromMmS
                        : rate_mm_s < -kDamperFromMmS ? rate_mm_s + kDamperFromMmS
                                                      : 0.0;
    share += (1.0 - state.scale) * tick.ramp * damper * over / raw;
    share = share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
  }
  return tick.raw_n * (tick.ramp * share);
}

void hold(PassivityState& state, Vec3 force_n, Vec3 spring_mm) noexcept {
  for (std::size_t i = state.held_n.size() - 1; i > 0; --i) state.held_n[i] = state.held_n[i - 1];
  // As it would have been for the low-passed spring.
  state.held_n[0] = force_n + (state.spring_mm - spring_mm) * (state.scale * state.stiffness_n_per_mm);
}

}  // namespace cusp::engine
