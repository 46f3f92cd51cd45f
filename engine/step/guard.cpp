#include "engine/step/guard.h"

namespace cusp::engine {

namespace {

/// Time constant of the velocity's low-pass: an encoder step of 0.05 mm in one tick reads as 10 mm/s, not 50.
constexpr double kVelocityMs = 4.0;
/// A late tick may raise the force no more than one in time.
constexpr double kMostRiseMs = 1.0;

bool zero(Vec3 v) noexcept { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; }

/// True without contact and without any effect of an earlier one. Every part then gives zero, so only position and
/// speed are kept.
bool at_rest(const GuardSettings& settings, const GuardState& state, const GuardTick& tick) noexcept {
  const PassivityState& p = state.passivity;
  if (tick.contact || state.acted != 0 || !zero(tick.raw_n) || !zero(state.given_n) || !zero(p.spring_mm)) return false;
  if (!settings.has(GuardPart::passivity)) return false;
  if (!p.primed || p.scale != 1.0 || p.surplus_mj != 0.0 || p.margin_mj != settings.passivity_mj) return false;
  for (const Vec3& held : p.held_n)
    if (!zero(held)) return false;
  return true;
}

std::uint16_t bit(GuardPart part) noexcept { return static_cast<std::uint16_t>(part); }

/// Parts speed and limit: shortens the force. Returns those that did.
std::uint16_t bound_size(const GuardSettings& settings, const GuardState& state, Vec3& force) noexcept {
  std::uint16_t acts = 0;
  const double wanted = length_of(force);
  double given = wanted;
  if (settings.has(GuardPart::speed) && wanted > 1e-12) {
    // A device that moves along the force is thrown by it. A push against the force does not fade it at any speed.
    const double away = glm::dot(state.velocity_mm_s, force) / wanted;
    if (away > settings.speed_mm_s) {
      const double over = away / settings.speed_mm_s - 1.0;
      given = over < 1.0 ? given * (1.0 - over) : 0.0;
      acts = bit(GuardPart::speed);
    }
  }
  if (settings.has(GuardPart::limit) && given > settings.limit_n) {
    given = settings.limit_n;
    acts = static_cast<std::uint16_t>(acts | bit(GuardPart::limit));
  }
  if (given < wanted) force *= given / wanted;
  return acts;
}

/// Part slew: bounds what the force gains over the share of the last force that it keeps. Returns the part if it did.
std::uint16_t bound_rise(const GuardSettings& settings, const GuardState& state, double dt_ms, Vec3& force) noexcept {
  if (!settings.has(GuardPart::slew)) return 0;
  const double before = glm::dot(state.given_n, state.given_n);
  double kept = before > 1e-18 ? glm::dot(force, state.given_n) / before : 0.0;
  kept = kept < 0.0 ? 0.0 : kept > 1.0 ? 1.0 : kept;
  const Vec3 rise = force - state.given_n * kept;
  const double most = settings.slew_n_per_ms * (dt_ms < kMostRiseMs ? dt_ms : kMostRiseMs);
  const double rises = length_of(rise);
  if (!(rises > most)) return 0;
  force = state.given_n * kept + rise * (most / rises);
  return bit(GuardPart::slew);
}

}  // namespace

Fault judge(const GuardSettings& settings, const StepInput& input, const InputHistory& history) noexcept {
  if (input.buttons & StepInput::kGone) return input.buttons & StepInput::kLate ? Fault::not_finite : Fault::gone;
  if (history.place == InputPlace::first || (input.buttons & StepInput::kRearm)) return Fault::none;
  if (settings.has(GuardPart::late) && input.elapsed_us > settings.late_ms * 1000.0) return Fault::late;
  if (settings.has(GuardPart::stale) && history.stale_ms > settings.stale_ms) return Fault::stale;
  if (settings.has(GuardPart::jump) && !(history.jump_mm <= settings.jump_mm)) return Fault::jump;
  return Fault::none;
}

Vec3 guarded(const GuardSettings& settings, GuardState& state, const GuardTick& tick, Vec3 moved_mm,
             std::uint16_t& acts) noexcept {
  acts = 0;
  const double square = glm::dot(tick.raw_n, tick.raw_n);
  if (!(square <= 1e12)) state.fault = state.fault == Fault::none ? Fault::not_finite : state.fault;  // NaN too
  if (state.fault != Fault::none) {
    release(state);
    return Vec3(0.0);
  }
  const auto act = [&](GuardPart part) { acts = static_cast<std::uint16_t>(acts | static_cast<unsigned>(part)); };
  state.ramp_ms += tick.dt_ms;
  if (tick.dt_ms > 0.0) {
    const Vec3 velocity = moved_mm / (tick.dt_ms * 1e-3);
    state.velocity_mm_s += (velocity - state.velocity_mm_s) * (tick.dt_ms / (tick.dt_ms + kVelocityMs));
  }
  if (at_rest(settings, state, tick)) {
    state.passivity.device_mm += tick.device_mm - state.passivity.device_mm;
    return Vec3(0.0);
  }

  GuardTick now = tick;
  if (settings.has(GuardPart::ramp_in) && state.ramp_ms < settings.ramp_in_ms) {
    now.ramp = state.ramp_ms / settings.ramp_in_ms;
    if (square > 0.0) act(GuardPart::ramp_in);
  }
  Vec3 force = now.ramp < 1.0 ? now.raw_n * now.ramp : now.raw_n;
  if (settings.has(GuardPart::passivity)) {
    force = passive(settings, state.passivity, now);
    if (state.passivity.scale < 1.0 && tick.contact) act(GuardPart::passivity);
  }
  // Its size, then its rise: the other way round gives another force.
  const unsigned bounded = bound_size(settings, state, force);
  acts = static_cast<std::uint16_t>(acts | bounded | bound_rise(settings, state, tick.dt_ms, force));
  state.given_n = force;
  hold(state.passivity, force, tick.contact ? tick.proxy_mm - tick.device_mm : Vec3(0.0));
  const std::uint16_t now_acted = acts;
  acts = static_cast<std::uint16_t>(acts | state.acted);
  state.acted = now_acted;
  return force;
}

void release(GuardState& state) noexcept {
  state.ramp_ms = 0.0;
  state.given_n = Vec3(0.0);
  state.acted = 0;
  state.velocity_mm_s = Vec3(0.0);
  state.passivity = PassivityState{};
}

}  // namespace cusp::engine
