/// The only list of the fields that the next step depends on. StepState::hash(), save() and restore() are visitors of
/// it, and tests/engine/step/state_fields.cpp changes each of its fields in turn. Each visit() uses a structured
/// binding of its struct: a new member that is not listed does not compile. Only engine/step and its tests include
/// this.
///
/// A visitor `f` has:
///   f(name, value)                  a number, enum, bool or Vec3; value is a T&, or a const T& if the state is const
///   f.size(name, now, least_bytes)  length of a list, each entry at least so many bytes when saved; returns the new
///                                   length
///   f.cuts(name, volume)            the volume's cut field
///   f.sweeps(name, sweeps, volume)  the balls' sweeps, and their ids in the volume; after its cuts
///   f.refuse()                      the visited values are no state; not called if the state is const
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "engine/step/state.h"

namespace cusp::engine {

template <class T, class Of>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Of>;

template <class Fields, MaybeConst<StepOutput> T>
void visit(Fields& f, T& output) {
  auto& [device_mm, proxy_mm, axis, force_raw_n, force_n, stiffness_n_per_mm, advance_mm, tissue, bur, spindle_rpm, tick,
         elapsed_us, contact, cutting, shank, faulted, infeasible, overflow, deferred, phenomena, guard_acts, heat_k] = output;
  f("last.device_mm", device_mm);
  f("last.proxy_mm", proxy_mm);
  f("last.axis", axis);
  f("last.force_raw_n", force_raw_n);
  f("last.force_n", force_n);
  f("last.stiffness_n_per_mm", stiffness_n_per_mm);
  f("last.advance_mm", advance_mm);
  f("last.tissue", tissue);
  f("last.bur", bur);
  f("last.spindle_rpm", spindle_rpm);
  f("last.tick", tick);
  f("last.elapsed_us", elapsed_us);
  f("last.contact", contact);
  f("last.cutting", cutting);
  f("last.shank", shank);
  f("last.faulted", faulted);
  f("last.infeasible", infeasible);
  f("last.overflow", overflow);
  f("last.deferred", deferred);
  f("last.phenomena", phenomena);
  f("last.guard_acts", guard_acts);
  f("last.heat_k", heat_k);
}

template <class Fields, MaybeConst<PassivityState> T>
void visit(Fields& f, T& passivity) {
  auto& [primed, scale, margin_mj, surplus_mj, device_mm, spring_mm, stiffness_n_per_mm, held_n] = passivity;
  f("guard.passivity.primed", primed);
  f("guard.passivity.scale", scale);
  f("guard.passivity.margin_mj", margin_mj);
  f("guard.passivity.surplus_mj", surplus_mj);
  f("guard.passivity.device_mm", device_mm);
  f("guard.passivity.spring_mm", spring_mm);
  f("guard.passivity.stiffness_n_per_mm", stiffness_n_per_mm);
  for (auto& force : held_n) f("guard.passivity.held_n", force);
}

template <class Fields, MaybeConst<GuardState> T>
void visit(Fields& f, T& guard) {
  auto& [fault, ramp_ms, given_n, acted, stale_ms, velocity_mm_s, passivity] = guard;
  f("guard.fault", fault);
  f("guard.ramp_ms", ramp_ms);
  f("guard.given_n", given_n);
  f("guard.acted", acted);
  f("guard.stale_ms", stale_ms);
  f("guard.velocity_mm_s", velocity_mm_s);
  visit(f, passivity);
}

template <class Fields, MaybeConst<Polyline> T>
void visit(Fields& f, T& way) {
  f("way.count", way.count);
  for (auto& vertex : way.vertex) f("way.vertex", vertex);
}

template <class Fields, MaybeConst<StepState::Inner::PendingSweep> T>
void visit(Fields& f, T& sweep) {
  auto& [way, axis, bur, start_carved, first, last, waits] = sweep;
  visit(f, way);
  f("pending_sweep.axis", axis);
  f("pending_sweep.bur", bur);
  f("pending_sweep.start_carved", start_carved);
  f("pending_sweep.first", first);
  f("pending_sweep.last", last);
  f("pending_sweep.waits", waits);
}

template <class Fields, MaybeConst<PhenomenaState> T>
void visit(Fields& f, T& state) {
  // settings and stiffest_n_per_mm are the scene's.
  [[maybe_unused]] auto& [settings, stiffest_n_per_mm, spindle, vibration, heat] = state;
  auto& [rpm, stalled] = spindle;
  auto& [phase] = vibration;
  auto& [rise_k, over] = heat;
  f("phenomena.spindle.rpm", rpm);
  f("phenomena.spindle.stalled", stalled);
  f("phenomena.vibration.phase", phase);
  f("phenomena.heat.rise_k", rise_k);
  f("phenomena.heat.over", over);
}

template <class Fields, MaybeConst<CutMemory::Segment> T>
void visit(Fields& f, T& segment) {
  auto& [a, b, by] = segment;
  auto& [head, axis] = by;
  f("memory.segment.a", a);
  f("memory.segment.b", b);
  f("memory.segment.by.head", head);
  f("memory.segment.by.axis", axis);
}
/// Three Vec3 and a number.
inline constexpr std::size_t kSegmentBytes = 3 * 24 + 4;

template <class Fields, MaybeConst<CutMemory> T>
void visit(Fields& f, T& memory) {
  bool open = memory.open();
  f("memory.open", open);
  const std::size_t count = f.size("memory.segments", memory.size(), kSegmentBytes);
  if constexpr (std::is_const_v<T>) {
    for (std::size_t i = 0; i < count; ++i) visit(f, memory.segment(i));
  } else {
    std::vector<CutMemory::Segment> segments(count);
    for (std::size_t i = 0; i < count && i < memory.size(); ++i) segments[i] = memory.segment(i);
    for (CutMemory::Segment& segment : segments) visit(f, segment);
    memory.load(segments, open ? CutMemory::Newest::open : CutMemory::Newest::closed);
  }
}

template <class Fields, MaybeConst<FragmentRemoval::Entry> T>
void visit(Fields& f, T& entry) {
  auto& [brick, voxels] = entry;
  f("fragment_removal.entry.brick", brick);
  for (auto& slice : voxels.slice) f("fragment_removal.entry.voxels", slice);
}
/// A brick and eight slices.
inline constexpr std::size_t kFragmentEntryBytes = 4 + 8 * 8;

/// bricks: of the specimen.
template <class Fields, MaybeConst<FragmentRemoval> T>
void visit(Fields& f, T& removal, int bricks) {
  std::uint16_t half = removal.half();
  f("fragment_removal.half", half);
  const std::size_t count = f.size("fragment_removal.entries", removal.entries().size(), kFragmentEntryBytes);
  if constexpr (std::is_const_v<T>) {
    for (const FragmentRemoval::Entry& entry : removal.entries()) visit(f, entry);
  } else {
    std::vector<FragmentRemoval::Entry> entries(removal.entries().begin(), removal.entries().end());
    entries.resize(count);
    for (FragmentRemoval::Entry& entry : entries) visit(f, entry);
    if (!removal.load(half, entries, bricks)) f.refuse();
  }
}

/// Which parts of the cut's surface are resolved, brick by brick in index order. Pre: the surface's volume has been visited.
template <class Fields, MaybeConst<SurfaceContact> T>
void visit(Fields& f, T& surface, const Volume& volume, int bricks) {
  const CutSurface& cut = surface.cut_surface();
  bool resolves = cut.resolves();
  f("surface.resolves", resolves);
  constexpr bool kWrites = !std::is_const_v<T>;
  std::vector<CutSurface::Parts> resolved(kWrites ? static_cast<std::size_t>(bricks) : 0);  // [brick]
  for (int brick = 0; brick < bricks; ++brick) {
    if (!volume.has_cut(brick)) continue;
    CutSurface::Parts parts = cut.resolved(volume, brick);
    f("surface.resolved", parts);
    if constexpr (kWrites) resolved[static_cast<std::size_t>(brick)] = parts;
  }
  CavityWalls::Found found = surface.found_in_cavity();
  f("surface.found.centre", found.sampled.at);
  f("surface.found.radius_mm", found.sampled.radius_mm);
  f("surface.found.reach_mm", found.sampled.slack_mm);
  f("surface.found.features", found.features);
  for (std::int32_t i = 0; i < std::min<std::int32_t>(found.features, CavityWalls::kMostKept); ++i)
    f("surface.found.foot", found.foot[i]);
  if constexpr (kWrites) surface.set_found_in_cavity(found);
  if constexpr (kWrites)
    surface.load_resolved(volume, resolves ? Resolving::on : Resolving::off, [&](int brick) { return resolved[static_cast<std::size_t>(brick)]; });
}

template <class Fields, MaybeConst<StepState::Inner> T>
void visit(Fields& f, T& state) {
  // scene is what the state is of; fronts and method are made from it.
  [[maybe_unused]] auto& [scene, volume, last, guard, proxy, device, predicted_excess, prediction_holds, cut_pose, started, cut_valid,
                          cut_pending, carved, cut_way, cut_axis, cut_first, cut_last, pending_sweep, wear_remainder, foot, memory, sweeps, fragment_removal, fronts, surface, method,
                          phenomena] = state;
  const IVec3 count = scene->specimen->brick_count();
  const int bricks = count.x * count.y * count.z;
  visit(f, last);
  visit(f, guard);
  f("proxy", proxy);
  f("device", device);
  f("predicted_excess", predicted_excess);
  f("prediction_holds", prediction_holds);
  f("cut_pose", cut_pose);
  f("started", started);
  f("cut_valid", cut_valid);
  f("cut_pending", cut_pending);
  f("carved", carved);
  visit(f, cut_way);
  f("cut_axis", cut_axis);
  f("cut_first", cut_first);
  f("cut_last", cut_last);
  visit(f, pending_sweep);
  for (auto& remainder : wear_remainder) f("wear_remainder", remainder);
  f("foot", foot);
  visit(f, memory);
  visit(f, fragment_removal, bricks);
  if (phenomena) {
    std::conditional_t<std::is_const_v<T>, const PhenomenaState, PhenomenaState>& phenomena_state = *phenomena;
    visit(f, phenomena_state);
  }
  f.cuts("volume.cuts", volume);
  f.sweeps("sweeps", sweeps, volume);
  if (surface) {
    std::conditional_t<std::is_const_v<T>, const SurfaceContact, SurfaceContact>& contact = *surface;
    visit(f, contact, volume, bricks);
  }
}

}  // namespace cusp::engine
