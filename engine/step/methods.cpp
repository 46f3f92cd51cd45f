#include "engine/step/methods.h"

#include "engine/contact/friction.h"
#include "engine/removal/carve.h"
#include "engine/step/state.h"
#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// The surface proxy, whose tick stands in step_surface.cpp.
class SurfaceMethod final : public ContactMethod {
 public:
  void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept override {
    step_surface(state, tick, out);
  }
  bool end_stroke(StepState::Inner& state) noexcept override { return engine::end_stroke(state); }
  bool fits(StepState::Inner& state, std::uint16_t bur, Vec3 axis, Vec3 pose_mm, Look look) noexcept override {
    const Bur& head = state.scene->burs[bur];
    if (look == Look::free_space) return state.surface->in_free_space(state.volume, head, axis, pose_mm);
    return state.surface->fits(state.volume, head, axis, pose_mm);
  }
  bool cut_along(StepState::Inner& state, std::uint16_t bur, Vec3 from_mm, Vec3 to_mm) noexcept override {
    const Bur& head = state.scene->burs[bur];
    const Vec3 axis = state.scene->tool_axis;
    const bool room = engine::end_stroke(state);
    make_room_between_strokes(state);
    Carved carved;
    if (head.head.ball()) {
      const std::int32_t id = state.sweeps.add_apart(from_mm, to_mm, head.radius_mm);
      state.surface->set_cutting({.end = state.sweeps.size()});
      carved = id >= 0 ? carve_run(state.volume, state.sweeps, {id, id}) : carve_sweep(state.volume, from_mm, to_mm, head.radius_mm);
    } else {
      carved = carve_sweep(state.volume, from_mm, to_mm, head, axis);
      state.memory.add(from_mm, to_mm, {bur, axis});
      state.memory.break_path();
    }
    for_changed(carved, [&](const ChangedVoxels& changed) { state.surface->changed(state.volume, changed); });
    return room && !carved.overflow;
  }
  bool remove_voxels(StepState::Inner& state, std::span<const IVec3> voxels) noexcept override {
    const ChangedBox changed = engine::remove_voxels(state.volume, voxels);
    if (changed.any) state.surface->changed_unresolved(state.volume, changed.low, changed.high);
    return !changed.overflow;
  }
  void reload(StepState::Inner&) override {}  // what it keeps of the volume stands in state.surface
};

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
  if (state.scene->method == Method::surface) return std::make_unique<SurfaceMethod>();
  if (reading_of(state.scene->method) == Reading::filled) return make_filled_method(state);
  return make_banded_method(state);
}

}  // namespace cusp::engine
