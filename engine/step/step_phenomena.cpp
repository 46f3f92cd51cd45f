#include "engine/step/step_phenomena.h"

#include "engine/step/methods.h"

namespace cusp::engine {

namespace {

/// Force that presses the bur on the tissue, without friction, N.
double push_of(const StepOutput& out) noexcept {
  return out.contact ? out.stiffness_n_per_mm * length_of(out.proxy_mm - out.device_mm) : 0.0;
}

void sign(StepOutput& out, PhenomenonSign what) noexcept {
  out.phenomena = static_cast<std::uint8_t>(out.phenomena | static_cast<unsigned>(what));
}

void report(const PhenomenaState& state, StepOutput& out) noexcept {
  out.spindle_rpm = static_cast<float>(state.spindle.rpm);
  out.heat_k = static_cast<float>(state.heat.rise_k);
  if (state.spindle.stalled) sign(out, PhenomenonSign::stalled);
}

}  // namespace

PhenomenaState::PhenomenaState(const Scene& scene) noexcept
    : settings(settings_of(scene.phenomena.handpiece)), stiffest_n_per_mm(0.0) {
  for (const TissueFeel& feel : scene.tissues)
    if (feel.stiffness_n_per_mm > stiffest_n_per_mm) stiffest_n_per_mm = feel.stiffness_n_per_mm;
}

void turn(PhenomenaState& state, const Scene& scene, const StepInput& input, std::uint16_t bur, const StepOutput& before, double dt_s,
          Tick& tick) noexcept {
  if (scene.phenomena.handpiece == Handpiece::none) return;
  // A device without a pedal has the cut button: pressed is fully down.
  const double pedal = input.pedal > 0 ? static_cast<double>(input.pedal) / 65535.0 : input.cutting() ? 1.0 : 0.0;
  if (bur != before.bur) state.spindle = SpindleState{};  // the spindle stops for a bur change
  advance(state.spindle, state.settings, pedal, push_of(before), scene.burs[bur].radius_mm, dt_s);
  tick.cut = state.spindle.rpm > 0.0;
  tick.removal_factor = removal_factor(state.spindle, state.settings);
}

void work(PhenomenaState& state, const Scene& scene, const StepInput& input, Vec3 axis, double dt_s,
          StepOutput& out) noexcept {
  const Phenomena& asked = scene.phenomena;
  const bool turns = asked.handpiece == Handpiece::none ? input.cutting() : state.spindle.rpm > 0.0;
  const bool works = turns && out.contact;
  const double push_n = works ? push_of(out) : 0.0;
  if (asked.heat) {
    const bool coolant = (input.buttons & StepInput::kCoolant) != 0;
    const double rpm = asked.handpiece == Handpiece::none ? kUnknownRpm : state.spindle.rpm;
    const double surface_mm_s = surface_speed_mm_s(rpm, scene.burs[out.bur].radius_mm);
    if (advance(state.heat, {push_n, surface_mm_s, coolant, dt_s})) sign(out, PhenomenonSign::overheated);
    if (coolant) sign(out, PhenomenonSign::coolant);
    if (works && !coolant) sign(out, PhenomenonSign::dry);
  }
  report(state, out);

  if (asked.handpiece == Handpiece::none) return;
  const double given = length_of(out.force_n);
  double wave_n = 0.0;
  if (asked.vibration) {
    const double hardness = state.stiffest_n_per_mm > 0.0 ? out.stiffness_n_per_mm / state.stiffest_n_per_mm : 0.0;
    wave_n = vibration_n(state.vibration, state.settings, state.spindle.rpm, works ? given : 0.0, hardness, dt_s);
  }
  if (!works || !(given > 1e-9)) return;
  Vec3 force = out.force_n * (1.0 + wave_n / given) +
               drag_n(out.force_n, axis, removal_factor(state.spindle, state.settings));
  const double size = length_of(force);
  if (scene.guard.has(GuardPart::limit) && size > scene.guard.limit_n) force *= scene.guard.limit_n / size;
  out.force_n = force;
}

void rest(PhenomenaState& state, double dt_s, StepOutput& out) noexcept {
  advance(state.spindle, state.settings, 0.0, 0.0, kStallRadiusMm, dt_s);
  static_cast<void>(advance(state.heat, {0.0, 0.0, false, dt_s}));
  report(state, out);
}

}  // namespace cusp::engine
