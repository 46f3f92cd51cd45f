#include "engine/step/step.h"

#include <algorithm>
#include <cmath>

#include "engine/step/state.h"
#include "engine/step/step_fragments.h"
#include "engine/tool/swept.h"

namespace cusp::engine {

StepInput quantise(const Sample& sample, std::uint32_t elapsed_us, const StepInput& last) noexcept {
  StepInput out = last;
  out.elapsed_us = elapsed_us;
  out.buttons = static_cast<std::uint16_t>(sample.buttons & 0x1fff);
  out.pedal = sample.pedal;
  out.fragment = 0;
  out.bur = sample.bur;
  if (sample.status == Sample::Status::late) out.buttons |= StepInput::kLate;
  if (sample.status == Sample::Status::gone) out.buttons |= StepInput::kGone;
  constexpr double kMostMm = 1e5;
  if (sample.status == Sample::Status::gone) return out;
  bool good = true;
  for (int i = 0; i < 3; ++i) good = good && sample.position_mm[i] >= -kMostMm && sample.position_mm[i] <= kMostMm;
  const Quat& q = sample.orientation;
  for (const double part : {q.x, q.y, q.z, q.w}) good = good && part >= -2.0 && part <= 2.0;
  if (!good) {
    out.buttons |= StepInput::kNotFinite;
    return out;
  }
  const auto tenth_um = [](double mm) { return static_cast<std::int32_t>(std::floor(mm * 1e4 + 0.5)); };
  out.x = tenth_um(sample.position_mm.x);
  out.y = tenth_um(sample.position_mm.y);
  out.z = tenth_um(sample.position_mm.z);
  const auto part = [](double value) {
    value = value < -1.0 ? -1.0 : value > 1.0 ? 1.0 : value;
    return static_cast<std::int16_t>(std::floor(value * 32767.0 + 0.5));
  };
  out.qx = part(sample.orientation.x);
  out.qy = part(sample.orientation.y);
  out.qz = part(sample.orientation.z);
  out.qw = part(sample.orientation.w);
  return out;
}

StepState::Inner::Inner(std::shared_ptr<const Scene> s)
    : scene(std::move(s)),
      volume(scene->specimen),
      sweeps(volume.grid().centre_mm(volume.grid().size / 2), scene->method == Method::surface ? Sweeps::kMost : 0) {
  if (scene->method == Method::surface) {
    volume.keep_sweeps();
    surface = std::make_unique<SurfaceContact>(*scene, volume, memory, sweeps);
  }
  for (const Bur& bur : scene->burs) fronts.push_back(front_rings(bur.head));
  method = make_method(*this);
  if (scene->phenomena.any()) phenomena = std::make_unique<PhenomenaState>(*scene);
}

StepState::StepState(std::shared_ptr<const Scene> scene) : inner_(std::make_unique<Inner>(std::move(scene))) {}
StepState::~StepState() = default;
StepState::StepState(StepState&&) noexcept = default;
StepState& StepState::operator=(StepState&&) noexcept = default;
const Scene& StepState::scene() const noexcept { return *inner_->scene; }
const Volume& StepState::volume() const noexcept { return inner_->volume; }
const StepOutput& StepState::last() const noexcept { return inner_->last; }
Fault StepState::fault() const noexcept { return inner_->guard.fault; }

namespace {

/// The proxy's first pose: the device point if the bur fits there, else above the specimen along the tool's axis.
Vec3 first_pose(StepState::Inner& state, std::uint16_t bur_index, Vec3 device, Vec3 axis) noexcept {
  const Grid& grid = state.volume.grid();
  const Bur& bur = state.scene->burs[bur_index];
  const Vec3 low = grid.origin_mm - grid.voxel_mm;
  const Vec3 high = grid.origin_mm + grid.voxel_mm * Vec3(grid.size);
  if (state.method->fits(state, bur_index, axis, device, ContactMethod::Look::whole)) return device;
  const double reach = head_reach(bur);
  double leave = 0.0;
  for (int pass = 0; pass < 512; ++pass) {
    const Vec3 p = device + axis * leave;
    bool inside = true;
    for (int i = 0; i < 3; ++i) inside = inside && p[i] > low[i] - reach && p[i] < high[i] + reach;
    if (!inside) return p;
    leave += 0.25;
  }
  return device + axis * leave;
}

/// Contact, removal and raw force by the method, then the guard.
[[gnu::always_inline]] inline void answer(StepState::Inner& state, const Tick& asked, Vec3 moved_mm, double dt_ms,
                                          StepOutput& out) noexcept {
  const GuardSettings& settings = state.scene->guard;
  state.method->tick(state, asked, out);
  out.proxy_mm = state.proxy;
  const GuardTick tick{out.force_raw_n, asked.device, state.proxy, out.stiffness_n_per_mm, out.contact, dt_ms};
  out.force_n = guarded(settings, state.guard, tick, moved_mm, out.guard_acts);
  out.faulted = state.guard.fault != Fault::none;
}

/// The bur's axis of this input: the scene's, turned by the orientation, at most by the scene's tilt.
Vec3 axis_of(const Scene& scene, const StepInput& input) noexcept {
  const Vec3 rest = scene.tool_axis;
  if (!(scene.tilt_cosine < 1.0) || scene.method != Method::surface) return rest;
  const Vec3 u(input.qx, input.qy, input.qz);
  const double w = input.qw;
  const double square = glm::dot(u, u) + w * w;
  if (!(square > 0.0)) return rest;
  Vec3 axis = rest + (2.0 / square) * (w * glm::cross(u, rest) + glm::cross(u, glm::cross(u, rest)));
  axis = axis / std::sqrt(glm::dot(axis, axis));
  const double cosine = glm::dot(axis, rest);
  if (cosine >= scene.tilt_cosine) return axis;
  const Vec3 side = axis - rest * cosine;
  const double length = std::sqrt(glm::dot(side, side));
  if (!(length > 1e-9)) return rest;
  return rest * scene.tilt_cosine + side * (std::sqrt(1.0 - scene.tilt_cosine * scene.tilt_cosine) / length);
}

/// Near tissue one tick in so many looks whether a wanted bur fits: a look costs up to 1 ms.
constexpr std::uint64_t kTicksALook = 16;

/// The bur in use: the wanted one as soon as it fits at the proxy. Held against tissue, a bur is not changed.
std::uint16_t bur_in_use(StepState::Inner& state, const StepInput& input, Vec3 axis) noexcept {
  const std::size_t burs = state.scene->burs.size();
  const std::uint16_t wanted = input.bur < burs ? input.bur : static_cast<std::uint16_t>(burs - 1), now = state.last.bur;
  if (!state.started || wanted == now) return wanted;
  using Look = ContactMethod::Look;
  const Look look = (state.last.tick + 1) % kTicksALook == 0 ? Look::whole : Look::free_space;
  return !state.last.contact && state.method->fits(state, wanted, axis, state.proxy, look) ? wanted : now;
}

/// The tick's number, time and pose of the device.
StepOutput begin_output(const StepState::Inner& state, const StepInput& input) noexcept {
  const Scene& scene = *state.scene;
  StepOutput out;
  out.tick = state.last.tick + 1;
  out.elapsed_us = state.last.elapsed_us + input.elapsed_us;
  out.device_mm = input.position_mm();
  out.axis = axis_of(scene, input);
  return out;
}

/// Re-arms the guard if the input asks for it, then judges the input. moved_mm: of the device since the input before.
void update_fault(StepState::Inner& state, const StepInput& input, Vec3 moved_mm, double elapsed_ms) noexcept {
  const bool first = !state.started;
  const bool rearm = (input.buttons & StepInput::kRearm) != 0;
  const bool fresh = (input.buttons & StepInput::kLate) == 0;
  if (rearm) {
    state.guard.fault = Fault::none;
    release(state.guard);
    // No tick ran while the session stood, so the bur would go on at the speed that it had before.
    if (state.phenomena) state.phenomena->spindle = SpindleState{};
  }
  state.guard.stale_ms = fresh || first || rearm ? 0.0 : state.guard.stale_ms + elapsed_ms;
  if (state.guard.fault != Fault::none) return;
  const InputHistory history{std::sqrt(glm::dot(moved_mm, moved_mm)), state.guard.stale_ms,
                             first ? InputPlace::first : InputPlace::later};
  state.guard.fault = judge(state.scene->guard, input, history);
}

/// A tick with a latched fault: zero force. The proxy stays; after re-arming it follows the device to its place by
/// then.
void step_faulted(StepState::Inner& state, double dt_ms, StepOutput& out) noexcept {
  out.proxy_mm = state.started ? state.proxy : out.device_mm;
  out.faulted = true;
  out.overflow = !state.method->end_stroke(state) || out.overflow;
  release(state.guard);
  if (state.started) state.device = out.device_mm;
  if (state.phenomena) rest(*state.phenomena, dt_ms * 1e-3, out);
}

}  // namespace

StepOutput step(StepState& outer, const StepInput& input) noexcept {
  StepState::Inner& state = outer.inner();
  const Scene& scene = *state.scene;
  StepOutput out = begin_output(state, input);
  out.bur = bur_in_use(state, input, out.axis);
  const bool first = !state.started;
  const Vec3 moved = out.device_mm - state.device;
  const double elapsed_ms = static_cast<double>(input.elapsed_us) * 1e-3;
  update_fault(state, input, moved, elapsed_ms);
  if (!first && out.bur != state.last.bur) {
    release(state.guard);
    out.overflow = !state.method->end_stroke(state);
  }

  const bool fragment_leaves = input.fragment != 0 || state.fragment_removal.active();
  if (fragment_leaves) out.overflow = !remove_fragments(state, input.fragment) || out.overflow;

  const double dt_ms = std::min(elapsed_ms, scene.guard.late_ms);
  if (state.guard.fault != Fault::none) {
    step_faulted(state, dt_ms, out);
    state.last = out;
    return out;
  }

  if (first) {
    state.started = true;
    state.device = out.device_mm;
    state.proxy = first_pose(state, out.bur, out.device_mm, out.axis);
  }
  Tick asked{out.device_mm, out.axis, input.cutting(), dt_ms * 1e-3, 1.0, fragment_leaves};
  // The device's way while the guard was latched is no speed.
  const bool anew = first || (input.buttons & StepInput::kRearm) != 0;
  if (!state.phenomena) {
    answer(state, asked, anew ? Vec3(0.0) : moved, dt_ms, out);
  } else {
    turn(*state.phenomena, scene, input, out.bur, state.last, asked.dt_s, asked);
    answer(state, asked, anew ? Vec3(0.0) : moved, dt_ms, out);
    work(*state.phenomena, scene, input, asked.axis, asked.dt_s, out);
  }
  state.device = out.device_mm;
  state.last = out;
  return out;
}

}  // namespace cusp::engine
