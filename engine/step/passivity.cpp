#include "engine/step/passivity.h"

namespace cusp::engine {

namespace {

/// Low-pass of 3 ms at any tick, never further behind than half an encoder step. A dither between two counts then has
/// little energy, and real motion shows at once. A ringing groove gives up to 0.044 mJ before it shows; at a whole step
/// behind, 0.09 mJ.
constexpr double kSmoothMs = 3.0, kBehindSteps = 0.5;
/// Rise of the scale per ms, where the hand has put in the energy for it; and without contact [M].
constexpr double kRecoverPerMs = 0.0005, kRecoverFreePerMs = 0.005;
/// Largest deficit, in passivity_mj: 0.45 mJ. At 0.015 mJ, ticks late by 50 ms would feed six times as much.
constexpr double kMostDeficit = 30.0;
/// The damper begins above the speed that one encoder count reads as, so that it does not chatter.
constexpr double kDamperFromMmS = 15.0;
/// Least stiffness of a softened wall, at most kLeastNPerMm. Half of the least damping (0.5 N s/m) bears it if the
/// force is late by half a tick and the delay. Such a wall is passive on any device.
constexpr double kLeastNPerMm = 0.2, kHalfDampingNsPerMm = 0.25e-3, kHalfTickS = 0.0005;
/// Largest power that an encoder's noise takes while the bur slides on a slope (measured: 0.004 mJ/s at 2 N/mm, 50
/// mm/s).
constexpr double kNoiseMjPerMs = 5e-6;

/// A spring whose force is limited.
struct LimitedSpring {
  double k_n_per_mm, most_n;
};

double stored_mj(const LimitedSpring& spring, double stretch_mm) noexcept {
  const auto [k_n_per_mm, most_n] = spring;
  if (!(k_n_per_mm > 0.0)) return 0.0;
  const double bend = most_n / k_n_per_mm;
  return stretch_mm <= bend ? 0.5 * k_n_per_mm * stretch_mm * stretch_mm : most_n * (stretch_mm - 0.5 * bend);
}

/// Spring and device of a tick, low-passed.
struct Motion {
  Vec3 moved_mm{0.0};  // of the device
  double stretch_mm = 0.0, stretch_before_mm = 0.0;
  double rate_mm_s = 0.0;  // of the stretch
};

/// Round trip in ticks.
int delay_ticks(const GuardSettings& settings) noexcept {
  const int ticks = static_cast<int>(settings.delay_ms + 0.5);
  if (!(ticks > 0)) return 0;
  return ticks > kMostDelayTicks ? kMostDelayTicks : ticks;
}

double force_limit_n(const GuardSettings& settings) noexcept {
  return settings.has(GuardPart::limit) ? settings.limit_n : 1e6;
}

/// Advances the low-passed device point and spring.
Motion follow(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept {
  const Vec3 spring = tick.contact ? tick.proxy_mm - tick.device_mm : Vec3(0.0);
  double share = tick.dt_ms / (tick.dt_ms + kSmoothMs);
  const double off = length_of(spring - state.spring_mm);
  const double behind_mm = kBehindSteps * settings.encoder_mm;
  if (off * (1.0 - share) > behind_mm) share = 1.0 - behind_mm / off;
  if (!tick.contact) share = 1.0;
  const Vec3 before_device = state.device_mm, before_spring = state.spring_mm;
  state.device_mm += (tick.device_mm - state.device_mm) * share;
  state.spring_mm += (spring - state.spring_mm) * share;

  Motion out;
  out.moved_mm = state.device_mm - before_device;
  out.stretch_mm = length_of(state.spring_mm);
  out.stretch_before_mm = length_of(before_spring);
  out.rate_mm_s = tick.dt_ms > 0.0 ? (out.stretch_mm - out.stretch_before_mm) / (tick.dt_ms * 1e-3) : 0.0;
  return out;
}

/// Takes the energy of the tick from the margin: the held force's work, and the change of the softened spring's energy.
/// A change of the stiffness under the bur, or of the ramp, is no part of it. Returns the spring's energy, mJ.
double account(const GuardSettings& settings, PassivityState& state, const Motion& motion, double dt_ms) noexcept {
  const double most = force_limit_n(settings);
  const double k = state.stiffness_n_per_mm;
  const double stored = stored_mj({state.scale * k, most}, motion.stretch_mm);
  const double given = glm::dot(state.held_n[static_cast<std::size_t>(delay_ticks(settings))], motion.moved_mm);
  state.margin_mj -=
      given + stored - stored_mj({state.scale * k, most}, motion.stretch_before_mm) - kNoiseMjPerMs * dt_ms;
  if (state.margin_mj > settings.passivity_mj) {
    state.surplus_mj += state.margin_mj - settings.passivity_mj;
    state.margin_mj = settings.passivity_mj;
  }
  return stored;
}

/// Without contact: scale and margin recover by time.
void recover(const GuardSettings& settings, PassivityState& state, double dt_ms) noexcept {
  state.surplus_mj = 0.0;
  state.scale += kRecoverFreePerMs * dt_ms;
  if (state.scale > 1.0) state.scale = 1.0;
  const double forgive = kRecoverFreePerMs * dt_ms < 1.0 ? kRecoverFreePerMs * dt_ms : 1.0;
  state.margin_mj += forgive * (settings.passivity_mj - state.margin_mj);
}

/// A deficit lowers the scale by what the deficit takes out of the spring's energy.
void soften(const GuardSettings& settings, PassivityState& state, const Motion& motion, double stored) noexcept {
  const double k = state.stiffness_n_per_mm;
  const double bears = kHalfDampingNsPerMm / (kHalfTickS + 1e-3 * delay_ticks(settings));
  const double least_n_per_mm = bears < kLeastNPerMm ? bears : kLeastNPerMm;
  const double least = k > least_n_per_mm ? least_n_per_mm / k : 1.0;
  double scale = stored > -state.margin_mj ? state.scale * (1.0 + state.margin_mj / stored) : 0.0;
  if (scale < least) scale = least;
  if (scale < state.scale) state.scale = scale;
  state.margin_mj += stored - stored_mj({state.scale * k, force_limit_n(settings)}, motion.stretch_mm);
  const double most_deficit_mj = kMostDeficit * settings.passivity_mj;
  if (state.margin_mj < -most_deficit_mj) state.margin_mj = -most_deficit_mj;
}

/// Raises the scale by what the surplus pays for.
void stiffen(const GuardSettings& settings, PassivityState& state, const Motion& motion, double stored,
             double dt_ms) noexcept {
  double rise = motion.rate_mm_s > kDamperFromMmS ? 1.0 : kRecoverPerMs * dt_ms;
  if (rise > 1.0 - state.scale) rise = 1.0 - state.scale;
  const double cost =
      stored_mj({(state.scale + rise) * state.stiffness_n_per_mm, force_limit_n(settings)}, motion.stretch_mm) - stored;
  if (cost > state.surplus_mj) rise = state.surplus_mj > 0.0 ? rise * (state.surplus_mj / cost) : 0.0;
  state.scale += rise;
  state.surplus_mj -= cost < state.surplus_mj ? cost : state.surplus_mj;
}

/// Share of the method's force for a softened spring, [0, 1]. A bounded damper gives part of what the spring lacks.
double damped_share(const GuardSettings& settings, const PassivityState& state, const GuardTick& tick,
                    double rate_mm_s) noexcept {
  const double raw = length_of(tick.raw_n) * tick.ramp;
  if (!settings.has(GuardPart::coupling) || !(raw > 1e-9)) return state.scale;
  // A late force has to be softer. At 3 ms a device of 0.1 kg vibrates by 0.14 mm with 10 N s/m, and not with 4 N s/m.
  const double damper = settings.coupling_ns_per_m * 1e-3 / (1.0 + 0.5 * delay_ticks(settings));
  const double over = rate_mm_s > kDamperFromMmS    ? rate_mm_s - kDamperFromMmS
                      : rate_mm_s < -kDamperFromMmS ? rate_mm_s + kDamperFromMmS
                                                    : 0.0;
  const double share = state.scale + (1.0 - state.scale) * tick.ramp * damper * over / raw;
  return share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
}

}  // namespace

Vec3 passive(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept {
  if (tick.contact) state.stiffness_n_per_mm = tick.stiffness_n_per_mm * tick.ramp;
  if (!state.primed) {
    state.primed = true;
    state.device_mm = tick.device_mm;
    state.margin_mj = settings.passivity_mj;
  }
  const Motion motion = follow(settings, state, tick);
  const double stored = account(settings, state, motion, tick.dt_ms);
  if (!tick.contact) {
    recover(settings, state, tick.dt_ms);
    return tick.raw_n * tick.ramp;
  }
  if (state.margin_mj < 0.0) {
    soften(settings, state, motion, stored);
  } else if (state.scale < 1.0) {
    stiffen(settings, state, motion, stored, tick.dt_ms);
  }
  if (!(state.scale < 1.0)) return tick.raw_n * tick.ramp;
  return tick.raw_n * (tick.ramp * damped_share(settings, state, tick, motion.rate_mm_s));
}

void hold(PassivityState& state, Vec3 force_n, Vec3 spring_mm) noexcept {
  for (std::size_t i = state.held_n.size() - 1; i > 0; --i) state.held_n[i] = state.held_n[i - 1];
  // The force for the low-passed spring.
  state.held_n[0] = force_n + (state.spring_mm - spring_mm) * (state.scale * state.stiffness_n_per_mm);
}

}  // namespace cusp::engine
