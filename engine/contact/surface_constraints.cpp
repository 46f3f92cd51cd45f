// Builds the constraints that a step may touch: of all candidates, two at a time; then again of those that were near.
#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

constexpr double kNoWay2 = 1e-18;    // mm^2: a place nearer to a point or an edge has no direction from it
constexpr double kRounding = 1e-9;   // mm: far more than a distance to a head is rounded by
constexpr double kMostShift = 0.06;  // mm: near candidates are reused within this of the last full build
constexpr double kLeavesTangent = 0.25;  // voxels that a cell's edge leaves its tangent by at most
constexpr double kEdgeClose = 1e-4;      // voxels: leaves its distance off by 1e-8, the normal by 2e-6 degrees
constexpr double kNormalRounding = 1e-6;  // mm: a single-precision normal is 1e-7 off unit, so a height over a head of 9 mm by 9e-7
constexpr double kEdgeBends = 0.02;      // below, it bends about the place about as the ball does
constexpr int kEdgeNewton = 4;           // steps of Newton along an edge
constexpr double kMostMovedNow = 0.5;    // voxels: a neck's point is moved so far out of what is not carved

}  // namespace

inline void SurfaceContact::add_constraint(std::size_t i, const Constraint& constraint) noexcept {
  const std::size_t k = planes_.size();
  origins_[k] = {static_cast<std::int32_t>(i), constraint.trusted, false};
  near_[k] = static_cast<std::int32_t>(i);
  low_[k] = constraint.low_mm;
  planes_.add(constraint.plane.n, constraint.plane.c);
}

/// Adds the constraint of one candidate, if it is near.
inline void SurfaceContact::constrain(std::size_t i, const Constraint& found) noexcept {
  if (!found.near) return;
  add_constraint(i, found);
  const Candidate& c = candidates_[i];
  near_cut_ = near_cut_ || (c.kind != Kind::shank && (c.field == Field::cut || c.kind == Kind::edge));
}

/// plane_of() of a ball, a neck or a shank, with its bound.
inline SurfaceContact::Constraint SurfaceContact::bounded_plane_of(const Tool& tool, const Candidate& c, Vec3 at, double slack_mm) const noexcept {
  Constraint out = plane_of(tool, c, at, slack_mm);
  if (!out.near) return out;
  out.low_mm = glm::dot(out.plane.n, at) - out.plane.c;
  // A ball may come under a surface's plane a little further on.
  const double height = c.kind == Kind::surface ? glm::dot(c.normal, at) - c.level : 0.0;
  if (height > 0.0) out.low_mm = std::min(out.low_mm, height - (tool.bur->radius_mm - tool.thin(c.field)));
  return out;
}

/// Constraints of broad_faces_, two at a time: as plane_of_surface().
inline void SurfaceContact::add_face_constraints(Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept {
  const double beside = kPlaneReach * voxel_mm_, later = beside + kMostShift;
  const double beside2 = beside * beside, later2 = later * later;
  broad_faces_.even();
  for (std::size_t j = 0; j < broad_faces_.count; j += 2) {
    const Face& a = faces_[broad_faces_[j]];
    const Face& b = faces_[broad_faces_[j + 1]];
    const Pair x{a.x, b.x}, y{a.y, b.y}, z{a.z, b.z};
    const Pair nx{a.nx, b.nx}, ny{a.ny, b.ny}, nz{a.nz, b.nz};
    const Pair level{a.level, b.level}, r{a.radius, b.radius};
    const Pair fx = x - centre.x, fy = y - centre.y, fz = z - centre.z;
    const Pair dx = at.x - x, dy = at.y - y, dz = at.z - z;
    const Pair square = dx * dx + dy * dy + dz * dz;
    const Pair height = nx * at.x + ny * at.y + nz * at.z - level;
    const Pair side2 = square - height * height;
    const Pair distance = sqrt_of(square);
    const PairMask above = height > 0.0;
    const PairMask flat = above & (side2 <= beside2);
    const Pair gap = (flat ? height : distance) - r;
    const PairMask near = (gap <= slack_mm) & (fx * fx + fy * fy + fz * fz <= reach2) & (flat | (square >= kNoWay2));
    const unsigned kept = bits_of(near);
    if (kept == 0) continue;
    const Pair inverse = 1.0 / distance;
    const Pair px = flat ? nx : dx * inverse, py = flat ? ny : dy * inverse, pz = flat ? nz : dz * inverse;
    const Pair c = flat ? level + r : px * at.x + py * at.y + pz * at.z - gap;
    const Pair low = ((above & (side2 <= later2)) ? height : distance) - r;
    const unsigned trusted = bits_of(flat);
    for (std::size_t k = 0; k < 2 && j + k < broad_faces_.count; ++k) {
      if ((kept >> k & 1) == 0) continue;
      const std::size_t i = broad_faces_[j + k];
      add_constraint(i, {{{px[k], py[k], pz[k]}, c[k]}, true, (trusted >> k & 1) != 0, low[k]});
      near_cut_ = near_cut_ || known_[i] == Known::cut_face;
    }
  }
}

/// Two edges as curves about a pose: at - (point + s tangent + s^2 bend + s^3 twist) for s in from..to.
struct SurfaceContact::EdgePair {
  Pair dx, dy, dz;  // from the edges' points to the pose
  Pair tx, ty, tz, bx, by, bz, wx, wy, wz;
  Pair from, to;

  void place(Pair s, Pair& px, Pair& py, Pair& pz) const noexcept {
    px = dx - s * (tx + s * (bx + s * wx));
    py = dy - s * (ty + s * (by + s * wy));
    pz = dz - s * (tz + s * (bz + s * wz));
  }

  /// d: from the edges' points to the pose.
  [[gnu::always_inline]] static EdgePair of(const Candidate& a, const Candidate& b, Pair dx, Pair dy, Pair dz) noexcept {
    const CutFeature &fa = *a.feature, &fb = *b.feature;
    const Vec3f &ba = fa.other_normal, &bb = fb.other_normal, &wa = fa.third_normal, &wb = fb.third_normal;
    const auto two = [](double of_a, double of_b) { return Pair{of_a, of_b}; };
    return {dx, dy, dz, two(a.normal.x, b.normal.x), two(a.normal.y, b.normal.y), two(a.normal.z, b.normal.z),
            two(ba.x, bb.x), two(ba.y, bb.y), two(ba.z, bb.z), two(wa.x, wb.x), two(wa.y, wb.y), two(wa.z, wb.z),
            two(fa.other_d_mm, fb.other_d_mm), two(fa.third_d_mm, fb.third_d_mm)};
  }

  /// By Newton along the edges from t: their nearest places, and the way from there to the pose.
  [[gnu::always_inline]] void nearest(Pair& t, PairMask near, double close, Pair& ox, Pair& oy, Pair& oz) const noexcept {
    PairMask active = near;
    for (int pass = 0; pass <= kEdgeNewton; ++pass) {
      Pair vx, vy, vz;
      place(t, vx, vy, vz);
      ox = active ? vx : ox;
      oy = active ? vy : oy;
      oz = active ? vz : oz;
      if (pass == kEdgeNewton) break;
      const Pair ax = tx + t * (2.0 * bx + t * (3.0 * wx)), ay = ty + t * (2.0 * by + t * (3.0 * wy)), az = tz + t * (2.0 * bz + t * (3.0 * wz));
      const Pair six = 6.0 * t;
      const Pair curved = ax * ax + ay * ay + az * az - ((2.0 * bx + six * wx) * vx + (2.0 * by + six * wy) * vy + (2.0 * bz + six * wz) * vz);
      active = active & (curved > kEdgeBends);
      const Pair whole = t + (ox * ax + oy * ay + oz * az) / curved;
      const Pair next = whole < from ? from : whole > to ? to : whole;
      const Pair moved = next - t;
      active = active & ((moved >= close) | (moved <= -close));
      if (bits_of(active) == 0) break;
      t = active ? next : t;
    }
  }
};

/// The nearest place of an edge's piece. `off`: from the edge's middle to a place; then from that nearest place to it.
/// along, curved: the curve's derivative there, and half the second derivative of the squared distance along it. False at
/// the piece's end, and where all of it is further than far_mm (then along is not computed).
bool SurfaceContact::nearest_on(const Candidate& edge, double far_mm, Vec3& off, Vec3& along, double& curved) const noexcept {
  const CutFeature& f = *edge.feature;
  const Vec3 d = off, tangent = edge.normal;
  const double from = f.other_d_mm, to = f.third_d_mm, reach = far_mm + kLeavesTangent * voxel_mm_;
  double t = glm::dot(d, tangent);
  t = t < from ? from : t > to ? to : t;
  off = d - t * tangent;
  curved = 1e300;
  if (glm::dot(off, off) > reach * reach) return false;
  Pair at = both(t), x = both(off.x), y = both(off.y), z = both(off.z);
  EdgePair::of(edge, edge, both(d.x), both(d.y), both(d.z)).nearest(at, Pair{} == Pair{}, kEdgeClose * voxel_mm_, x, y, z);
  off = {x[0], y[0], z[0]};
  t = at[0];
  const Vec3 bend(f.other_normal), twist(f.third_normal);
  along = tangent + t * (2.0 * bend + t * (3.0 * twist));
  curved = glm::dot(along, along) - glm::dot(2.0 * bend + (6.0 * t) * twist, off);
  return t > from && t < to;
}

/// Constraints of broad_edges_, two at a time: as nearest_on() and plane_of().
inline void SurfaceContact::add_edge_constraints(const Tool& tool, Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept {
  const double close = kEdgeClose * voxel_mm_;
  broad_edges_.even();
  for (std::size_t j = 0; j < broad_edges_.count; j += 2) {
    const Candidate& a = candidates_[broad_edges_[j]];
    const Candidate& b = candidates_[broad_edges_[j + 1]];
    const Pair x{a.point.x, b.point.x}, y{a.point.y, b.point.y}, z{a.point.z, b.point.z};
    const Pair fx = x - centre.x, fy = y - centre.y, fz = z - centre.z;
    const Pair dx = at.x - x, dy = at.y - y, dz = at.z - z;
    const Pair tx{a.normal.x, b.normal.x}, ty{a.normal.y, b.normal.y}, tz{a.normal.z, b.normal.z};
    const Pair from{a.feature->other_d_mm, b.feature->other_d_mm}, to{a.feature->third_d_mm, b.feature->third_d_mm};
    const Pair r{tool.bur->radius_mm - tool.thin(a.field), tool.bur->radius_mm - tool.thin(b.field)};
    const Pair far = r + slack_mm;
    Pair t = dx * tx + dy * ty + dz * tz;
    t = t < from ? from : t > to ? to : t;
    Pair ox = dx - t * tx, oy = dy - t * ty, oz = dz - t * tz;
    const Pair reach = far + kLeavesTangent * voxel_mm_;
    const PairMask near = (ox * ox + oy * oy + oz * oz <= reach * reach) & (fx * fx + fy * fy + fz * fz <= reach2);
    const unsigned asked = bits_of(near) & (j + 1 < broad_edges_.count ? 3u : 1u);
    if (asked == 0) continue;
    EdgePair::of(a, b, dx, dy, dz).nearest(t, near, close, ox, oy, oz);
    const Pair square = ox * ox + oy * oy + oz * oz;
    const Pair distance = sqrt_of(square);
    const Pair gap = distance - r;
    const unsigned kept = bits_of((gap <= slack_mm) & (square >= kNoWay2)) & asked;
    const Pair inverse = 1.0 / distance;
    const Pair nx = ox * inverse, ny = oy * inverse, nz = oz * inverse;
    const Pair c = nx * at.x + ny * at.y + nz * at.z - gap;
    for (std::size_t k = 0; k < 2; ++k) {
      if ((kept >> k & 1) == 0) continue;
      add_constraint(broad_edges_[j + k], {{{nx[k], ny[k], nz[k]}, c[k]}, true, false, gap[k]});
      near_cut_ = true;
    }
  }
}

/// What is known of a candidate, made if it was not.
inline SurfaceContact::Known SurfaceContact::known_of(const Volume& volume, const Tool& tool, std::size_t i) noexcept {
  if (known_[i] == Known::unmade) make(volume, tool, i);
  return known_[i];
}

/// Those of a ball. The number of candidates looked at.
std::size_t SurfaceContact::add_ball_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at,
                                                 double slack_mm) noexcept {
  const double r = tool.bur->radius_mm;
  const double edge_mm = kHalfEdge * voxel_mm_;
  const double ball = r + step, edge = ball + edge_mm;
  const double ball2 = ball * ball, edge2 = edge * edge;
  const double beside = kPlaneReach * voxel_mm_;
  const double flat2 = (r + slack_mm) * (r + slack_mm) + beside * beside;
  const double bent = edges_ ? r + slack_mm + edge_mm : 0.0;
  const double wide = std::sqrt(std::max(flat2, bent * bent)) / voxel_mm_ + kFloatSlack;
  broad_faces_.count = broad_edges_.count = broad_others_.count = 0;
  for_near(place_x_.data(), place_y_.data(), place_z_.data(), static_cast<int>(ball_count_), Vec3f((at - gathered_.centre) / voxel_mm_),
           static_cast<float>(wide * wide), [&](int k) {
             const Known what = known_of(volume, tool, static_cast<std::size_t>(k));
             (what == Known::edge ? broad_edges_ : what == Known::other ? broad_others_ : broad_faces_).add(k);
           });
  const std::size_t looked = broad_faces_.count + broad_edges_.count + broad_others_.count;
  add_face_constraints(centre, ball2, at, slack_mm);
  add_edge_constraints(tool, centre, edge2, at, slack_mm);
  for (std::size_t j = 0; j < broad_others_.count; ++j) {
    const Vec3 d = candidates_[broad_others_[j]].point - centre;
    if (glm::dot(d, d) <= ball2) constrain(broad_others_[j], bounded_plane_of(tool, candidates_[broad_others_[j]], at, slack_mm));
  }
  return looked;
}

/// Those of a head that is no ball.
std::size_t SurfaceContact::add_head_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at,
                                                 double slack_mm) noexcept {
  // A rim stands on the plane of a point that is beside it.
  const double beside = kPlaneReach * voxel_mm_;
  HeadBand band(tool.bur->head, tool.axis, slack_mm, beside, 1.0 / voxel_mm_);
  band.at = VecLanes(Vec3f((at - gathered_.centre) / voxel_mm_));
  const double far = step + beside;
  // A distance to the head changes by no more than the head moves: few are reckoned at `centre` too.
  const Vec3 moved = at - centre;
  const double most = std::sqrt(glm::dot(moved, moved)) + kRounding;
  std::size_t looked = 0;
  for_band(place_x_.data(), place_y_.data(), place_z_.data(), static_cast<int>(ball_count_), band, [&](int k, bool may_be_surface) {
    const auto i = static_cast<std::size_t>(k);
    if (sources_[i].kind == Kind::surface && !may_be_surface) return;
    known_of(volume, tool, i);
    ++looked;
    const Candidate& c = candidates_[i];
    const Vec3 point = c.point - at;
    ByHead place = by_axis(tool.axis, point);
    HeadFoot foot;
    if (c.kind == Kind::surface) {
      foot = deepest_foot(*tool.bur, tool.axis, c.normal, point, place, beside);
      // Neither the point nor its plane holds off what stands higher over the plane than the slack.
      if (foot.over + tool.thin(c.field) > slack_mm + kNormalRounding) return;
    }
    reckon(*tool.bur, place);
    if (place.distance > far + most) return;
    if (place.distance > far - most && head_distance(*tool.bur, tool.axis, c.point - centre) > far) return;
    if (!foot.deepest) foot = foot_beside(*tool.bur, tool.axis, c.normal, point, place, beside, foot);
    constrain(i, plane_of_head(tool, c, place, foot, at, slack_mm));
  });
  return looked;
}

/// Those of neck and shank: of what the step may touch (more may be at hand), and comes near there.
std::size_t SurfaceContact::add_shank_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at,
                                                  double slack_mm) noexcept {
  const Reach shank = shank_within(tool, step), there = shank_within(tool, slack_mm);
  const auto touches = [&](const Reach& reach, Vec3 from, Vec3 p) {
    const Vec3 d = p - from;
    const double t = glm::dot(d, tool.axis);
    if (t < reach.from || t > reach.to) return false;
    const double radius = t > reach.wide_from ? reach.thick : reach.slim;
    return glm::dot(d, d) - t * t <= radius * radius;
  };
  TwoCylinders shape = shank_within(tool, slack_mm + kMostMovedOut * voxel_mm_).cylinders(tool.axis, voxel_mm_);
  shape.at = Vec3f((at - gathered_.centre) / voxel_mm_);
  const std::size_t from = ball_count_;
  std::size_t looked = 0;
  for_inside(&place_x_[from], &place_y_[from], &place_z_[from], static_cast<int>(shank_count_), CylinderLanes(shape), [&](int k) {
    const std::size_t i = from + static_cast<std::size_t>(k);
    known_of(volume, tool, i);
    ++looked;
    Candidate c = candidates_[i];
    if (walls_.uncarved_holds(c.point) && !walls_.move_out(volume, walls_.cutting().uncarved, kMostMovedNow * voxel_mm_, c.point)) return;
    if (touches(there, at, c.point) && touches(shank, centre, c.point)) constrain(i, bounded_plane_of(tool, c, at, slack_mm));
  });
  return looked;
}

/// Builds the constraints, seen from `at` and at most slack_mm away, of all that a step from `centre` can reach.
void SurfaceContact::build_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at,
                                       double slack_mm) noexcept {
  planes_.clear();
  near_cut_ = false;
  std::size_t looked = tool.ball() ? add_ball_constraints(volume, tool, centre, step, at, slack_mm)
                                   : add_head_constraints(volume, tool, centre, step, at, slack_mm);
  if (shank_count_ > 0) looked += add_shank_constraints(volume, tool, centre, step, at, slack_mm);
  built_ = {at, slack_mm, planes_.size()};
  if (looked > most_candidates_) most_candidates_ = looked;
  const int unit = tool.ball() ? 1 : kHeadCandidate;
  const int cost = kCandidatesOfConstraint * static_cast<int>(planes_.size()) * unit;
  candidates_left_ -= cost;
  visited_before_ += static_cast<std::int64_t>(looked) * unit - cost;  // candidates_visited() counts what was looked at
}

/// The same constraints, seen from another place and at most slack_mm away, of the last full build's candidates. False if that
/// build did not reach so far.
bool SurfaceContact::rebuild_constraints(const Tool& tool, Vec3 at, double slack_mm) noexcept {
  const Vec3 shift = at - built_.at;
  const double shifted = std::sqrt(glm::dot(shift, shift));
  const double within = slack_mm + shifted;
  if (shifted > kMostShift || within > built_.within_mm) return false;
  planes_.clear();
  int looked = 0;
  for (std::size_t k = 0; k < built_.count; ++k) {
    if (low_[k] > within) continue;
    ++looked;
    const Constraint found = plane_of(tool, candidates_[static_cast<std::size_t>(near_[k])], at, slack_mm);
    if (!found.near) continue;
    origins_[planes_.size()] = {near_[k], found.trusted, false};
    planes_.add(found.plane.n, found.plane.c);
  }
  candidates_left_ -= looked * (tool.ball() ? 1 : kHeadCandidate);
  return true;
}

}  // namespace cusp::engine
