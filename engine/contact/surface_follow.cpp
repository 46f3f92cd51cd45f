// The search by planes: searches of a step each, made of passes that build constraints, solve them and polish the answer.
#include <algorithm>

#include "engine/contact/surface_contact.h"

namespace cusp::engine {

namespace {

constexpr int kSearches = 64;               // searches of a solve (5 mm); more are deferred
constexpr double kPredicted = 0.05;         // of a step: constraints are first built for this distance about the predicted pose
constexpr double kPredictedMm = 0.005;       // mm: and this much more
constexpr double kFurther = 1.5;            // of the pass's move: constraints are rebuilt for this distance if it leaves the first
constexpr double kAsked = 0.3;              // of the last pass's move: how far the next may go
constexpr double kAskedMm = 0.002;          // mm: and this much more
constexpr double kNearStep = 0.5;            // of a step: as far as constraints may be built beyond those that are complete
constexpr double kLongerStep = 4.0;         // of a head's step, once it is left: a pear's p99.9 on an edge falls to 0.6
constexpr double kAgainMm = 0.03;           // mm: constraints of a later pass are built for this distance, for those that follow
constexpr double kArrivedMm = 2e-5;         // mm: a pose that would move less in another pass has converged
constexpr double kRollsMm = 1e-7;           // mm: the same while it rolls over an edge
constexpr int kPasses = 10;                 // of a search
constexpr double kKeptPlaneMm = 0.2;        // planes of earlier passes hold this far about them, once a head's search turns back
constexpr double kLeastTrustMm = 0.004;     // shortest step of one that turns back: it ends there

}  // namespace

struct SurfaceContact::PlaneSolve {
  Vec3 device{0.0};
  Vec3 y{0.0};             // the pose so far
  Vec3 predicted{0.0};     // way that the proxy is expected to go
  double step = 0.0;       // length of a search
  bool with_foot = false;  // the point under the push is a candidate
  bool arrived = false;
  bool moved = false;      // a pass has moved the pose: what comes next may wait for the next tick
  Contact out;

  // Of the present search.
  Vec3 centre{0.0};         // where it began
  Vec3 at{0.0};             // where constraints are built: first at the predicted pose, then at the present one
  std::size_t at_hand = 0;  // candidates without those of the foot
  double before = 0.0, last_moved = 1.0;  // by the last two passes
  double limit = 0.0;       // constraints are built for this distance about `at` ...
  double within = 0.0;      // ... and complete for this one
  double asked = 0.0;       // they must be complete for this one, after the last pass's move
  bool uses_prediction = false;
  bool left = false;        // the step ends before the search does
  bool rolling = false;
  double next_step = 0.0;
  Vec3 way{0.0};            // of the last pass
  double trust = 1e9;       // longest way of a pass, mm
  int turns = 0;            // back
  /// A head's last pass: its active planes' candidates, or -1 - kept plane, where it led, and how far that was from where they were built.
  struct Creep {
    int planes = 0;
    std::int32_t candidate[2] = {0, 0};
    Vec3 to{0.0}, by{0.0};
  };
  Creep creep;
};

/// Constraints are next built at the present pose.
void SurfaceContact::build_anew(PlaneSolve& s) noexcept {
  s.at = s.y;
  s.limit = std::min(2.0 * s.step, kAgainMm);
  s.last_moved = 1.0;
  built_.within_mm = -1.0;
}

void SurfaceContact::begin_search(const Volume& volume, const Tool& tool, PlaneSolve& s) noexcept {
  s.centre = s.at = s.y;
  gather(volume, tool, s.y, s.step);
  s.at_hand = count_;
  active_set_.count = 0;
  s.before = s.asked = 0.0;
  s.last_moved = 1.0;
  s.limit = s.within = kPredicted * s.step + kPredictedMm;
  built_.within_mm = -1.0;
  const double predicted_mm = length_of(s.predicted);
  s.uses_prediction = predicted_mm > 2.0 * kTangentsHoldMm;
  if (s.uses_prediction) s.at += predicted_mm > s.step ? s.predicted * (s.step / predicted_mm) : s.predicted;
  s.left = s.rolling = false;
  s.next_step = kLongestStep;
  s.creep.planes = 0;
}

/// What the passes to come would add to y, by the last two under the same planes (Anderson 1965, one step back). rolls: their
/// moves grow. A head's planes have no curvature at hand. None while it cuts: leaps there raise the most counted work by a fifth.
Vec3 SurfaceContact::leap_of_head(const PlaneSearch& found, Vec3 y, PlaneSolve& s, bool& rolls) const noexcept {
  const PlaneSolve::Creep before = s.creep;
  s.creep.planes = cut_.resolves() && found.active <= 2 ? found.active : 0;
  s.creep.to = y;
  s.creep.by = y - s.at;
  bool same = s.creep.planes > 0 && s.creep.planes == before.planes;
  for (int a = 0; a < s.creep.planes; ++a) {
    const Origin& origin = origins_[static_cast<std::size_t>(found.index[a])];
    s.creep.candidate[a] = origin.kept >= 0 ? -1 - origin.kept : origin.candidate;
    same = same && s.creep.candidate[a] == before.candidate[a];
  }
  const Vec3 by = s.creep.by, change = by - before.by;
  const double size = length_of(by), square = glm::dot(change, change);
  if (!same || square < kRollsMm * kRollsMm || size > kFarthestLeapMm || glm::dot(by, before.by) <= 0.0) return Vec3(0.0);
  const double most = std::min(kLongestLeap * size, kFarthestLeapMm), share = -glm::dot(by, change) / square;
  rolls = share <= 0.0;
  const Vec3 leap = rolls ? by * kLongestLeap : (y - before.to) * share;
  const double length = length_of(leap);
  return length > most ? leap * (most / length) : leap;
}

/// The leap from y, no further than the step: constraints built beyond it would only lead back.
Vec3 SurfaceContact::leap_within(const Tool& tool, const PlaneSearch& found, Vec3 y, PlaneSolve& s, bool& rolls) const noexcept {
  const Vec3 leap = tool.ball() ? leap_of_ball(found, s.at, y - s.at, rolls) : leap_of_head(found, y, s, rolls);
  const double leaps = length_of(leap), room = std::max(0.0, s.step - length_of(found.y - s.centre));
  return leaps > room ? leap * (room / leaps) : leap;
}

/// planes_ for a pass.
void SurfaceContact::constrain_pass(const Volume& volume, const Tool& tool, PlaneSolve& s, int pass) noexcept {
  if (!(s.last_moved > kTangentsHoldMm)) {
    // It has nearly converged: only the active tangents turn with it.
    for (int a = 0; a < active_set_.count; ++a) turn(tool, s.at, static_cast<std::size_t>(active_set_.plane[a]));
    return;
  }
  active_set_.count = 0;
  s.within = s.asked;
  if (!rebuild_constraints(tool, s.at, s.asked)) {
    // Later passes reuse a wider build.
    if (pass > 0) s.limit = std::max(s.limit, std::min(kAgainMm, 2.0 * s.step));
    s.within = s.limit;
    build_constraints(volume, tool, s.centre, s.step, s.at, s.limit);
  }
  // Cut surfaces and edges may hug the bur: then the point under the push becomes a candidate from the start.
  s.with_foot = s.with_foot || near_cut_;
  if (s.with_foot) {
    foot(volume, tool, s.at, s.device);
    planes(tool, s.at, s.at_hand, count_, s.within);
    count_ = s.at_hand;
  }
  if (s.turns > 0) add_kept(s.at, kKeptPlaneMm);
  find_past(tool, s.at);
  relax_by_past(0, planes_.size());
}

/// Constraints are next built for more: where the pose goes, unless that is far; else from where they are, in the end for the
/// whole step. off: how far the pose that was found is from there, mm.
void SurfaceContact::build_further(const Tool& tool, const PlaneSearch& found, double off, int pass, PlaneSolve& s) noexcept {
  const double further = std::min(2.0 * s.step, kFurther * off + kPredictedMm);
  s.last_moved = 1.0;
  if (pass > 0 && !s.uses_prediction && off < kNearStep * s.step) {
    bool rolls = false;
    s.at = tool.ball() ? found.y : found.y + leap_within(tool, found, found.y, s, rolls);
    s.asked = kAsked * off + kAskedMm;
    s.limit = std::max(s.limit, s.asked);
  } else if (s.within < s.limit) {
    s.asked = std::min(s.limit, further);
  } else {
    s.limit = further;
    built_.within_mm = -1.0;
  }
}

/// True if an edge stands deeper in the bur than constraints are good for.
bool SurfaceContact::deep_in_edge(Vec3 at) const noexcept {
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (origins_[i].kept < 0 && candidates_[static_cast<std::size_t>(origins_[i].candidate)].kind == Kind::edge &&
        planes_.slack(i, at) < -kPredictedMm)
      return true;
  return false;
}

/// Where a head's search goes to and fro between places whose planes lead to each other, its ways are halved at each turn, and
/// the planes of both hold it. True if they do, or if the way to `found` was shortened.
bool SurfaceContact::turn_back(PlaneSearch& found, PlaneSolve& s) noexcept {
  const Vec3 way = found.y - s.y;
  const double far = length_of(way);
  if (far > kLeastTrustMm && glm::dot(way, s.way) < 0.0) {
    ++s.turns;
    s.trust = std::max(kLeastTrustMm, 0.5 * std::min(s.trust, length_of(s.way)));
  }
  bool held = far > s.trust;
  if (held) found.y = s.y + way * (s.trust / far);
  s.way = found.y - s.y;
  for (int a = 0; a < found.active; ++a) held = held || origins_[static_cast<std::size_t>(found.index[a])].kept >= 0;
  return held;
}

/// One pass. True if the search goes on.
bool SurfaceContact::make_pass(const Volume& volume, const Tool& tool, PlaneSolve& s, int pass) noexcept {
  candidates_left_ -= kCandidatesOfPass;
  ++passes_;
  constrain_pass(volume, tool, s, pass);
  if (s.uses_prediction && !tool.ball() && deep_in_edge(s.at)) {
    // There a head is nearer to another of its sides than the one that it came with.
    s.uses_prediction = false;
    build_anew(s);
    return true;
  }
  bool infeasible = false;
  PlaneSearch found = search_planes(s.y, s.device, infeasible);
  if (infeasible && s.uses_prediction) {
    // Constraints built at a predicted pose may contradict each other: they are built again at the present one.
    s.uses_prediction = false;
    build_anew(s);
    return true;
  }
  s.out.infeasible = s.out.infeasible || infeasible;
  // Deep in tissue there is no surface to follow.
  const bool buried = found.feasible && planes_.size() == 0 && inside_tissue(volume, s.y);
  s.out.infeasible = s.out.infeasible || buried;
  s.arrived = !found.feasible || buried;
  if (s.arrived) return false;
  const double off = length_of(found.y - s.at);
  if (off > s.within && s.within < 2.0 * s.step) {
    // Further than the constraints are complete for.
    build_further(tool, found, off, pass, s);
    return true;
  }
  const bool held = !tool.ball() && turn_back(found, s);
  const double whole = length_of(found.y - s.centre);
  s.left = whole > s.step;
  Polished polished;
  if (!s.left && !held && found.active > 0) polished = polish(volume, tool, s.y, s.device, found);
  if (found.active > 0 && !held && !polished.accepted && !s.with_foot) {
    // No smooth foot for each constraint: from here on the point under the push is a candidate too.
    s.with_foot = true;
    s.left = false;
    build_anew(s);
    return true;
  }
  go_to(found, polished, whole, s);
  note(volume, found, polished, s.out);
  if (!tool.ball()) keep_planes(found, s.at);
  // The answer lies between two such poses.
  s.arrived = s.turns > 1 && s.trust <= kLeastTrustMm;
  return !s.arrived && !s.left && !settled(tool, found, polished, s);
}

/// Moves the pose to what was found, at most by the step. whole: how far that is from where the search began, mm.
void SurfaceContact::go_to(const PlaneSearch& found, const Polished& polished, double whole, PlaneSolve& s) const noexcept {
  s.y = found.y;
  s.moved = true;
  if (s.left) {
    const double longer = s.creep.planes > 0 ? kLongerStep * s.step : 0.0;
    s.next_step = std::min(kLongestStep, std::max(longer, 1.2 * (whole - s.step) + 0.01));
    s.predicted = (found.y - s.centre) * (1.0 - s.step / whole);  // where the next one goes on
    s.y -= s.predicted;
  }
  if (polished.accepted) s.y = polished.search.y;
}

/// True if the pose has converged. Else sets where the next pass builds its constraints.
bool SurfaceContact::settled(const Tool& tool, const PlaneSearch& found, const Polished& polished, PlaneSolve& s) const noexcept {
  s.uses_prediction = false;
  const Vec3 off_by = s.y - s.at;
  const double moved = length_of(off_by);
  // If it creeps, as over an edge that it rolls on, the next constraints are built where the creeping leads. The answer
  // still comes from the constraints.
  bool rolls = false;
  const Vec3 leap = polished.accepted ? Vec3(0.0) : leap_within(tool, found, s.y, s, rolls);
  // Passes shrink the error like moved / before; a tangent built `moved` away is off by moved^2 / 2r.
  s.arrived = (polished.accepted && moved < 0.06) || moved < (rolls ? kRollsMm : kArrivedMm) ||
              (!rolls && moved * moved < kArrivedMm * s.before);
  if (s.arrived) return true;
  s.at = s.y + leap;
  s.rolling = rolls;
  s.before = moved;
  s.last_moved = length_of(off_by + leap);
  s.asked = kAsked * s.last_moved + kAskedMm;
  s.next_step = std::min(kLongestStep, 4.0 * s.last_moved + 0.02);
  return false;
}

Contact SurfaceContact::solve_by_planes(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, Vec3 predicted, double step,
                                        double most_mm) noexcept {
  PlaneSolve s;
  kept_planes_.clear();
  s.device = device;
  s.y = from;
  s.predicted = predicted;
  s.step = step;
  for (int search = 0; search < kSearches && !s.arrived && (search == 0 || !spent()); ++search) {
    begin_search(volume, tool, s);
    bool goes_on = true;
    for (int pass = 0; pass < kPasses && goes_on && !(s.moved && spent()); ++pass) goes_on = make_pass(volume, tool, s, pass);
    if (goes_on && spent()) break;
    // A pose that still moves after the last pass continues in the next search, else it stops up to 0.1 mm short. Near a cut
    // only a rolling one continues: others alternate between walls of the bur's own hole.
    if (!s.left && !((s.rolling || !near_cut_) && s.last_moved > kTangentsHoldMm)) s.arrived = true;
    if (!s.left) s.predicted = Vec3(0.0);
    if (length_of(s.y - from) > most_mm) break;
    s.step = s.next_step;
  }
  s.out.pose_mm = s.y;
  s.out.deferred = !s.arrived;
  s.out.overflow = overflow_;
  return s.out;
}

}  // namespace cusp::engine
