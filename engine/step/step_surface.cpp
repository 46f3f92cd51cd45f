// One tick of the surface method: contact, the cut pose, contact again with the cut stored and not yet carved.
#include <algorithm>

#include "engine/contact/cavity/sweeps.h"
#include "engine/removal/carve.h"
#include "engine/removal/wear.h"
#include "engine/step/methods.h"
#include "engine/step/state.h"
#include "engine/step/step_fragments.h"
#include "engine/volume/fragments.h"

namespace cusp::engine {

namespace {

/// A stroke is carved in sweeps; meanwhile contact knows its poses. A sweep ends after half a voxel, and at kLongestSweepMm.
constexpr double kLongestSweepMm = 0.04;
/// Of a ball that does not go straight. Contact has its sweeps exactly before and after; a carving costs a tick 75 us.
constexpr double kLeastBallSweepMm = 0.06;
/// A piece of another head's sweep ends where a bend of its path leaves the line by more: its clearance while it cuts, less what
/// the field rounds by (4e-4 of a voxel of 0.1 mm).
constexpr double kBentMm = SurfaceContact::kClearanceMm - 4e-5;
/// A shorter slide takes at most its own length too much, and a carved sweep moves the contact that far anyway.
constexpr double kLeastSlideMm = 0.0004;
/// While sliding, the bur may stand this deep in tissue: more than kShallowTauMm needs no correction (slide_depth()).
constexpr double kShallowTauMm = 0.005;
constexpr double kLeastTauMm = 0.00005;
/// A proxy that outruns its device by this factor and this length is solved for again, in parts of the way.
constexpr double kOutrunTimes = 1.5, kOutrunMm = 0.02;
constexpr int kParts = 8, kHeadParts = 4;  // the second of a head that is no ball and does not cut: its search costs more
/// Reach of a search: the device's motion times kReach, and kReachMm.
constexpr double kReach = 1.1, kReachMm = 0.004;
/// Tolerance of a prediction, as a share of the device's motion and a length. The proxy's excess motion predicts the
/// next one if it is larger, and differs from the last tick's by less.
constexpr double kPredictionTolerance = 0.1, kPredictionToleranceMm = 0.002;

/// By the active set.
Touched touched_by(const Scene& scene, const Contact& contact) noexcept {
  Touched out;
  double weight = 0.0, sum = 0.0, heaviest = -1.0;
  for (int a = 0; a < contact.active; ++a) {
    const double w = contact.weight[a] > 1e-12 ? contact.weight[a] : 1e-12;
    weight += w;
    sum += w * scene.tissues[index_of(contact.tissue[a])].stiffness_n_per_mm;
    if (w > heaviest) {
      heaviest = w;
      out.tissue = contact.tissue[a];
    }
  }
  if (weight > 0.0) out.stiffness_n_per_mm = sum / weight;
  return out;
}

/// What contact has to know of a ball's sweeps while it cuts.
Cutting cutting_of(const StepState::Inner& state) noexcept {
  Cutting out;
  const StepState::Inner::PendingSweep& sweep = state.pending_sweep;
  if (state.cut_pending || sweep.waits)
    out.uncarved = {sweep.waits ? sweep.first : state.cut_first, state.cut_last};
  if (out.uncarved.from < 0) out.uncarved = {};
  out.end = out.uncarved.to >= out.uncarved.from ? out.uncarved.from : state.sweeps.size();
  return out;
}

/// Carves the pending sweep. False if the volume had no room.
bool carve_pending(StepState::Inner& state) noexcept {
  StepState::Inner::PendingSweep& sweep = state.pending_sweep;
  if (!sweep.waits) return true;
  const Bur& bur = state.scene->burs[sweep.bur];
  Carved carved;
  if (!bur.head.ball())
    carved = carve_sweep(state.volume, sweep.way, bur, sweep.axis, sweep.start_carved ? SweepStart::carved : SweepStart::uncut);
  else if (sweep.first >= 0)
    carved = carve_run(state.volume, state.sweeps, {sweep.first, sweep.last});
  else
    carved = carve_sweep(state.volume, sweep.way.first(), sweep.way.last(), bur.radius_mm);
  for_changed(carved, [&](const ChangedVoxels& changed) { state.surface->changed(state.volume, changed); });
  sweep.waits = false;
  state.surface->set_cutting(cutting_of(state));
  const bool room = drop_crumbs(state, carved);
  return room && !carved.overflow;
}

/// Queues the sweep along cut_way to cut_pose, after carving the one that was pending. False if the volume had no room.
bool queue_sweep(StepState::Inner& state, std::uint16_t bur) noexcept {
  const bool room = carve_pending(state);
  StepState::Inner::PendingSweep& sweep = state.pending_sweep;
  const bool goes_on =
      sweep.way.count > 0 && sweep.way.last() == state.cut_way.first() && sweep.axis == state.cut_axis && sweep.bur == bur;
  sweep = {state.cut_way, state.cut_axis, bur, goes_on, state.cut_first, state.cut_last, true};
  sweep.way.add(state.cut_pose);
  state.cut_way = {{state.cut_pose}, 1};
  state.sweeps.seal();
  state.cut_pending = false;
  return room;
}

/// Carves all that has been swept. False if the volume had no room.
bool carve_all(StepState::Inner& state, std::uint16_t bur) noexcept {
  const bool room = !state.cut_pending || queue_sweep(state, bur);
  return carve_pending(state) && room;
}

/// The device's motion in a tick, and the proxy's answer to it.
struct Motion {
  Vec3 way{0.0};        // of the device, mm
  double moved = 0.0;   // length of it
  Vec3 slid{0.0};       // of the proxy, mm
};

void add_flags(const Contact& contact, StepOutput& out) noexcept {
  out.infeasible = out.infeasible || contact.infeasible;
  out.overflow = out.overflow || contact.overflow;
}

/// Of a solve for the whole way of the device, or in parts for one that the proxy outruns.
enum class WayIs : std::uint8_t { whole, outrun };
const SurfaceContact::Budget& budget_of(const StepState::Inner& state, const Tick& tick, std::uint16_t bur, WayIs way) noexcept {
  if (!tick.cut && !state.cut_valid) return SurfaceContact::kExploring;
  return way == WayIs::outrun && !state.scene->burs[bur].head.ball() ? SurfaceContact::kShort : SurfaceContact::kCutting;
}

/// Solves for the same way in parts. In one step the proxy can cross an edge that stops an evenly moving device. Once a part of the
/// way outruns it too, by more than `most`, the rest is one part.
Contact solve_in_parts(StepState::Inner& state, const Tick& tick, const Motion& motion, double most, StepOutput& out) noexcept {
  SurfaceContact& surface = *state.surface;
  surface.reset_budget(budget_of(state, tick, out.bur, WayIs::outrun));
  Contact contact;
  Vec3 at = state.proxy;
  const int parts = tick.cut || state.scene->burs[out.bur].head.ball() ? kParts : kHeadParts;
  const Vec3 part = motion.way / static_cast<double>(parts);
  const double part_reach = kReach * motion.moved / parts + kReachMm;
  for (int i = 1; i <= parts && !(i > 1 && surface.spent()); ++i) {
    if (length_of(at - state.proxy) > most) i = parts;
    const Vec3 to = i < parts ? state.device + part * static_cast<double>(i) : tick.device;
    contact = surface.solve(state.volume, *state.scene, out.bur, tick.axis, at, to, part, part_reach, SurfaceContact::kAnyWay);
    at = contact.pose_mm;
    add_flags(contact, out);
    contact.deferred = contact.deferred || (i < parts && surface.spent());
  }
  return contact;
}

/// Solves for the device's new position.
Contact follow_device(StepState::Inner& state, const Tick& tick, const Motion& motion, StepOutput& out) noexcept {
  SurfaceContact& surface = *state.surface;
  const double moved = motion.moved;
  const Vec3 predicted = state.prediction_holds ? motion.way + state.predicted_excess * moved : motion.way;
  const double reach = kReach * std::max(moved, length_of(predicted)) + kReachMm;
  const double most = kOutrunTimes * moved + kOutrunMm;
  const bool led = !state.last.deferred && moved > 0.0;

  surface.start_tick(cutting_of(state), budget_of(state, tick, out.bur, WayIs::whole));
  // The tick that ends a stroke carves the rest of it; edges are resolved in later ticks.
  const bool cuts = tick.cut || state.cut_valid;
  surface.resolve(state.volume, state.scene->burs[out.bur], tick.axis, state.proxy,
                  cuts                   ? SurfaceContact::Resolve::off
                  : tick.fragment_leaves ? SurfaceContact::Resolve::wait
                                         : SurfaceContact::Resolve::now);
  Contact contact = surface.solve(state.volume, *state.scene, out.bur, tick.axis, state.proxy, tick.device, predicted, reach,
                                  led ? most : SurfaceContact::kAnyWay);
  if ((contact.active > 0 || contact.deferred) && led && !contact.in_steps && length_of(contact.pose_mm - state.proxy) > most)
    contact = solve_in_parts(state, tick, motion, most, out);
  add_flags(contact, out);
  return contact;
}

/// Solves again where the last tick has carved a head's sweep: what that moves the proxy by is no slide.
void settle_on_carved(StepState::Inner& state, std::uint16_t bur) noexcept {
  if (!state.carved) return;
  state.carved = false;
  state.surface->start_tick(cutting_of(state), SurfaceContact::kShort);
  state.proxy = state.surface->solve(state.volume, *state.scene, bur, state.cut_axis, state.proxy, state.device, Vec3(0.0), kReachMm,
                                     SurfaceContact::kAnyWay).pose_mm;
}

/// Keeps how the proxy's motion differed from the device's, for the next tick's prediction.
void update_prediction(StepState::Inner& state, const Contact& contact, const Motion& motion) noexcept {
  const double moved = motion.moved;
  const Vec3 other = motion.slid - motion.way;
  const bool follows = contact.active > 0 && !contact.deferred && moved > 0.0;
  state.prediction_holds =
      follows && length_of(other) > kPredictionTolerance * moved + kPredictionToleranceMm &&
      length_of(other - state.predicted_excess * moved) < kPredictionTolerance * moved + kPredictionToleranceMm;
  state.predicted_excess = follows ? other / moved : Vec3(0.0);
}

/// A sliding bur may stand only so deep, if no tissue recedes faster than it wears. True if the pending sweeps were carved.
bool limit_slide(StepState::Inner& state, const Tick& tick, const Pressed& pressed, Advance& cut, StepOutput& out) noexcept {
  if (!(length_of(pressed.slid) > kLeastSlideMm && cut.advance_mm > 0.0)) return false;
  const Bur& bur = state.scene->burs[out.bur];
  const double tau = slide_depth(bur, tick.axis, cut.head.direction, pressed.slid, cut.advance_mm);
  if (!(tau < kShallowTauMm)) return false;
  out.overflow = !carve_all(state, out.bur) || out.overflow;
  Vec3 out_pose;
  const double shallow = tau > kLeastTauMm ? tau : kLeastTauMm;
  if (state.surface->push_out(state.volume, *state.scene, out.bur, tick.axis, cut.pose, shallow, out_pose)) {
    cut.pose = out_pose;
  } else {
    cut.pose = state.proxy;
    cut.advance_mm = 0.0;
  }
  cut.head = push_of_head(tick.device - cut.pose, pressed.walls);
  return true;
}

/// Stores a way of the bur. A sweep that does not go on with it is queued.
void store_way(StepState::Inner& state, const Tick& tick, Vec3 from, Vec3 to, StepOutput& out) noexcept {
  const Bur& bur = state.scene->burs[out.bur];
  if (bur.head.ball()) {
    if (state.cut_pending && state.cut_last - state.cut_first + 1 >= kMostAtOnce)
      out.overflow = !queue_sweep(state, out.bur) || out.overflow;
    const std::int32_t id = state.sweeps.add(from, to, bur.radius_mm);
    out.overflow = id == Sweeps::kNone || out.overflow;
    // Where the store of ways is full, what comes has no id: it is carved apart from what has.
    if (state.cut_pending && (id == Sweeps::kNone) != (state.cut_last == Sweeps::kNone))
      out.overflow = !queue_sweep(state, out.bur) || out.overflow;
    state.cut_last = id;
    if (!state.cut_pending) state.cut_first = state.cut_last;
    return;
  }
  if (state.cut_pending && !(state.cut_axis == tick.axis)) out.overflow = !queue_sweep(state, out.bur) || out.overflow;
  state.memory.add(from, to, {out.bur, tick.axis});
  if (!state.cut_pending || state.memory.nearly_straight_from(state.cut_way.last(), kBentMm)) return;
  if (state.cut_way.count + 1 < Polyline::kMost) {
    state.cut_way.add(from);
  } else {
    out.overflow = !queue_sweep(state, out.bur) || out.overflow;
  }
}

/// Of a way that goes on to `end`, mm.
double length_to(const Polyline& way, Vec3 end) noexcept {
  double length = length_of(end - way.last());
  for (std::size_t i = 1; i < static_cast<std::size_t>(way.count); ++i) length += length_of(way.vertex[i] - way.vertex[i - 1]);
  return length;
}

/// Stores the advance and lengthens the growing sweep, or queues it.
void sweep_along(StepState::Inner& state, const Tick& tick, const Advance& cut, Vec3 old_pose, Vec3 next,
                 StepOutput& out) noexcept {
  const bool whole = state.cut_valid && swept_whole(length_of(next - old_pose), tick.dt_s);
  const Vec3 from = whole ? old_pose : cut.pose;
  if (!whole) {
    out.overflow = !carve_all(state, out.bur) || out.overflow;
    state.memory.break_path();
    state.sweeps.break_path();
  }
  store_way(state, tick, from, next, out);
  if (!state.cut_pending) state.cut_way = {{from}, 1};
  state.cut_axis = tick.axis;
  state.cut_pose = next;
  state.cut_pending = true;
  out.cutting = true;
  out.advance_mm = cut.advance_mm;
  const bool bent_ball = state.scene->burs[out.bur].head.ball() && state.cut_last != state.cut_first;
  const double longest_mm = bent_ball ? kLeastBallSweepMm : std::min(kLongestSweepMm, 0.5 * state.volume.grid().voxel_mm);
  if (length_to(state.cut_way, next) >= longest_mm) out.overflow = !queue_sweep(state, out.bur) || out.overflow;
  state.surface->set_cutting(cutting_of(state));
}

/// Advances the bur into the tissue. Returns contact after it. pressed: of `contact`, but for the walls.
Contact cut_tissue(StepState::Inner& state, const Tick& tick, const Contact& contact, Pressed pressed, StepOutput& out) noexcept {
  const Vec3 old_pose = state.cut_valid ? state.cut_pose : state.proxy;
  Vec3 wall[3];
  std::size_t walls = 0;
  for (int a = 0; a < contact.active; ++a)
    if (contact.of_shank[a]) wall[walls++] = contact.normal[a];
  pressed.walls = {wall, walls};
  Advance cut = advance_of(state, tick, pressed, out);
  const bool carved = limit_slide(state, tick, pressed, cut, out);
  const Vec3 next = cut.end();
  if (cut.advance_mm > 0.0) {
    sweep_along(state, tick, cut, old_pose, next, out);
  } else {
    out.overflow = !carve_all(state, out.bur) || out.overflow;
    state.cut_pose = next;
  }
  state.cut_valid = true;
  // It goes on about as far as the cut does.
  const Contact after = state.surface->solve(state.volume, *state.scene, out.bur, tick.axis, contact.pose_mm, tick.device,
                                             cut.end() - cut.pose, cut.advance_mm + kReachMm, SurfaceContact::kAnyWay);
  // The field waits: a ball's sweeps and a head's past poses count at once. A tick carves once at most, for the
  // features about the bur are recomputed afterwards: by the next tick.
  if (state.pending_sweep.waits && !carved) {
    out.overflow = !carve_pending(state) || out.overflow;
    state.carved = !state.scene->burs[out.bur].head.ball();
  }
  add_flags(after, out);
  state.proxy = after.pose_mm;
  return after;
}

class SurfaceMethod final : public ContactMethod {
 public:
  void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept override {
    const Scene& scene = *state.scene;
    settle_on_carved(state, out.bur);
    const Vec3 device = tick.device, before = state.proxy;
    Motion motion{device - state.device};
    motion.moved = length_of(motion.way);
    Contact contact = follow_device(state, tick, motion, out);
    motion.slid = contact.pose_mm - state.proxy;
    update_prediction(state, contact, motion);
    state.proxy = contact.pose_mm;
    Touched touched = touched_by(scene, contact);
    const double push_mm = length_of(device - state.proxy);

    // A deferred contact has not converged, so the push is not known: such a tick cuts nothing (swept_whole() in carve.h).
    if (tick.cut && contact.active > 0 && push_mm > 1e-6 && !contact.deferred) {
      contact = cut_tissue(state, tick, contact, {touched, push_mm, motion.slid, CavityWalls::kTieMm}, out);
      if (contact.active > 0) touched = touched_by(scene, contact);
    } else if (state.cut_valid && (!tick.cut || contact.active == 0 || contact.deferred)) {
      out.overflow = !end_stroke(state) || out.overflow;
      if (contact.active == 0) make_room_between_strokes(state);
    }

    out.deferred = contact.deferred;
    out.shank = contact.shank();
    out.contact = contact.active > 0 && length_of(state.proxy - device) > 1e-6;
    if (out.contact) press_back(state, tick, touched, before, out);
  }
  bool end_stroke(StepState::Inner& state) noexcept override {
    const bool room = carve_all(state, state.last.bur);
    state.pending_sweep = {};
    state.cut_valid = false;
    state.memory.break_path();
    state.sweeps.break_path();
    state.surface->set_cutting(cutting_of(state));
    return room;
  }
  bool fits(StepState::Inner& state, std::uint16_t bur, Vec3 axis, Vec3 pose_mm, Look look) noexcept override {
    const Bur& head = state.scene->burs[bur];
    if (look == Look::free_space) return state.surface->in_free_space(state.volume, head, axis, pose_mm);
    return state.surface->fits(state.volume, head, axis, pose_mm);
  }
  bool remove_voxels(StepState::Inner& state, std::span<const IVec3> voxels) noexcept override {
    const ChangedBox changed = engine::remove_voxels(state.volume, voxels);
    if (changed.any) state.surface->changed_unresolved(state.volume, changed.low, changed.high);
    return !changed.overflow;
  }
  void reload(StepState::Inner&) override {}  // what it keeps of the volume stands in state.surface

 private:
  /// Forgets sweeps that own no wall, if their store wants room. Pre: no stroke.
  void make_room_between_strokes(StepState::Inner& state) noexcept {
    if (!make_room(state.sweeps, state.volume)) return;
    state.cut_first = 0;
    state.cut_last = Sweeps::kNone;
    state.surface->forget();
    state.surface->set_cutting(cutting_of(state));
  }
};

}  // namespace

std::unique_ptr<ContactMethod> make_surface_method() { return std::make_unique<SurfaceMethod>(); }

}  // namespace cusp::engine
