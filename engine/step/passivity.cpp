#include "engine/step/passivity.h"

#include <cmath>

namespace cusp {

namespace {

/// Low-pass of 3 ms at any tick: one count of an encoder (0.05 mm) becomes 12.5 mm/s instead of 50, and what dithers
/// between two counts weighs a twenty-eighth of itself in the energy. A ringing at 50 Hz still shows by half.
constexpr double kSmoothMs = 3.0;
/// How fast the coupling stiffens again where the hand has put in what that takes [M].
constexpr double kRecoverPerMs = 0.0005;

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// Energy of a spring that gives no more than `most_n` (mJ).
double stored_mj(double k_n_per_mm, double stretch_mm, double most_n) noexcept {
  if (!(k_n_per_mm > 0.0)) return 0.0;
  const double bend = most_n / k_n_per_mm;
  return stretch_mm <= bend ? 0.5 * k_n_per_mm * stretch_mm * stretch_mm : most_n * (stretch_mm - 0.5 * bend);
}

}  // namespace

Vec3 passive(const GuardSettings& settings, PassivityState& state, const GuardTick& tick) noexcept {
  if (!state.primed) state.device_mm = tick.device_mm;
  state.primed = true;
  const double smooth = tick.dt_ms / (tick.dt_ms + kSmoothMs);
  const Vec3 spring = tick.contact ? tick.proxy_mm - tick.device_mm : Vec3(0.0);
  if (!tick.contact && state.open) {
    state.gap_ms += tick.dt_ms;
    if (state.gap_ms > kEpisodeGapMs) {
      state.open = false;
      state.scale = 1.0;
      state.bank_mj = 0.0;
    }
  }
  if (tick.contact) {
    if (!state.open) {
      state.open = true;
      state.room_mj = settings.passivity_mj;
    }
    state.gap_ms = 0.0;
  }

  int back = static_cast<int>(settings.delay_ms + 0.5);
  if (!(back > 0)) back = 0;
  if (back > kMostDelayTicks) back = kMostDelayTicks;
  const Vec3 before_device = state.device_mm, before_spring = state.spring_mm;
  state.given_n += (state.held_n[static_cast<std::size_t>(back)] - state.given_n) * smooth;
  state.device_mm += (tick.device_mm - state.device_mm) * smooth;
  state.spring_mm += (spring - state.spring_mm) * smooth;
  if (!state.open) return tick.raw_n;

  const double most = settings.has(GuardPart::limit) ? settings.limit_n : 1e6;
  const double stretch = length_of(state.spring_mm), stretch_before = length_of(before_spring);
  const double k = tick.stiffness_n_per_mm;
  // A tissue's stiffness may change under the burr: that is the scene's own doing, and not owed.
  const double stored = stored_mj(state.scale * k, stretch, most);
  const double given = glm::dot(state.given_n, state.device_mm - before_device);
  state.room_mj -= given + stored - stored_mj(state.scale * k, stretch_before, most);
  if (state.room_mj > settings.passivity_mj) {
    state.bank_mj += state.room_mj - settings.passivity_mj;
    state.room_mj = settings.passivity_mj;
  }
  if (state.room_mj < 0.0) {
    state.scale = stored > -state.room_mj ? state.scale * (1.0 + state.room_mj / stored) : 0.0;
    state.room_mj += stored - stored_mj(state.scale * k, stretch, most);
  } else if (state.scale < 1.0) {
    double rise = kRecoverPerMs * tick.dt_ms;
    if (rise > 1.0 - state.scale) rise = 1.0 - state.scale;
    const double cost = stored_mj((state.scale + rise) * k, stretch, most) - stored;
    if (cost > state.bank_mj) rise = state.bank_mj > 0.0 ? rise * (state.bank_mj / cost) : 0.0;
    state.scale += rise;
    state.bank_mj -= cost < state.bank_mj ? cost : state.bank_mj;
  }
  if (!(state.scale < 1.0)) return tick.raw_n;

  // What the softened spring lacks, a bounded damper gives in part: never more than the method's own force.
  double share = state.scale;
  const double raw = length_of(tick.raw_n);
  if (settings.has(GuardPart::coupling) && raw > 1e-9 && tick.dt_ms > 0.0) {
    const double rate_mm_s = (stretch - stretch_before) / (tick.dt_ms * 1e-3);
    share += (1.0 - state.scale) * settings.coupling_ns_per_m * 1e-3 * rate_mm_s / raw;
    share = share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
  }
  return tick.raw_n * share;
}

void hold(PassivityState& state, Vec3 force_n) noexcept {
  for (std::size_t i = state.held_n.size() - 1; i > 0; --i) state.held_n[i] = state.held_n[i - 1];
  state.held_n[0] = force_n;
}

}  // namespace cusp
