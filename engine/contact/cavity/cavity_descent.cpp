// From a place of what is left to the nearest place of its wall, ridge or corner: steps along the planes of the sides about it.
#include <algorithm>
#include <cmath>

#include "engine/contact/cavity/cavity_walls.h"

namespace cusp::engine {

namespace {

constexpr double kFalseMm = 1e-4;          // a place that stands so far above its feature lies in the void
constexpr double kSameMm = 1e-4;           // features nearer to each other are one
constexpr double kJumpMm = 1e-3;           // a place further from its last one is another place
constexpr int kSettlePasses = 6;           // three settle a place at an islet's tips (stability), and two overlap it by 94 um
constexpr double kDescendedMm = 2e-4;      // a shorter step ends it: off by 0.2 nm in distance
constexpr double kGainMm = 1e-5;           // a step comes nearer by this: a search takes less for no entry (surface_cavity.cpp)
constexpr double kBlockedMm = 1e-3;        // a wall that ends a step sooner holds the place: the step goes over it
constexpr double kTrustGrows = 2.0;        // of a step that came nearer, up to kStepVoxels
constexpr double kShorter = 0.25, kLeastShare = 0.1, kMostShare = 0.8;  // of a step that came no nearer: a secant's, kept inside
constexpr double kStepVoxels = 1.0, kLeastStepMm = 1e-3;  // longest and shortest step
constexpr double kSideReachVoxels = 0.6;   // a side that leaves a place so deep under it owns nothing near it
constexpr double kFarVoxels = 5.0;         // a feature lies no further from its place
constexpr double kLeastCurved = 0.05;      // below, a ridge is bent about the ball's centre
constexpr double kInVoidMm = 1e-3;         // a place deeper in the void is none of what is left
constexpr double kGoneMm = 1e9;            // where no ball reaches
constexpr int kDescentWork = 16;  // units of 25 ns

/// I - n n^T.
glm::dmat3 across(Vec3 n) noexcept { return glm::dmat3(1.0) - glm::outerProduct(n, n); }

/// In the place of a feature that is none: the others keep their numbers until keep() leaves it out.
CavityConstraint gone() noexcept {
  CavityConstraint out;
  out.foot = Vec3(kGoneMm);
  return out;
}

}  // namespace

void CavityWalls::add_run(SweepRun run, Descent& d) const noexcept {
  int k = 0;
  while (k < d.runs && (run.from > d.run[k].to || run.to < d.run[k].from)) ++k;
  if (k == Descent::kMostRuns) return;
  if (k == d.runs) d.run[d.runs++] = run;
  d.run[k] = {std::min(d.run[k].from, run.from), std::max(d.run[k].to, run.to)};
}

/// False where the cell is not known.
bool CavityWalls::add_runs(const Volume& volume, Descent& d) noexcept {
  const SweptRuns& runs = void_.runs_at(volume, d.x, cutting_.end);
  if (!runs.known) return false;
  if (runs.cell == d.cell) return true;
  d.cell = runs.cell;
  d.near_base = d.near_base || runs.near_base;
  for (int i = 0; i < runs.count; ++i) add_run(runs.run[i], d);
  return true;
}

/// The surfaces about where it stands.
int CavityWalls::sides_at(const Volume& volume, const Descent& d, Side* out) noexcept {
  const Vec3 x = d.x;
  const double reach = kSideReachVoxels * voxel_mm_;
  int count = sweeps_.deepest_each({d.run, static_cast<std::size_t>(d.runs)}, x, reach, out);
  if (d.near_base) {
    const FieldPoint base = void_.base(volume, x);
    if (base.known) out[count++] = {Sweeps::kNone, Vec3(0.0), base.normal, base.d_mm};
  }
  double deepest = -1e300;
  for (int k = 0; k < count; ++k) deepest = std::max(deepest, out[k].depth_mm);
  const double least = deepest - reach;
  int kept = 0;
  for (int k = 0; k < count; ++k) {
    if (out[k].depth_mm <= least) continue;
    if (kept < k) out[kept] = out[k];
    ++kept;
  }
  return kept;
}

/// The move nearest to the wanted one after which no side's void holds the place.
PlaneSearch CavityWalls::nearest_under(const Side* side, int sides, Vec3 wanted) noexcept {
  Plane plane[Descent::kMostRuns + 1];
  for (int k = 0; k < sides; ++k) plane[k] = {-side[k].inwards, side[k].depth_mm};
  return closest_point(wanted, {plane, static_cast<std::size_t>(sides)}, 1e-9);
}

/// Moves d.x to about the place nearest to `at` that all sides leave standing: under one side alone, a search at a sharp edge
/// goes to and fro. False if it finds none.
bool CavityWalls::settle(const Volume& volume, Vec3 at, Descent& d) noexcept {
  for (int pass = 0; pass < kSettlePasses; ++pass) {
    work_ += kDescentWork;
    if (!add_runs(volume, d)) return false;
    Side side[Descent::kMostRuns + 1];
    const PlaneSearch found = nearest_under(side, sides_at(volume, d, side), at - d.x);
    if (!found.feasible) return false;
    d.x += found.y;
    if (length_of(found.y) < kPlaceMetMm) return true;
  }
  return false;
}

/// from + further, but no further than to where a side takes over that does not hold the place.
Vec3 CavityWalls::up_to_wall(Vec3 from, Vec3 further, const PlaneSearch& found, const Descent& d) noexcept {
  double share = 1.0;
  Vec3 tangent = further;
  if (found.active == 1) tangent -= d.side[0].inwards * glm::dot(d.side[0].inwards, further);
  for (int k = 0; k < d.sides; ++k) {
    bool holds = false;
    for (int a = 0; a < found.active; ++a) holds = holds || found.index[a] == k;
    const double rate = glm::dot(d.all[k].inwards, tangent);
    if (holds || !(rate > 0.0)) continue;
    const double room = -d.all[k].depth_mm - glm::dot(d.all[k].inwards, from);
    share = std::min(share, std::max(0.0, room) / rate);
  }
  return from + further * share;
}

/// One step towards the place nearest to the ball's centre that all sides leave standing. False if there is none nearby.
bool CavityWalls::step_of_descent(const Ball& ball, Descent& d, Step& step) const noexcept {
  const PlaneSearch found = nearest_under(d.all, d.sides, ball.at - d.x);
  if (!found.feasible || found.active == 0) return false;
  d.active = found.active;
  for (int a = 0; a < found.active; ++a) d.side[a] = d.all[found.index[a]];
  step.whole = step.to_wall = found.y;
  if (found.active == 1 && d.side[0].sweep != Sweeps::kNone) {
    // A tube's nearest place is where the way's nearest place looks past the ball's centre.
    const Sweep sweep = sweeps_[d.side[0].sweep];
    const Vec3 on = sweep.nearest_on(ball.at), off = ball.at - on;
    const double distance = length_of(off);
    if (distance < kNoWayMm) return false;
    if (distance < sweep.radius_mm) {
      step.whole = on + off * (sweep.radius_mm / distance) - d.x;
      step.to_wall = up_to_wall(Vec3(0.0), step.whole, found, d);
    }
    d.side[0].on = on;
  }
  if (found.active != 2) return true;
  d.along = glm::cross(d.side[0].inwards, d.side[1].inwards);
  const double length = length_of(d.along);
  if (length < 1e-4) return false;
  d.along /= length;
  d.curved = 1.0;
  for (int a = 0; a < 2; ++a) {
    if (d.side[a].sweep == Sweeps::kNone) continue;
    const Sweep sweep = sweeps_[d.side[a].sweep];
    const double distance = sweep.radius_mm - d.side[a].depth_mm;
    double turns = 1.0;
    if (d.side[a].on != sweep.a && d.side[a].on != sweep.b) {
      const Vec3 way = sweep.b - sweep.a;
      const double way_along = glm::dot(way, d.along);
      turns -= way_along * way_along / glm::dot(way, way);
    }
    d.curved -= found.weight[a] * turns / distance;
  }
  // Bent about the ball's centre, a ridge is nearest at its end.
  const double along = glm::dot(step.whole, d.along);
  const double to_end = std::copysign(kStepVoxels * voxel_mm_, along);
  const Vec3 across_it = step.whole - d.along * along;
  const Vec3 further = d.along * (d.curved > kLeastCurved ? along / d.curved : to_end);
  step.to_wall = up_to_wall(across_it, further, found, d);
  step.whole = across_it + further;
  return true;
}

/// How much nearer a step comes at most, to second order: other walls only stand further off.
double CavityWalls::most_gain(const Ball& ball, const Descent& d, Vec3 step) const noexcept {
  const Vec3 off = ball.at - d.x;
  const double far = length_of(off);
  if (d.active == 1 && d.side[0].sweep != Sweeps::kNone) {
    const Sweep sweep = sweeps_[d.side[0].sweep];
    const Vec3 on = sweep.nearest_on(d.x + step), out = d.x + step - on;
    const double distance = length_of(out);
    if (distance < kNoWayMm) return far;
    return far - length_of(ball.at - (on + out * (sweep.radius_mm / distance)));
  }
  const double along = d.active == 2 ? glm::dot(step, d.along) : 0.0;
  return (glm::dot(off, step) - 0.5 * d.curved * along * along) / far;
}

/// Moves along the line to the ball's centre until what is left begins. False where no side faces it.
bool CavityWalls::to_surface(const Volume& volume, const Ball& ball, Descent& d) noexcept {
  constexpr int kMost = 3;
  for (int pass = 0; pass < kMost; ++pass) {
    work_ += kDescentWork;
    if (!add_runs(volume, d)) return false;
    d.sides = sides_at(volume, d, d.all);
    Vec3 to = ball.at - d.x;
    to /= length_of(to);
    double least = 1e300;
    for (int k = 0; k < d.sides; ++k) {
      const double facing = glm::dot(to, d.all[k].inwards);
      if (facing > kLeastFacing) least = std::min(least, -d.all[k].depth_mm / facing);
    }
    if (least > voxel_mm_) return false;
    d.x += to * least;
    for (int k = 0; k < d.sides; ++k) d.all[k].depth_mm += least * glm::dot(to, d.all[k].inwards);
    if (std::fabs(least) < kPlaceMetMm) break;
  }
  for (int k = 0; k < d.sides; ++k) d.in_void = d.in_void || d.all[k].depth_mm > kInVoidMm;
  return !d.in_void;
}

/// How deep x lies in a side; what is not among those known is far off.
double CavityWalls::depth_of(std::int32_t sweep, Vec3 x, const Side* known, int count) const noexcept {
  if (sweep != Sweeps::kNone) return sweeps_.deepest({sweep, sweep}, x).depth_mm;
  for (int k = 0; k < count; ++k)
    if (known[k].sweep == sweep) return known[k].depth_mm;
  return -kGoneMm;
}

/// Goes a step and back onto what is left. Where it comes no nearer, another side has taken over on its way.
CavityWalls::Tried CavityWalls::try_step(const Volume& volume, const Ball& ball, Vec3 step, Descent& d) noexcept {
  const Vec3 from = d.x;
  const int count = d.sides;
  Side about[Descent::kMostRuns + 1];
  std::copy_n(d.all, count, about);
  d.x += step;
  Tried out{-kGoneMm, kShorter};
  if (to_surface(volume, ball, d)) {
    out.gain_mm = length_of(from - ball.at) - length_of(d.x - ball.at);
    if (out.gain_mm >= kGainMm) return out;
    const Side& other = *std::max_element(d.all, d.all + d.sides, [](const Side& a, const Side& b) { return a.depth_mm < b.depth_mm; });
    bool held = false;
    double over = kGoneMm;
    for (int a = 0; a < d.active; ++a) {
      held = held || d.side[a].sweep == other.sweep;
      over = std::min(over, other.depth_mm - depth_of(d.side[a].sweep, d.x, d.all, d.sides));
    }
    const double room = -depth_of(other.sweep, from, about, count);
    if (!held && room > 0.0 && over > 0.0 && room < kGoneMm) out.share = std::clamp(room / (room + over), kLeastShare, kMostShare);
  }
  d.x = from;
  d.in_void = false;
  std::copy_n(about, count, d.all);
  d.sides = count;
  return out;
}

void CavityWalls::descend(const Volume& volume, const Ball& ball, int steps, Descent& d) noexcept {
  const Vec3 start = d.x;
  if (cutting_.any()) add_run(cutting_.uncarved, d);
  if (!to_surface(volume, ball, d)) return;
  d.arrived = d.ended = true;
  double trust = kStepVoxels * voxel_mm_;
  for (int pass = 0; pass < steps; ++pass) {
    Step found;
    if (!step_of_descent(ball, d, found)) return;
    d.at_rest = length_of(found.whole) < kDescendedMm;
    if (d.at_rest) return;
    Vec3 step = length_of(found.to_wall) < kBlockedMm ? found.whole : found.to_wall;
    const double length = length_of(step);
    if (length > trust) step *= trust / length;
    if (most_gain(ball, d, step) < kGainMm) return;
    const Tried tried = try_step(volume, ball, step, d);
    if (tried.gain_mm >= kGainMm) {
      trust = std::min(kStepVoxels * voxel_mm_, kTrustGrows * trust);
    } else {
      trust = tried.share * std::min(length, trust);
      if (tried.gain_mm >= 0.0 || trust < kLeastStepMm) return;
    }
    const Vec3 off = d.x - start;
    if (glm::dot(off, off) > kFarVoxels * kFarVoxels * voxel_mm_ * voxel_mm_) return;
  }
  d.ended = steps == kMostSteps;
}

CavityConstraint CavityWalls::constraint_of(const Ball& ball, const Descent& d) const noexcept {
  const Vec3 off = ball.at - d.x;
  const double distance = length_of(off);
  const Vec3 n = off / distance;
  CavityConstraint out{n, glm::dot(n, d.x) + ball.radius_mm, across(n) * (-1.0 / distance), d.x, ball.at, true};
  if (d.active == 1 && d.at_rest && d.side[0].sweep != Sweeps::kNone) {
    const Sweep sweep = sweeps_[d.side[0].sweep];
    const Vec3 on = d.side[0].on;
    const double from_way = length_of(ball.at - on);
    out.bend = across(n);
    if (on != sweep.a && on != sweep.b) {
      Vec3 along = sweep.b - sweep.a;
      along -= n * glm::dot(n, along);
      const double length = length_of(along);
      if (length > kNoWayMm) out.bend -= glm::outerProduct(along / length, along / length);
    }
    out.bend /= from_way;
  } else if (d.active == 1) {
    out.bend = glm::dmat3(0.0);
  } else if (d.active == 2 && d.curved > 0.1) {
    Vec3 along = d.along - n * glm::dot(n, d.along);
    const double length = length_of(along);
    if (length > kNoWayMm) out.bend += glm::outerProduct(along / length, along / length) * (1.0 / (distance * std::min(1.0, d.curved)));
  }
  return out;
}

double CavityWalls::refine(const Volume& volume, const Ball& ball, std::size_t constraint, Jump jump, int steps) noexcept {
  const CavityConstraint from = constraints_[constraint];
  if (from.seen && (from.ended || steps < kMostSteps)) {
    const Vec3 moved = ball.at - from.seen_from;
    if (glm::dot(moved, moved) < kSeenMm * kSeenMm) return glm::dot(from.n, ball.at) - from.c;
  }
  Descent d;
  d.x = from.foot;
  descend(volume, ball, steps, d);
  const double far = length_of(ball.at - d.x);
  if (!d.arrived && d.in_void) {
    if (from.sampled) places_[static_cast<std::size_t>(from.from)].dropped = true;
    else features_[static_cast<std::size_t>(from.from)] = gone();
  }
  if (!d.arrived || far < kNoWayMm) return 0.0;
  CavityConstraint made = constraint_of(ball, d);
  made.ended = d.ended;
  const bool apart = from.sampled || (jump == Jump::keeps_both && length_of(made.foot - from.foot) > kJumpMm);
  if (apart && !from.sampled) features_[static_cast<std::size_t>(from.from)].seen = false;
  std::size_t at = apart ? feature_count_ : static_cast<std::size_t>(from.from);
  for (std::size_t i = 0; i < feature_count_; ++i) {
    const Vec3 off = features_[i].foot - made.foot;
    if (glm::dot(off, off) < kSameMm * kSameMm) at = i;
  }
  if (at == kMostFeatures) return 0.0;
  features_[at] = made;
  if (at == feature_count_) ++feature_count_;
  const double slack = glm::dot(made.n, ball.at) - made.c;
  if (from.sampled && glm::dot(from.n, ball.at) - from.c < slack - kFalseMm) places_[static_cast<std::size_t>(from.from)].dropped = true;
  return slack;
}

}  // namespace cusp::engine
