// The search of a ball in what balls have cut: each pass builds constraints at the pose, and takes a step of Newton's whose
// metric holds the constraints' curvature. The specimen's own surface and the shank enter as planes.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

constexpr double kLeastTrustMm = 0.004, kMostTrustMm = 0.12;  // longest step of a pass
constexpr double kTrustMoved = 1.2, kTrustMovedMm = 0.002;    // the first one: of the way that the device has gone
constexpr double kTrustGrows = 2.0, kTrustFalls = 0.5;  // of the last step, if it was as long as may be, and if not
constexpr double kLeastRoomMm = 0.012;   // with less room the surface is looked for anew
constexpr double kBeyondTrustMm = 0.003;  // constraints are built this far beyond it
constexpr double kNearlyMm = 5e-4;        // a search that moves by less, or turns back, descends to the end of each feature
constexpr int kFewSteps = 3;              // else so far: two make more passes and take as long (milling)
constexpr double kSettledMm = 2e-4;       // a step that is shorter ends the search: Newton's next would be 1 nm
constexpr double kMarginMm = 0.1;  // of the specimen's own features: few are near, and a wide look costs more than many
constexpr double kMarginCuttingMm = 0.04;  // the same while it cuts: a carving soon discards what was found
constexpr double kKeptMm = 0.03;  // features within this of a pose are where the next tick looks first
constexpr double kEntersMm = 1e-5;  // less far into a feature, the pose holds: the next tick would move on by as much
constexpr double kKeptPlaneMm = 0.01;  // a plane of a pass holds this far about it: a point's, of a ball of 0.25 mm, within 0.2 um
constexpr double kLeastMetric = 0.05;     // below, there is no minimum nearby: a plain step goes on
constexpr int kMostTurns = 4;  // a search that still goes to and fro then, by less than the least trust, ends where it is
constexpr int kPasses = 20, kPassesCutting = 14;  // a tick that cuts solves twice, and makes cells anew

bool apart(const glm::dmat3& a, const glm::dmat3& b) noexcept {
  constexpr double kApart = 0.05;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      if (std::fabs(a[i][j] - b[i][j]) > kApart) return true;
  return false;
}

}  // namespace

/// Cholesky of the metric, so that planes and the nearest point are plain again.
struct SurfaceContact::Metric {
  double l00 = 1.0, l10 = 0.0, l11 = 1.0, l20 = 0.0, l21 = 0.0, l22 = 1.0;

  /// False, and the identity, unless it is positive enough.
  bool set(const glm::dmat3& h) noexcept {
    *this = Metric{};
    const double a = h[0][0];
    if (a < kLeastMetric) return false;
    const double b = h[0][1] / a, c = h[0][2] / a;
    const double d = h[1][1] - b * h[0][1], e = h[1][2] - b * h[0][2];
    if (d < kLeastMetric) return false;
    const double f = h[2][2] - c * h[0][2] - e * e / d;
    if (f < kLeastMetric) return false;
    l00 = std::sqrt(a);
    l10 = h[0][1] / l00;
    l20 = h[0][2] / l00;
    l11 = std::sqrt(d);
    l21 = e / l11;
    l22 = std::sqrt(f);
    return true;
  }
  /// L^-1 v, L^-T v and L^T v.
  Vec3 lower_solve(Vec3 v) const noexcept {
    const double x = v.x / l00, y = (v.y - l10 * x) / l11;
    return {x, y, (v.z - l20 * x - l21 * y) / l22};
  }
  Vec3 upper_solve(Vec3 v) const noexcept {
    const double z = v.z / l22, y = (v.y - l21 * z) / l11;
    return {(v.x - l10 * y - l20 * z) / l00, y, z};
  }
};

/// Minus the second derivative of the distance to what a plane stands for, where it is an edge's or a point's.
glm::dmat3 SurfaceContact::bend_of(const Origin& origin, Vec3 at) const noexcept {
  if (origin.candidate < 0) return walls_.constraints()[static_cast<std::size_t>(-1 - origin.candidate)].bend;
  const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
  if (origin.kept >= 0 || origin.trusted_plane || c.kind == Kind::shank) return glm::dmat3(0.0);
  Vec3 off = at - c.point, along(0.0);
  double curved = 0.0;
  if (c.kind == Kind::edge && !nearest_on(c, 1e3, off, along, curved)) curved = 0.0;
  const double distance = length_of(off);
  if (distance < 1e-6) return glm::dmat3(0.0);
  const Vec3 n = off / distance;
  glm::dmat3 out = (glm::outerProduct(n, n) - glm::dmat3(1.0)) / distance;
  if (curved > 0.1) {
    along -= n * glm::dot(n, along);
    const double length = length_of(along);
    if (length > 1e-9) out += glm::outerProduct(along / length, along / length) * (1.0 / (distance * std::min(1.0, curved)));
  }
  return out;
}

glm::dmat3 SurfaceContact::bend_of(const PlaneSearch& found, Vec3 at) const noexcept {
  glm::dmat3 out(0.0);
  for (int a = 0; a < found.active; ++a) out += bend_of(origins_[static_cast<std::size_t>(found.index[a])], at) * found.weight[a];
  return out;
}

/// Adds the constraints of a ball in what balls have cut. An origin below 0 is one of walls_.
void SurfaceContact::add_cavity(const Volume& volume, const Tool& tool, Vec3 at, double slack_mm) noexcept {
  walls_.build(volume, {at, tool.bur->radius_mm - tool.thin_cut, slack_mm});
  candidates_left_ -= walls_.take_work();
  std::int32_t i = -1;
  for (const CavityConstraint& c : walls_.constraints()) {
    if (planes_.size() == candidates_.size()) {
      overflow_ = true;
      return;
    }
    origins_[planes_.size()] = {i--, false, false};
    planes_.add(c.n, c.c);
  }
}

/// Keeps the planes of surface and shank that hold the bur at `at`.
void SurfaceContact::keep_planes(const PlaneSearch& found, Vec3 at) noexcept {
  for (int a = 0; a < found.active; ++a) {
    const auto i = static_cast<std::size_t>(found.index[a]);
    const Origin& origin = origins_[i];
    if (origin.candidate < 0 || origin.kept >= 0) continue;
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    kept_planes_.add({{planes_.n(i), planes_.c(i)}, at, c.tissue, c.kind == Kind::shank});
  }
}

/// Adds the planes that were kept within_mm of `at`.
void SurfaceContact::add_kept(Vec3 at, double within_mm) noexcept {
  for (int k = 0; k < kept_planes_.count(); ++k) {
    const KeptPlane& kept = kept_planes_[k];
    const Vec3 off = at - kept.seen_from;
    if (glm::dot(off, off) > within_mm * within_mm) continue;
    if (planes_.size() == candidates_.size()) {
      overflow_ = true;
      return;
    }
    origins_[planes_.size()] = {0, true, false, static_cast<std::int8_t>(k)};
    planes_.add(kept.plane.n, kept.plane.c);
  }
}

/// All constraints within slack_mm of a ball at `at`: planes_ and origins_.
void SurfaceContact::constrain_in_cavity(const Volume& volume, const Tool& tool, Vec3 at, double slack_mm) noexcept {
  gather(volume, tool, at, slack_mm, walls_.cutting().any() ? kMarginCuttingMm : kMarginMm);
  build_constraints(volume, tool, at, slack_mm, at, slack_mm);
  const std::size_t own = planes_.size();
  add_cavity(volume, tool, at, slack_mm);
  past_count_ = static_cast<int>(walls_.past().size());
  std::copy(walls_.past().begin(), walls_.past().end(), past_.begin());
  relax_by_past(0, own);
  add_kept(at, kKeptPlaneMm);
}

/// The point nearest to z in the metric that meets planes_. Weights are those of the planes as they stand.
PlaneSearch SurfaceContact::nearest_in_metric(const Metric& metric, Vec3 y, Vec3 z, bool& infeasible) noexcept {
  scaled_.clear();
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    // Seen from y, so that rounding does not grow with the frame.
    const Vec3 n = metric.lower_solve(planes_.n(i));
    const double size = length_of(n);
    scale_[i] = 1.0 / size;
    scaled_.add(n / size, -planes_.slack(i, y) / size);
  }
  const Vec3 way = z - y;
  const Vec3 target(metric.l00 * way.x + metric.l10 * way.y + metric.l20 * way.z, metric.l11 * way.y + metric.l21 * way.z,
                    metric.l22 * way.z);
  PlaneSearch found = closest_point(target, scaled_, kTolerance, {active_set_.plane, 0});
  infeasible = !found.feasible;
  if (!found.feasible) {
    // Tangents contradict each other: those that y violates are relaxed to y.
    for (std::size_t i = 0; i < scaled_.size(); ++i)
      if (scaled_.c(i) > 0.0) scaled_.set_c(i, 0.0);
    found = closest_point(target, scaled_, kTolerance, {});
  }
  found.y = y + metric.upper_solve(found.y);
  for (int a = 0; a < found.active; ++a) found.weight[a] *= scale_[static_cast<std::size_t>(found.index[a])];
  return found;
}

/// True if a ball at `from` comes near what balls have cut within a step.
bool SurfaceContact::near_cavity(const Volume& volume, const Tool& tool, Vec3 from, double step) noexcept {
  const bool near = walls_.near(volume, {from, tool.bur->radius_mm - tool.thin_cut, step + kNearCavityMm});
  candidates_left_ -= walls_.take_work();
  return near;
}

/// Goes from the places that hold the ball to the features that they are of. True if the ball at `at` enters one.
bool SurfaceContact::refine_in_cavity(const Volume& volume, const Tool& tool, Vec3 at, const PlaneSearch& found,
                                      CavityWalls::Jump jump, int steps) noexcept {
  bool enters = false;
  for (int a = 0; a < found.active; ++a) {
    const std::int32_t candidate = origins_[static_cast<std::size_t>(found.index[a])].candidate;
    if (candidate >= 0) continue;
    const auto i = static_cast<std::size_t>(-1 - candidate);
    const double slack = walls_.refine(volume, {at, tool.bur->radius_mm - tool.thin_cut, 0.0}, i, jump, steps);
    enters = enters || slack < -kEntersMm;
  }
  candidates_left_ -= walls_.take_work();
  return enters;
}

Contact SurfaceContact::solve_in_cavity(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, double moved_mm) noexcept {
  Contact out;
  overflow_ = false;
  Vec3 y = from, last_way(0.0);
  double trust = std::clamp(kTrustMoved * moved_mm + kTrustMovedMm, kLeastTrustMm, kMostTrustMm);
  Metric metric;
  glm::dmat3 bend(0.0);
  bool arrived = false;
  int turns = 0;  // back, of the search
  kept_planes_.clear();
  const int passes = walls_.cutting().any() ? kPassesCutting : kPasses;
  for (int pass = 0; pass < passes && !arrived && (pass == 0 || candidates_left_ > 0); ++pass) {
    candidates_left_ -= kCandidatesOfPass;
    const double room = walls_.room_mm({y, tool.bur->radius_mm - tool.thin_cut, 0.0}) - kBeyondTrustMm;
    if (room > kLeastRoomMm) trust = std::min(trust, room);
    constrain_in_cavity(volume, tool, y, trust + kBeyondTrustMm);
    if (planes_.size() == 0 && inside_tissue(volume, y)) {
      out.infeasible = true;
      break;
    }
    if (!metric.set(glm::dmat3(1.0) + bend)) bend = glm::dmat3(0.0);
    const Vec3 z = y + metric.upper_solve(metric.lower_solve(device - y));
    PlaneSearch found = nearest_in_metric(metric, y, z, out.infeasible);
    const glm::dmat3 used = bend;
    bend = bend_of(found, y);
    // Where other constraints hold the ball than in the last pass, their own curvature counts.
    if (found.feasible && apart(bend, used) && metric.set(glm::dmat3(1.0) + bend)) {
      found = nearest_in_metric(metric, y, y + metric.upper_solve(metric.lower_solve(device - y)), out.infeasible);
      bend = bend_of(found, y);
    }
    if (!found.feasible) break;
    note(volume, found, Polished{}, out);
    const Vec3 way = found.y - y;
    const double far = length_of(way);
    // A search that turns back goes to and fro between two places of a feature: both count from now on.
    if (pass > 1 && glm::dot(way, last_way) < 0.0) ++turns;
    if (turns > 0) keep_planes(found, y);
    last_way = way;
    y = far > trust ? y + way * (trust / far) : found.y;
    const int steps = turns > 0 || std::min(far, trust) < kNearlyMm ? CavityWalls::kMostSteps : kFewSteps;
    const auto jump = turns > 0 ? CavityWalls::Jump::keeps_both : CavityWalls::Jump::replaces;
    arrived = !refine_in_cavity(volume, tool, y, found, jump, steps) && std::min(far, trust) < kSettledMm;
    // The answer lies between two such poses.
    arrived = arrived || (turns >= kMostTurns && std::min(far, trust) <= kLeastTrustMm);
    const double grows = turns >= kMostTurns ? kTrustFalls : turns > 0 ? 1.0 : kTrustGrows;
    trust = std::clamp(far >= trust ? grows * trust : kTrustFalls * far, kLeastTrustMm, kMostTrustMm);
  }
  out.pose_mm = y;
  out.in_steps = true;
  out.deferred = !arrived && !out.infeasible;
  out.overflow = overflow_;
  walls_.keep({y, tool.bur->radius_mm - tool.thin_cut, kKeptMm});
  return out;
}

}  // namespace cusp::engine
