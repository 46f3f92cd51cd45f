// Planes from candidates: what keeps a bur off a point of a surface, an edge, a neck's or a shank's touch; and where a bur
// that rolls over edges will come to rest.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"

namespace cusp::engine {

namespace {

constexpr int kEdgePasses = 14;               // halvings of an edge's piece of 1.4 voxels: to some 5 nm
constexpr double kLeastShare = 0.5;           // cos 60 deg: sides that turn further apart are opposite flanks, deep in the head
constexpr double kCloseLeapMm = 0.02;
// A ball that is thinner by 1 um against an edge comes to the points that are nearer to it, unless it stands steeper than 84 deg.
constexpr double kOnEdgeMm = 0.01;

/// Of a head at y to an edge's piece about `middle`: a plane's way to it, along -gradient. Where the edge cuts into a rim, the
/// distance has a kink, and the gradient is the share of both sides that does not run along the edge.
double distance_to_edge(const Bur& bur, Vec3 axis, Vec3 y, Vec3 middle, Vec3 tangent, const CutFeature& f, Vec3& gradient) noexcept {
  const Vec3 bend(f.other_normal), twist(f.third_normal);
  struct Place {
    double t, distance, slope;
    Vec3 gradient;
  };
  const auto look = [&](double t) {
    Place out{t, 0.0, 0.0, Vec3(0.0)};
    const Vec3 point = middle + t * (tangent + t * (bend + t * twist)) - y;
    out.distance = head_distance(bur, axis, point, out.gradient);
    out.slope = glm::dot(out.gradient, tangent + t * (2.0 * bend + t * (3.0 * twist)));
    return out;
  };
  // It is all but convex along a piece: nearest where its slope changes sign.
  Place high = look(f.third_d_mm), low = high;
  if (high.slope > 0.0) low = look(f.other_d_mm);
  if (!(low.slope < 0.0 && high.slope > 0.0)) {
    gradient = low.gradient;
    return low.distance;
  }
  for (int pass = 0; pass < kEdgePasses; ++pass) {
    const Place between = look(0.5 * (low.t + high.t));
    (between.slope > 0.0 ? high : low) = between;
  }
  const double share = high.slope / (high.slope - low.slope);
  gradient = low.gradient * share + high.gradient * (1.0 - share);
  const double length = length_of(gradient);
  if (length < kLeastShare) {
    gradient = low.gradient;
    return low.distance;
  }
  gradient /= length;
  return (low.distance < high.distance ? low.distance : high.distance) / length;
}

}  // namespace

/// Of a ball at y, `off` away from what it touches.
SurfaceContact::Constraint SurfaceContact::tangent_of(Vec3 off, Vec3 y, double r, double slack_mm) noexcept {
  Constraint out;
  const double square = glm::dot(off, off), far = r + slack_mm;
  if (square > far * far || square < 1e-18) return out;
  const double distance = std::sqrt(square);
  out.near = true;
  out.plane.n = off / distance;
  out.plane.c = glm::dot(out.plane.n, y) - (distance - r);
  return out;
}

/// True if an edge answers for the point of a surface: a bur is thinner against edges of what was cut.
bool SurfaceContact::on_edge(const Candidate& c) const noexcept {
  return all_resolved_ && c.others > 0 && (c.feature->other_d_mm > -kOnEdgeMm || (c.others > 1 && c.feature->third_d_mm > -kOnEdgeMm));
}

/// The plane of a point of a surface, seen from y.
inline SurfaceContact::Constraint SurfaceContact::plane_of_surface(double r, const Candidate& c, Vec3 y, double slack_mm) const noexcept {
  const double beside = kPlaneReach * voxel_mm_;
  const double far = r + slack_mm;
  const Vec3 d = y - c.point;
  const double square = glm::dot(d, d);
  if (square > far * far + beside * beside) return {};
  const double height = glm::dot(c.normal, y) - c.level;
  if (height > 0.0 && square - height * height <= beside * beside) {
    // While the bur cuts, its own scratch is a lens, whose side turns up again within the plane's reach.
    const double bulge = !all_resolved_ && c.field == Field::base && c.others > 0 ? 0.5 * (square - height * height) / r : 0.0;
    const auto past = [&](Vec3 other, double other_d) {
      return other_d + glm::dot(other, d) - height * glm::dot(other, c.normal) > bulge;
    };
    const bool beyond = c.others > 0 && (past(Vec3(c.feature->other_normal), c.feature->other_d_mm) ||
                                         (c.others > 1 && past(Vec3(c.feature->third_normal), c.feature->third_d_mm)));
    if (!beyond) {
      if (height > far) return {};
      return {{c.normal, c.level + r}, true, true};
    }
  }
  return on_edge(c) ? Constraint{} : tangent_of(d, y, r, slack_mm);
}

/// The neck's and the shank's: capsules along the axis; the nearer of the two holds the point off.
SurfaceContact::Constraint SurfaceContact::plane_of_shank(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm) const noexcept {
  Constraint out;
  const Bur& bur = *tool.bur;
  const double along = glm::dot(c.point - y, tool.axis);
  bool any = false;
  double best = 0.0;
  for (int part = 0; part < 2; ++part) {
    const double from = part == 0 ? tool.neck_from() : bur.neck_length_mm + bur.shank_radius_mm;
    const double to = part == 0 ? bur.neck_length_mm : bur.neck_length_mm + bur.shank_length_mm;
    const double radius = part == 0 ? bur.neck_radius_mm : bur.shank_radius_mm;
    const double t = along < from ? from : along > to ? to : along;
    const Vec3 d = y + tool.axis * t - c.point;
    const double distance = length_of(d);
    if (distance < 1e-9) continue;
    const double gap = distance - radius;
    if (any && gap >= best) continue;
    any = true;
    best = gap;
    out.plane.n = d / distance;
  }
  out.near = any && best <= slack_mm;
  out.plane.c = glm::dot(out.plane.n, y) - best;
  return out;
}

/// As plane_of, for a head that is no ball. `place`: the candidate's point by the head at y. foot: on a surface, head_foot().
SurfaceContact::Constraint SurfaceContact::plane_of_head(const Tool& tool, const Candidate& c, ByHead& place, const HeadFoot& foot,
                                                         Vec3 y, double slack_mm) const noexcept {
  const double thin = tool.thin(c.field);
  Constraint out;
  if (c.kind == Kind::surface) {
    const double beside = kPlaneReach * voxel_mm_, beside2 = beside * beside;
    const Vec3 point = c.point - y;
    out.low_mm = foot.over + thin;
    const double facing = glm::dot(c.normal, foot.normal);
    const double height = (glm::dot(c.normal, y + foot.at) - c.level + thin) / facing;
    const Vec3 d = foot.at - point;
    const double over = glm::dot(c.normal, d), side2 = glm::dot(d, d) - over * over;
    if (facing > kFacing && height > -tool.bur->radius_mm && side2 <= beside2) {
      // Of a place of the head inside both surfaces, the nearer one holds it.
      const auto past = [&](Vec3 other, double other_d) {
        const double there = other_d + glm::dot(other, d);
        return there > over * glm::dot(other, c.normal) || (over < 0.0 && there > over);
      };
      const bool beyond = (c.others > 0 && past(Vec3(c.feature->other_normal), c.feature->other_d_mm)) ||
                          (c.others > 1 && past(Vec3(c.feature->third_normal), c.feature->third_d_mm));
      if (!beyond) {
        if (height > slack_mm) return out;
        out.near = true;
        out.plane.n = foot.normal;
        out.plane.c = glm::dot(foot.normal, y) - height;
        out.trusted = foot.deepest;
        return out;
      }
    }
    if (on_edge(c)) return out;
  }
  reckon(*tool.bur, place);
  double gap = place.distance + thin;
  Vec3 gradient;
  if (c.kind == Kind::edge) {
    if (gap > slack_mm + voxel_mm_) return out;
    gap = distance_to_edge(*tool.bur, tool.axis, y, c.point, c.normal, *c.feature, gradient) + thin;
    out.low_mm = gap;
  } else {
    gradient = gradient_in_space(place, tool.axis);
    if (c.kind == Kind::inside) out.low_mm = gap -= c.level;
  }
  if (gap > slack_mm) return out;
  out.near = true;
  out.plane.n = -gradient;
  out.plane.c = glm::dot(out.plane.n, y) - gap;
  return out;
}

/// The plane that keeps the bur off one candidate, seen from y.
SurfaceContact::Constraint SurfaceContact::plane_of(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm) const noexcept {
  if (c.kind == Kind::shank) return plane_of_shank(tool, c, y, slack_mm);
  if (!tool.ball()) {
    ByHead place = by_axis(tool.axis, c.point - y);
    HeadFoot foot;
    if (c.kind == Kind::surface) foot = head_foot(*tool.bur, tool.axis, c.normal, c.point - y, place, kPlaneReach * voxel_mm_);
    return plane_of_head(tool, c, place, foot, y, slack_mm);
  }
  const double r = tool.bur->radius_mm - tool.thin(c.field);
  if (c.kind == Kind::surface) return plane_of_surface(r, c, y, slack_mm);
  Vec3 d = y - c.point, along;
  double curved = 0.0;
  nearest_on(c, r + slack_mm, d, along, curved);
  return tangent_of(d, y, r, slack_mm);
}

/// Planes of candidates from..to - 1, added to those that are there.
void SurfaceContact::planes(const Tool& tool, Vec3 y, std::size_t from, std::size_t to, double slack_mm) noexcept {
  for (std::size_t i = from; i < to; ++i) {
    const Constraint found = plane_of(tool, candidates_[i], y, slack_mm);
    if (!found.near) continue;
    origins_[planes_.size()] = {static_cast<std::int32_t>(i), found.trusted, false};
    planes_.add(found.plane.n, found.plane.c);
  }
}

/// A tangent follows its pose; planes of the field and of the foot stay.
void SurfaceContact::turn(const Tool& tool, Vec3 y, std::size_t i) noexcept {
  if (origins_[i].trusted_plane) return;
  const Constraint found = plane_of(tool, candidates_[static_cast<std::size_t>(origins_[i].candidate)], y, 1.0);
  if (!found.near) return;
  planes_.set(i, found.plane.n, found.plane.c);
  origins_[i].trusted_plane = found.trusted;
  relax_by_past(i, i + 1);
}

/// Where a ball rolls over edges and points its planes turn with it, and each pass leaves a share of the way: what the
/// passes to come would add to off_by, the move of the last one from where its planes were built. rolls: they would not come
/// to rest.
Vec3 SurfaceContact::leap_of_ball(const PlaneSearch& found, Vec3 at, Vec3 off_by, bool& rolls) const noexcept {
  if (found.active == 0 || found.active > 2) return Vec3(0.0);
  // Along what is left free: one direction between two planes, two on one.
  Vec3 free[2] = {Vec3(0.0), Vec3(0.0)};
  const Vec3 n = planes_.n(static_cast<std::size_t>(found.index[0]));
  if (found.active == 2) {
    const Vec3 along = glm::cross(n, planes_.n(static_cast<std::size_t>(found.index[1])));
    const double length = length_of(along);
    if (length < 1e-3) return Vec3(0.0);
    free[0] = along / length;
  } else {
    const Vec3 along = std::fabs(n.x) < 0.6 ? Vec3(0.0, n.z, -n.y) : Vec3(-n.z, 0.0, n.x);
    free[0] = along / length_of(along);
    free[1] = glm::cross(n, free[0]);
  }
  const int directions = 3 - found.active;
  const bool close = glm::dot(off_by, off_by) < kCloseLeapMm * kCloseLeapMm;
  // m = sum of weight times the second derivative of the distance to what each plane stands for.
  double m[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
  for (int a = 0; a < found.active; ++a) {
    const auto i = static_cast<std::size_t>(found.index[a]);
    const Origin& origin = origins_[i];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    // Of a point of a face it is believed only close by: there the face itself soon takes over.
    if (origin.trusted_plane || origin.relaxed || c.kind == Kind::shank || (c.kind == Kind::surface && !close)) continue;
    Vec3 off = at - c.point, along(0.0);
    double curved = 0.0;
    if (c.kind == Kind::edge && !nearest_on(c, 1e3, off, along, curved)) curved = 0.0;
    const double distance = length_of(off);
    if (distance < 1e-6) continue;
    const Vec3 out = off / distance;
    for (int j = 0; j < directions; ++j)
      for (int k = 0; k <= j; ++k) {
        double h = (j == k ? 1.0 : 0.0) - glm::dot(free[j], out) * glm::dot(free[k], out);
        if (curved > 0.0) h -= glm::dot(free[j], along) * glm::dot(free[k], along) / curved;
        m[j][k] += found.weight[a] * h / distance;
      }
  }
  m[0][1] = m[1][0];
  // The geometric series m + m^2 + ..: m (1 - m)^-1, where it converges.
  constexpr double kLeast = 0.03;
  const Vec3 moved(glm::dot(off_by, free[0]), directions > 1 ? glm::dot(off_by, free[1]) : 0.0, 0.0);
  const double a = 1.0 - m[0][0], b = -m[0][1], d = directions > 1 ? 1.0 - m[1][1] : 1.0;
  const double det = a * d - b * b;
  rolls = !(a > kLeast && d > kLeast && det > kLeast * kLeast);
  const double size = length_of(moved);
  if (size > kFarthestLeapMm) return Vec3(0.0);  // what the second order says of so long a way is not to be believed
  const double most = std::min(kLongestLeap * size, kFarthestLeapMm);
  if (rolls) return size > 0.0 ? (free[0] * moved.x + free[1] * moved.y) * (most / size) : Vec3(0.0);
  const double u = (d * moved.x - b * moved.y) / det - moved.x;
  const double v = (a * moved.y - b * moved.x) / det - moved.y;
  const double length = std::sqrt(u * u + v * v);
  const double share = length > most ? most / length : 1.0;
  return (free[0] * u + (directions > 1 ? free[1] * v : Vec3(0.0))) * share;
}

}  // namespace cusp::engine
