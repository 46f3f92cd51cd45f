#include "engine/step/methods.h"

#include "engine/step/state.h"

namespace cusp::engine {

namespace {

constexpr double kFrictionWholeMmS = 2.0;  // speed at which the Coulomb force is whole

/// Coulomb friction against the proxy's velocity, N. Regularised by that speed: at rest it holds nothing, so it cannot feed
/// energy. spring_n: the push that the cone stands on.
Vec3 coulomb_n(Vec3 velocity_mm_s, double coefficient, double spring_n) noexcept {
  const double speed = length_of(velocity_mm_s);
  if (!(speed > 1e-9)) return Vec3(0.0);
  const double whole = speed < kFrictionWholeMmS ? speed / kFrictionWholeMmS : 1.0;
  return velocity_mm_s * (-coefficient * spring_n * whole / speed);
}

}  // namespace

Advance advance_of(const StepState::Inner& state, const Tick& tick, const Pressed& pressed, const StepOutput& now) noexcept {
  const Scene& scene = *state.scene;
  Advance out;
  out.pose = state.cut_valid ? state.cut_pose + pressed.slid : state.proxy;
  const Vec3 off = out.pose - state.proxy;
  const double apart = length_of(off);
  if (apart > pressed.tie_mm) out.pose = state.proxy + off * (pressed.tie_mm / apart);
  out.head = push_of_head(tick.device - out.pose, pressed.walls);
  const double alpha = wear_coefficient(pressed.push_mm * out.head.share, pressed.touched.stiffness_n_per_mm, scene.full_force_n);
  const double own = scene.tissues[index_of(pressed.touched.tissue)].speed_mm_s;
  const Front front{scene.burs[now.bur], state.fronts[now.bur], tick.axis, out.pose, out.head.direction};
  out.advance_mm = alpha * front_speed(state.volume, scene, front, own, now.tick) * tick.dt_s * tick.removal_factor;
  return out;
}

void press_back(const StepState::Inner& state, const Tick& tick, const Touched& touched, Vec3 before, StepOutput& out) noexcept {
  const Scene& scene = *state.scene;
  const Vec3 spring = state.proxy - tick.device;
  out.tissue = touched.tissue;
  out.stiffness_n_per_mm = touched.stiffness_n_per_mm;
  out.force_raw_n = touched.stiffness_n_per_mm * spring;
  if (scene.friction && tick.dt_s > 0.0)
    out.force_raw_n += coulomb_n((state.proxy - before) / tick.dt_s, scene.friction_coefficient,
                                 touched.stiffness_n_per_mm * length_of(spring));
}

std::unique_ptr<ContactMethod> make_method(StepState::Inner& state) {
  if (state.scene->method == Method::surface) return make_surface_method();
  if (reading_of(state.scene->method) == Reading::filled) return make_filled_method(state);
  return make_banded_method(state);
}

}  // namespace cusp::engine
