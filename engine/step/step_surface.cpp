// One tick of the surface method: contact, the cut pose, contact again in the field that the cut left.
// Design, "Removal"; facts: contact trials, "Cutting tick".
#include <algorithm>
#include <cmath>

#include "engine/removal/carve.h"
#include "engine/removal/wear.h"
#include "engine/step/state.h"
#include "engine/step/step_fragments.h"

namespace cusp {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kTieMm = 0.005;        // the cut pose stays this close to the proxy
/// A sweep that was faster, or is longer, is only the advance: the burr flew, it did not cut there.
constexpr double kFastestMmS = 300.0, kLongestCarveMm = 1.0;
/// A stroke is carved in pieces, not each micrometre anew: meanwhile its memory keeps its poses admissible. A piece ends
/// where the stroke turns, or after half a voxel, at most kLongestPieceMm; where it is not straight to 0.1 um all the same
/// (the cut pose is drawn to the proxy), after kLeastPieceMm.
constexpr double kLongestPieceMm = 0.04;
constexpr double kLeastPieceMm = 0.008;
constexpr double kShallowTauMm = 0.005;
constexpr double kLeastTauMm = 0.00005;
/// A proxy that goes this many times as far as its device, and this much besides, is led there in kParts parts.
constexpr double kOutrunTimes = 2.0, kOutrunMm = 0.02;
constexpr int kParts = 8;
constexpr double kFrictionSpeed = 2.0;  // mm/s at which the Coulomb force is whole

/// Stiffness and the tissue that carries most of it, over the planes that hold the pose.
double blended(const Scene& scene, const Contact& contact, Tissue& most) noexcept {
  double weight = 0.0, sum = 0.0, heaviest = -1.0;
  for (int a = 0; a < contact.active; ++a) {
    const double w = contact.weight[a] > 1e-12 ? contact.weight[a] : 1e-12;
    weight += w;
    sum += w * scene.tissues[index_of(contact.tissue[a])].stiffness_n_per_mm;
    if (w > heaviest) {
      heaviest = w;
      most = contact.tissue[a];
    }
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

/// Carves the head swept from cut_from to cut_pose. False when the volume had no room.
bool carve_pending(StepState::Inner& state, const Burr& burr, bool* any) noexcept {
  state.cut_pending = false;
  const Carved carved = carve_sweep(state.volume, state.cut_from, state.cut_pose, burr, state.cut_axis);
  for_changed(carved, [&](IVec3 low, IVec3 high) { state.surface->changed(state.volume, low, high); });
  state.cut_from = state.cut_pose;
  if (any) *any = carved.any;
  return drop_crumbs(state, carved) && !carved.overflow;
}

}  // namespace

bool end_stroke(StepState::Inner& state) noexcept {
  bool room = true;
  if (state.cut_pending) room = carve_pending(state, state.scene->burrs[state.last.burr], nullptr);
  state.cut_valid = false;
  state.memory.lift();
  return room;
}

void step_surface(StepState::Inner& state, Vec3 device, Vec3 axis, bool cut, double dt_s, double removal_factor,
                  StepOutput& out) noexcept {
  const Scene& scene = *state.scene;
  const Burr& burr = scene.burrs[out.burr];
  SurfaceContact& surface = *state.surface;
  const double reach = 1.1 * length_of(device - state.device) + 0.004;
  const Vec3 before = state.proxy;

  surface.sharpen(state.volume, !cut);
  Contact contact = surface.solve(state.volume, scene, out.burr, axis, state.proxy, device, device - state.device, reach);
  const double moved = length_of(device - state.device);
  if (contact.active > 0 && !state.last.deferred && moved > 0.0 &&
      length_of(contact.pose_mm - state.proxy) > kOutrunTimes * moved + kOutrunMm) {
    // The proxy went much further than its device: over an edge perhaps that a device moving evenly would have been held
    // by. The same way once more, in parts.
    Vec3 at = state.proxy;
    const Vec3 part = (device - state.device) / static_cast<double>(kParts);
    for (int i = 1; i <= kParts; ++i) {
      const Vec3 to = i < kParts ? state.device + part * static_cast<double>(i) : device;
      contact = surface.solve(state.volume, scene, out.burr, axis, at, to, part, reach / kParts + 0.004);
      at = contact.pose_mm;
      out.infeasible = out.infeasible || contact.infeasible;
      out.overflow = out.overflow || contact.overflow;
    }
  }
  out.infeasible = out.infeasible || contact.infeasible;
  out.overflow = out.overflow || contact.overflow;
  const Vec3 slid = contact.pose_mm - state.proxy;
  state.proxy = contact.pose_mm;
  Tissue touched = Tissue::empty;
  double stiffness = blended(scene, contact, touched);
  const double push = length_of(device - state.proxy);

  if (cut && contact.active > 0 && push > 1e-6 && !contact.deferred) {
    const double alpha = wear_coefficient(push, stiffness, scene.full_force_n);
    const Vec3 aim_from = state.cut_valid ? state.cut_pose + slid : state.proxy;
    const Vec3 old_pose = state.cut_valid ? state.cut_pose : state.proxy;
    Vec3 pose = aim_from;
    // Tied to the proxy: bias must not add up.
    const Vec3 off = pose - state.proxy;
    const double apart = length_of(off);
    if (apart > kTieMm) pose = state.proxy + off * (kTieMm / apart);

    Vec3 to_device = device - pose;
    double gap = length_of(to_device);
    Vec3 direction = gap > 1e-9 ? to_device / gap : Vec3(0.0);
    const double own = scene.tissues[index_of(touched)].speed_mm_s;
    const double speed = burr.head.ball()
                             ? front_speed(state.volume, scene, pose, burr.radius_mm, direction, own)
                             : front_speed(state.volume, scene, pose, state.fronts[out.burr], axis, direction, own);
    double advance = alpha * speed * dt_s * removal_factor;
    if (contact.shank && glm::dot(contact.shank_normal, direction) < -0.05) advance = 0.0;

    // Sliding: a burr that moves this far in a tick may stand only so deep, if nothing recedes faster than it wears.
    const double slide = length_of(slid);
    if (slide > 1e-6 && advance > 0.0) {
      const double tau = slide_depth(burr, axis, direction, slid, advance);
      if (tau < kShallowTauMm) {
        if (state.cut_pending) out.overflow = !carve_pending(state, burr, nullptr) || out.overflow;
        Vec3 out_pose;
        const double shallow = tau > kLeastTauMm ? tau : kLeastTauMm;
        if (surface.push_out(state.volume, burr, axis, pose, shallow, out_pose)) {
          pose = out_pose;
        } else {
          pose = state.proxy;
          advance = 0.0;
        }
        to_device = device - pose;
        gap = length_of(to_device);
        direction = gap > 1e-9 ? to_device / gap : Vec3(0.0);
      }
    }
    if (advance > gap) advance = gap;
    const Vec3 next = pose + direction * advance;
    if (advance > 0.0) {
      const bool whole = state.cut_valid && length_of(next - old_pose) <= std::min(kLongestCarveMm, kFastestMmS * dt_s);
      const Vec3 from = whole ? old_pose : pose;
      if (!whole) {
        if (state.cut_pending) out.overflow = !carve_pending(state, burr, nullptr) || out.overflow;
        state.memory.lift();
      }
      if (state.cut_pending && !(state.cut_axis == axis))
        out.overflow = !carve_pending(state, burr, nullptr) || out.overflow;
      state.cut_axis = axis;
      const bool straight_on = state.memory.add(from, next, sweeper_of(burr, out.burr, axis));
      if (state.cut_pending && !straight_on)
        out.overflow = !carve_pending(state, burr, nullptr) || out.overflow;
      if (!state.cut_pending) state.cut_from = from;
      state.cut_pose = next;
      state.cut_pending = true;
      out.cutting = true;
      out.advance_mm = advance;
      const double piece = state.memory.straight_from(state.cut_from)
                               ? std::min(kLongestPieceMm, 0.5 * state.volume.grid().voxel_mm)
                               : kLeastPieceMm;
      if (length_of(next - state.cut_from) >= piece)
        out.overflow = !carve_pending(state, burr, &out.cutting) || out.overflow;
    } else {
      if (state.cut_pending) out.overflow = !carve_pending(state, burr, nullptr) || out.overflow;
      state.cut_pose = next;
    }
    state.cut_valid = true;

    contact = surface.after_cut(state.volume, scene, out.burr, axis, contact, device, advance);
    out.infeasible = out.infeasible || contact.infeasible;
    out.overflow = out.overflow || contact.overflow;
    state.proxy = contact.pose_mm;
    if (contact.active > 0) stiffness = blended(scene, contact, touched);
  } else if (state.cut_valid && (!cut || contact.active == 0)) {
    out.overflow = !end_stroke(state) || out.overflow;
  }

  out.deferred = contact.deferred;
  out.shank = contact.shank;
  const Vec3 spring = state.proxy - device;
  out.contact = contact.active > 0 && length_of(spring) > 1e-6;
  if (!out.contact) {
    state.velocity = Vec3(0.0);
    return;
  }
  out.tissue = touched;
  out.stiffness_n_per_mm = stiffness;
  out.force_raw_n = stiffness * spring;
  if (scene.friction && dt_s > 0.0) {
    // Coulomb, regularised by the proxy's own speed: at rest it holds nothing, so it cannot feed energy.
    state.velocity = (state.proxy - before) / dt_s;
    const double speed = length_of(state.velocity);
    if (speed > 1e-9) {
      const double whole = speed < kFrictionSpeed ? speed / kFrictionSpeed : 1.0;
      out.force_raw_n -= state.velocity * (scene.friction_coefficient * stiffness * length_of(spring) * whole / speed);
    }
  }
}

}  // namespace cusp
