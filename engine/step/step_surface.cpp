// One tick of the surface method: contact, the cut pose, contact again in the field that the cut left.
// Design, "Removal"; facts: contact trials, "Cutting tick".
#include <algorithm>
#include <cmath>

#include "engine/removal/carve.h"
#include "engine/removal/uncut.h"
#include "engine/removal/wear.h"
#include "engine/step/state.h"
#include "engine/step/step_fragments.h"

namespace cusp::engine {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kTieMm = 0.005;        // the cut pose stays this close to the proxy
/// A stroke is carved in pieces, not each micrometre anew: meanwhile its memory keeps its poses admissible. A piece ends
/// where the stroke turns, or after half a voxel, at most kLongestPieceMm; where it is not straight to 0.1 um all the same
/// (the cut pose is drawn to the proxy), after kLeastPieceMm.
constexpr double kLongestPieceMm = 0.04;
constexpr double kLeastPieceMm = 0.008;
/// A shorter slide cannot take more than its own length too much; and contact itself moves that far when a piece is carved.
constexpr double kLeastSlideMm = 0.0004;
constexpr double kShallowTauMm = 0.005;
constexpr double kLeastTauMm = 0.00005;
/// Sliding over what strokes have left, a ball is lifted out of what no stroke has taken, but for this much more.
constexpr double kUncutMm = 0.0001;
/// There wear that is less than this a tick enters as this much, in as many ticks as make it up: each stroke over the edge of a
/// ridge takes a little besides, as straight as it is led, and hundreds of them are more than contact tells apart.
constexpr double kEntersMm = 0.0001;
constexpr double kAsideMm[] = {0.0, 0.05, -0.05, 0.1, -0.1};  // along a crest, where it looks once more
/// A proxy that goes this many times as far as its device, and this much besides, is led there in kParts parts.
constexpr double kOutrunTimes = 1.5, kOutrunMm = 0.02;
constexpr int kParts = 8;
/// How far one search of contact looks: a little further than the device has moved.
constexpr double kReach = 1.1, kReachMm = 0.004;
/// A proxy's move that differs from its device's by this much of it, and this much besides, is taken for what comes next.
constexpr double kStrays = 0.1, kStraysMm = 0.002;
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

/// Carves some more of the piece that is owed. False when the volume had no room.
bool carve_some(StepState::Inner& state, int bricks) noexcept {
  StepState::Inner::Owed& owed = state.owed_piece;
  if (owed.next < 0) return true;
  const Carved carved = carve_sweep(state.volume, owed.from, owed.to, state.scene->burs[owed.bur], owed.axis,
                                    owed.start_carved, {owed.next, bricks});
  for_changed(carved, [&](IVec3 low, IVec3 high) { state.surface->changed(state.volume, low, high); });
  owed.next = carved.next;
  const bool room = drop_crumbs(state, carved);
  return room && !carved.overflow;
}

constexpr int kAllBricks = 1 << 30;

/// Bricks a tick that carve a piece well before the next one is due.
int bricks_a_tick(const StepState::Inner& state) noexcept {
  const StepState::Inner::Owed& owed = state.owed_piece;
  const double side = kBrickEdge * state.volume.grid().voxel_mm;
  const Bur& bur = state.scene->burs[owed.bur];
  const double across = 2.0 * bur.radius_mm / side + 1.0;
  const double along = bur.head.ball() ? across : (bur.head.high() - bur.head.low()) / side + 1.0;
  // A small bur's front is in few bricks, and their cells would be made again for each: at once it is cheaper.
  return across * along < 10.0 ? kAllBricks : 1 + static_cast<int>(across * along / 16.0);
}

/// Ends the piece from cut_from to cut_pose: it is owed from now on. What was owed before is carved.
bool owe_pending(StepState::Inner& state, std::uint16_t bur) noexcept {
  const bool room = carve_some(state, kAllBricks);
  StepState::Inner::Owed& owed = state.owed_piece;
  const bool goes_on = owed.to == state.cut_from && owed.axis == state.cut_axis && owed.bur == bur;
  owed = {state.cut_from, state.cut_pose, state.cut_axis, bur, goes_on, 0};
  state.cut_from = state.cut_pose;
  state.cut_pending = false;
  return room;
}

/// Carves all that has been swept. False when the volume had no room.
bool carve_pending(StepState::Inner& state, std::uint16_t bur) noexcept {
  const bool room = !state.cut_pending || owe_pending(state, bur);
  return carve_some(state, kAllBricks) && room;
}

/// What enters of a ball's wear in this tick: even over any stretch of ticks, by the golden ratio's multiples.
double entering(double advance_mm, std::int64_t tick) noexcept {
  if (!(advance_mm > 0.0) || advance_mm >= kEntersMm) return advance_mm;
  const auto turn = static_cast<std::uint32_t>(static_cast<std::uint64_t>(tick) * 2654435769u);
  return static_cast<double>(turn) * 0x1p-32 * kEntersMm < advance_mm ? kEntersMm : 0.0;
}

/// Moves a ball out of what no stroke has taken until it stands no deeper than allowed_mm.
void lift_out(const StepState::Inner& state, double radius_mm, Vec3 towards, double allowed_mm, Vec3& pose) noexcept {
  UncutPlace place(state.volume, state.memory, radius_mm, pose, towards);
  const auto lift = [&](Vec3 start, bool beside) {
    const Uncut uncut = place.deepest(pose, start, allowed_mm, beside);
    if (uncut.depth_mm > allowed_mm) pose -= uncut.towards * (uncut.depth_mm - allowed_mm);
    return uncut;
  };
  const Uncut first = lift(towards, false);
  if (first.along == Vec3(0.0)) return;
  // What many strokes have crossed has a peak between each two of them.
  for (const double aside : kAsideMm) {
    const Vec3 start = first.towards + first.along * (aside / radius_mm);
    lift(start / std::sqrt(glm::dot(start, start)), true);
  }
}

}  // namespace

bool end_stroke(StepState::Inner& state) noexcept {
  const bool room = carve_pending(state, state.last.bur);
  state.owed_piece = {};
  state.cut_valid = false;
  state.memory.lift();
  return room;
}

void step_surface(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept {
  const Vec3 device = tick.device, axis = tick.axis;
  const bool cut = tick.cut;
  const double dt_s = tick.dt_s, removal_factor = tick.removal_factor;
  const Scene& scene = *state.scene;
  const Bur& bur = scene.burs[out.bur];
  SurfaceContact& surface = *state.surface;
  const Vec3 way = device - state.device;
  const double moved = length_of(way);
  // Where it rolls along edges the proxy goes another way than its device, for some ticks much the same one.
  const Vec3 ahead = state.strays ? way + state.astray * moved : way;
  const double reach = kReach * std::max(moved, length_of(ahead)) + kReachMm;
  const double most = kOutrunTimes * moved + kOutrunMm;
  const bool led = !state.last.deferred && moved > 0.0;
  const Vec3 before = state.proxy;

  surface.allow_passes();
  // The tick that ends a stroke carves what is left of it; edges are for those after it.
  surface.sharpen(state.volume, bur, axis, state.proxy, !cut && !state.cut_valid, tick.piece_goes);
  Contact contact = surface.solve(state.volume, scene, out.bur, axis, state.proxy, device, ahead, reach,
                                  led ? most : SurfaceContact::kAnyWay);
  if ((contact.active > 0 || contact.deferred) && led && length_of(contact.pose_mm - state.proxy) > most) {
    // The proxy went much further than its device: over an edge perhaps that a device moving evenly would have been held
    // by. The same way once more, in parts.
    surface.allow_passes();
    Vec3 at = state.proxy;
    const Vec3 part = way / static_cast<double>(kParts);
    const double part_reach = kReach * moved / kParts + kReachMm;
    for (int i = 1; i <= kParts && !(i > 1 && surface.spent()); ++i) {
      const Vec3 to = i < kParts ? state.device + part * static_cast<double>(i) : device;
      contact = surface.solve(state.volume, scene, out.bur, axis, at, to, part, part_reach, SurfaceContact::kAnyWay);
      at = contact.pose_mm;
      out.infeasible = out.infeasible || contact.infeasible;
      out.overflow = out.overflow || contact.overflow;
      contact.deferred = contact.deferred || (i < kParts && surface.spent());
    }
  }
  out.infeasible = out.infeasible || contact.infeasible;
  out.overflow = out.overflow || contact.overflow;
  const Vec3 slid = contact.pose_mm - state.proxy;
  const Vec3 other = slid - way;
  const bool follows = contact.active > 0 && !contact.deferred && moved > 0.0;
  state.strays = follows && length_of(other) > kStrays * moved + kStraysMm &&
                 length_of(other - state.astray * moved) < kStrays * moved + kStraysMm;
  state.astray = follows ? other / moved : Vec3(0.0);
  state.proxy = contact.pose_mm;
  Tissue touched = Tissue::empty;
  double stiffness = blended(scene, contact, touched);
  const double push = length_of(device - state.proxy);

  // While contact is still on its way to where it will stand, how hard the bur is pressed is not known: what the device has
  // run ahead would count as push. Such a tick cuts nothing, and none was met while cutting: balls of 1 to 6 mm on a face and
  // across a ridge of many strokes, at 50 to 300 mm/s, above which a bur flies (carve.h).
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
    const double speed = bur.head.ball()
                             ? front_speed(state.volume, scene, pose, bur.radius_mm, direction, own, out.tick)
                             : front_speed(state.volume, scene, pose, state.fronts[out.bur], axis, direction, own, out.tick);
    double advance = alpha * speed * dt_s * removal_factor;
    if (contact.shank && glm::dot(contact.shank_normal, direction) < -0.05) advance = 0.0;

    // Sliding: a bur that moves this far in a tick may stand only so deep, if nothing recedes faster than it wears.
    const double slide = length_of(slid);
    bool carved = false;
    if (slide > kLeastSlideMm && advance > 0.0) {
      const double tau = slide_depth(bur, axis, direction, slid, advance);
      if (tau < kShallowTauMm) {
        out.overflow = !carve_pending(state, out.bur) || out.overflow;
        carved = true;
        Vec3 out_pose;
        const double shallow = tau > kLeastTauMm ? tau : kLeastTauMm;
        if (surface.push_out(state.volume, bur, axis, pose, shallow, out_pose)) {
          pose = out_pose;
        } else {
          pose = state.proxy;
          advance = 0.0;
        }
        if (bur.head.ball()) {
          lift_out(state, bur.radius_mm, direction, shallow + kUncutMm, pose);
          out.cutting = advance > 0.0;
          advance = entering(advance, static_cast<std::int64_t>(out.tick));
        }
        to_device = device - pose;
        gap = length_of(to_device);
        direction = gap > 1e-9 ? to_device / gap : Vec3(0.0);
      }
    }
    if (advance > gap) advance = gap;
    const Vec3 next = pose + direction * advance;
    if (advance > 0.0) {
      const bool whole = state.cut_valid && swept_whole(length_of(next - old_pose), dt_s);
      const Vec3 from = whole ? old_pose : pose;
      if (!whole) {
        out.overflow = !carve_pending(state, out.bur) || out.overflow;
        state.memory.lift();
      }
      if (state.cut_pending && !(state.cut_axis == axis))
        out.overflow = !owe_pending(state, out.bur) || out.overflow;
      state.cut_axis = axis;
      const bool straight_on = state.memory.add(from, next, sweeper_of(bur, out.bur, axis));
      if (state.cut_pending && !straight_on) out.overflow = !owe_pending(state, out.bur) || out.overflow;
      if (!state.cut_pending) state.cut_from = from;
      state.cut_pose = next;
      state.cut_pending = true;
      out.cutting = true;
      out.advance_mm = advance;
      const double piece = state.memory.straight_from(state.cut_from)
                               ? std::min(kLongestPieceMm, 0.5 * state.volume.grid().voxel_mm)
                               : kLeastPieceMm;
      if (length_of(next - state.cut_from) >= piece)
        out.overflow = !owe_pending(state, out.bur) || out.overflow;
    } else {
      out.overflow = !carve_pending(state, out.bur) || out.overflow;
      state.cut_pose = next;
    }
    state.cut_valid = true;

    // Before contact is looked for again: how the proxy moves because the field has changed is no slide. A small bur's piece
    // only once a tick: what is about the bur is made out anew after it.
    if (state.owed_piece.next >= 0) {
      const int bricks = bricks_a_tick(state);
      if (!carved || bricks != kAllBricks) out.overflow = !carve_some(state, bricks) || out.overflow;
    }
    contact = surface.after_cut(state.volume, scene, out.bur, axis, contact, device, advance);
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

}  // namespace cusp::engine
