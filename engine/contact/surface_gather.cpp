// Candidates of the surface proxy: which points, edges and normals of the two fields may touch within one step; and the
// free space in which none does.
#include <algorithm>
#include <cmath>

#include "engine/contact/near_points.h"
#include "engine/contact/surface_contact.h"
#include "engine/tool/swept.h"

namespace cusp {

namespace {

/// Voxels that single precision may be off by in `for_near`, and then some.
constexpr double kLoose = 1e-3;
constexpr double kFreeMargin = 0.5;   // mm: how far a look for free space goes
constexpr double kCloseMm = 0.2;      // mm: the nearest point is looked for first so near
constexpr double kLeastFree = 0.02;   // mm: less is not worth keeping
constexpr std::size_t kManyShank = 24;
constexpr double kSlowStep = 0.016;   // mm in a tick (16 mm/s): below, candidates are gathered ...
constexpr double kSlowMargin = 0.024; // ... for as long as the burr stays this near; else for two steps
constexpr int kPause = 16;            // looks that are skipped where there was too little

/// Squared distance of a point to a box.
double box_distance2(Vec3 p, Vec3 low, Vec3 high) noexcept {
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double d = p[a] < low[a] ? low[a] - p[a] : p[a] > high[a] ? p[a] - high[a] : 0.0;
    sum += d * d;
  }
  return sum;
}

IVec3 brick_floor(const Grid& grid, Vec3 p) noexcept {
  return cell_of_voxels((p - grid.origin_mm) * (1.0 / (grid.voxel_mm * kBrickEdge)));
}

/// In voxels, from a pivot that is still to be given, and a little wider.
TwoCylinders cylinders_of(double from, double wide_from, double to, double slim, double thick, Vec3 axis,
                          double per_mm) noexcept {
  TwoCylinders out;
  out.axis = Vec3f(axis);
  const double narrow = slim * per_mm + kLoose, wide = thick * per_mm + kLoose;
  out.narrow2 = static_cast<float>(narrow * narrow);
  out.wide2 = static_cast<float>(wide * wide);
  out.from = static_cast<float>(from * per_mm - kLoose);
  out.wide_from = static_cast<float>(wide_from * per_mm - kLoose);
  out.to = static_cast<float>(to * per_mm + kLoose);
  return out;
}

}  // namespace

void SurfaceContact::add(const Candidate& candidate, const CutFeature* own) noexcept {
  if (count_ == candidates_.size()) {
    overflow_ = true;
    return;
  }
  sources_[count_].made = true;
  Candidate& out = candidates_[count_];
  out = candidate;
  if (own != nullptr) {
    features_[count_] = *own;
    out.feature = &features_[count_];
  }
  ++count_;
}

/// A candidate of the ball, which is only made when a search comes near it. x, y, z: voxels from where it is gathered.
void SurfaceContact::add_unmade(float x, float y, float z, std::int32_t brick, IVec3 at, std::int32_t index,
                                const CutSurface::Page* page) noexcept {
  if (count_ == candidates_.size()) {
    overflow_ = true;
    return;
  }
  place_x_[count_] = x;
  place_y_[count_] = y;
  place_z_[count_] = z;
  sources_[count_++] = {page, brick, static_cast<std::uint16_t>(index), false, static_cast<std::int16_t>(at.x),
                        static_cast<std::int16_t>(at.y), static_cast<std::int16_t>(at.z)};
}

const SurfaceContact::Candidate& SurfaceContact::made(const Volume& volume, std::size_t i) noexcept {
  Candidate& out = candidates_[i];
  Source& source = sources_[i];
  if (source.made) return out;
  source.made = true;
  const Grid& grid = volume.grid();
  Vec3 place;
  if (source.page != nullptr) {
    const CutSurface::Page& page = *source.page;
    place = Vec3(page.x[source.index], page.y[source.index], page.z[source.index]);
    out.feature = &page.feature[source.index];
  } else {
    const Specimen& specimen = volume.specimen();
    const BasePoints points = specimen.surface().in(source.brick);
    place = Vec3(points.x[source.index], points.y[source.index], points.z[source.index]);
    const BaseNormal& normal = points.normal[source.index];
    if (!normal.edge() && !normal.beside_edge()) {
      out.point = grid.origin_mm + grid.voxel_mm * (Vec3(IVec3(source.x, source.y, source.z) * kBrickEdge) + place);
      out.normal = Vec3(normal.unit());
      out.level = glm::dot(out.normal, out.point);
      out.feature = nullptr;
      out.kind = Kind::surface;
      out.field = Field::base;
      out.tissue = points.tissue[source.index];
      out.others = 0;
      return out;
    }
    features_[i] = CutFeature{};
    base_feature(specimen.surface(), points, source.index, grid.voxel_mm, features_[i]);
    out.feature = &features_[i];
  }
  const CutFeature& feature = *out.feature;
  out.point = grid.origin_mm + grid.voxel_mm * (Vec3(IVec3(source.x, source.y, source.z) * kBrickEdge) + place);
  out.normal = Vec3(feature.normal);
  out.level = glm::dot(out.normal, out.point);
  out.kind = feature.edge ? Kind::edge : Kind::surface;
  out.field = feature.field;
  out.tissue = feature.tissue;
  out.others = feature.others;
  return out;
}

/// Calls chosen(x, y, z, count, corner mm, visit(i)) with the places of a brick's points and edges, in voxels from its
/// first voxel, in cell order, and visit(place mm, feature) for those that it lets through.
template <class Choose, class Visit>
void SurfaceContact::features(const Volume& volume, int brick, IVec3 at, Choose&& choose, Visit&& visit) noexcept {
  const Grid& grid = volume.grid();
  const Vec3 corner_mm = grid.origin_mm + grid.voxel_mm * Vec3(at * kBrickEdge);
  if (!volume.has_cut(brick)) {
    const BasePoints points = volume.specimen().surface().in(brick);
    choose(points.x, points.y, points.z, points.count, corner_mm, [&](int i) {
      CutFeature feature;
      base_feature(volume.specimen().surface(), points, i, grid.voxel_mm, feature);
      visit(corner_mm + grid.voxel_mm * Vec3(points.x[i], points.y[i], points.z[i]), feature);
    });
    return;
  }
  for (std::int32_t p = cut_.first(volume, brick); p >= 0;) {
    const CutSurface::Page& page = cut_.page(p);
    choose(page.x, page.y, page.z, page.count, corner_mm, [&](int i) {
      visit(corner_mm + grid.voxel_mm * Vec3(page.x[i], page.y[i], page.z[i]), page.feature[i]);
    });
    p = page.next;
  }
}

/// The box (mm) about the points of a brick; false where it has none. A brick that was cut fills its own.
inline bool SurfaceContact::points_box(const Volume& volume, int brick, IVec3 at, Vec3& low, Vec3& high) const noexcept {
  const PointsBox& box = boxes_[static_cast<std::size_t>(brick)];
  const bool cut = volume.has_cut(brick);
  if (!cut && box.empty()) return false;
  const Grid& grid = volume.grid();
  const Vec3 corner = grid.origin_mm + grid.voxel_mm * Vec3(at * kBrickEdge);
  if (cut) {
    low = corner - 0.2 * grid.voxel_mm;
    high = corner + 8.2 * grid.voxel_mm;
    return true;
  }
  low = corner + grid.voxel_mm * box.low();
  high = corner + grid.voxel_mm * box.high();
  return true;
}

/// Calls visit(brick, at, square) for each brick, in index order, with points that may lie within reach of a place: squared
/// distance of the box about them.
template <class Visit>
void SurfaceContact::ball_bricks(const Volume& volume, Vec3 centre, double reach, Visit&& visit) const noexcept {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  // A cell's point may stand a tenth of a voxel outside its cell, and the brick's last cells end a voxel beyond it.
  const double slack = 0.2 * grid.voxel_mm;
  const double wide = reach + slack;
  const IVec3 low = glm::max(brick_floor(grid, centre - wide), bricks_low_);
  const IVec3 high = glm::min(brick_floor(grid, centre + wide), bricks_high_);
  const double side = grid.voxel_mm * kBrickEdge;
  const double reach2 = reach * reach;
  const auto off2 = [&](int axis, int b) {
    const double from = grid.origin_mm[axis] + side * b - slack - centre[axis];
    const double to = from + side + 2.0 * slack;
    const double d = from > 0.0 ? from : to < 0.0 ? to : 0.0;
    return d * d;
  };
  for (int z = low.z; z <= high.z; ++z) {
    const double z2 = off2(2, z);
    for (int y = low.y; y <= high.y; ++y) {
      const double zy2 = z2 + off2(1, y);
      if (zy2 > reach2) continue;
      const int row = specimen.brick_index({0, y, z});
      for (int x = low.x; x <= high.x; ++x) {
        const int brick = row + x;
        if (boxes_[static_cast<std::size_t>(brick)].empty() && !volume.has_cut(brick)) continue;
        if (zy2 + off2(0, x) > reach2) continue;
        Vec3 a, b;
        if (!points_box(volume, brick, {x, y, z}, a, b)) continue;
        const double square = box_distance2(centre, a, b);
        if (square <= reach2) visit(brick, IVec3(x, y, z), square);
      }
    }
  }
}

void SurfaceContact::gather_head(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm) noexcept {
  // An edge holds 0.7 voxel either way along its tangent.
  const double edge_mm = 0.7 * voxel_mm_;
  edges_ = false;
  const Grid& grid = volume.grid();
  const double per_mm = 1.0 / voxel_mm_;
  // near(x, y, z, count, local, sharp, pass): which places to take; local: the centre in voxels from the brick's corner.
  const auto take = [&](int brick, IVec3 at, auto&& near) {
    const bool cut = volume.has_cut(brick);
    const bool sharp = cut || boxes_[static_cast<std::size_t>(brick)].edges;
    edges_ = edges_ || sharp;
    const Vec3 corner_mm = grid.origin_mm + voxel_mm_ * Vec3(at * kBrickEdge);
    const Vec3f local((centre - corner_mm) * per_mm);
    const auto gather_near = [&](const float* x, const float* y, const float* z, int count, const CutSurface::Page* page) {
      near(x, y, z, count, local, sharp, [&](int i) {
        add_unmade(x[i] - local.x, y[i] - local.y, z[i] - local.z, brick, at, i, page);
      });
    };
    if (!cut) {
      const BasePoints points = volume.specimen().surface().in(brick);
      gather_near(points.x, points.y, points.z, points.count, nullptr);
      return;
    }
    for (std::int32_t p = cut_.first(volume, brick); p >= 0; p = cut_.page(p).next) {
      const CutSurface::Page& page = cut_.page(p);
      const std::size_t before = count_;
      gather_near(page.x, page.y, page.z, page.count, &page);
      // A page that is not kept serves until the next brick is asked for.
      if (!cut_.kept(p))
        for (std::size_t i = before; i < count_; ++i) {
          features_[i] = *made(volume, i).feature;
          candidates_[i].feature = &features_[i];
        }
    }
  };
  if (!tool.ball()) {
    const Reach reach = head_within(tool, margin_mm + std::max(edge_mm, kPlaneReach * voxel_mm_));
    TwoCylinders shape = cylinders_of(reach.from, reach.wide_from, reach.to, reach.slim, reach.thick, tool.axis, per_mm);
    bricks_within(volume, tool.axis, centre, reach, [&](int brick, IVec3 at) {
      take(brick, at, [&](const float* x, const float* y, const float* z, int count, Vec3f local, bool, auto&& pass) {
        shape.at = local;
        for_inside(x, y, z, count, shape, pass);
      });
    });
    return;
  }
  const double reach = tool.burr->radius_mm + margin_mm;
  const double edge_reach = reach + edge_mm;
  ball_bricks(volume, centre, edge_reach, [&](int brick, IVec3 at, double) {
    take(brick, at, [&](const float* x, const float* y, const float* z, int count, Vec3f local, bool sharp, auto&& pass) {
      const double wide = (sharp ? edge_reach : reach) * per_mm + kLoose;
      for_near(x, y, z, count, local, static_cast<float>(wide * wide), pass);
    });
  });
}

/// Of the neck and the shank. Up to `inner` along the axis the neck lies within a ball, which answers for it.
SurfaceContact::Reach SurfaceContact::shank_within(const Tool& tool, double margin_mm) noexcept {
  const Burr& b = *tool.burr;
  const double inner = b.neck_radius_mm + margin_mm;
  const double r2 = tool.ball() ? b.radius_mm * b.radius_mm - inner * inner : 0.0;
  return {r2 > 0.0 ? std::sqrt(r2) : tool.neck_from(), b.neck_length_mm - margin_mm,
          b.neck_length_mm + b.shank_length_mm + margin_mm, b.neck_radius_mm + margin_mm, b.shank_radius_mm + margin_mm};
}

/// Of a head that is no ball.
SurfaceContact::Reach SurfaceContact::head_within(const Tool& tool, double margin_mm) noexcept {
  const Profile& head = tool.burr->head;
  const double wide = head.widest() + margin_mm;
  return {head.low() - margin_mm, head.low() - margin_mm, head.high() + margin_mm, wide, wide};
}

/// Calls visit(brick) for each brick, in index order, whose surface may lie in two cylinders.
template <class Visit>
void SurfaceContact::bricks_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach,
                                   Visit&& visit) const noexcept {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const double thick = std::max(reach.thick, reach.slim);
  const double slack = 0.2 * grid.voxel_mm;
  const auto box = [&](double low_t, double high_t, double radius, IVec3& low, IVec3& high) {
    const Vec3 a = centre + axis * low_t, b = centre + axis * high_t;
    low = glm::max(brick_floor(grid, glm::min(a, b) - (radius + slack)), bricks_low_);
    high = glm::min(brick_floor(grid, glm::max(a, b) + (radius + slack)), bricks_high_);
  };
  // The slim one's box and the thick one's, as one walk in index order.
  IVec3 slim_low, slim_high, thick_low, thick_high;
  box(reach.from, std::max(reach.from, reach.wide_from), reach.slim, slim_low, slim_high);
  box(reach.wide_from, reach.to, thick, thick_low, thick_high);
  const bool both = thick_low.x <= thick_high.x && thick_low.y <= thick_high.y && thick_low.z <= thick_high.z;
  const IVec3 low = both ? glm::min(slim_low, thick_low) : slim_low;
  const IVec3 high = both ? glm::max(slim_high, thick_high) : slim_high;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y) {
      const int row = specimen.brick_index({0, y, z});
      for (int x = low.x; x <= high.x; ++x) {
        if (boxes_[static_cast<std::size_t>(row + x)].empty() && !volume.has_cut(row + x)) continue;
        Vec3 a, b;
        if (!points_box(volume, row + x, {x, y, z}, a, b)) continue;
        const Vec3 middle = 0.5 * (a + b) - centre, half = 0.5 * (b - a);
        const double t = glm::dot(middle, axis);
        const double along = half.x * std::fabs(axis.x) + half.y * std::fabs(axis.y) + half.z * std::fabs(axis.z);
        if (t + along < reach.from || t - along > reach.to) continue;
        const double wide = t + along > reach.wide_from ? thick : reach.slim;
        const double diagonal2 = glm::dot(half, half);
        const double off2 = glm::dot(middle, middle) - t * t;
        // off > wide + diagonal, squared twice so that no root is taken: (a + b)^2 <= 2 a^2 + 2 b^2.
        if (off2 > 2.0 * (wide * wide + diagonal2)) continue;
        visit(row + x, IVec3(x, y, z));
      }
    }
}

/// Calls visit(brick) for each brick, in index order, with points that may lie within margin of the head.
template <class Visit>
void SurfaceContact::head_bricks(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm,
                                 Visit&& visit) const noexcept {
  if (tool.ball())
    ball_bricks(volume, centre, tool.burr->radius_mm + margin_mm, [&](int brick, IVec3 at, double) { visit(brick, at); });
  else
    bricks_within(volume, tool.axis, centre, head_within(tool, margin_mm), visit);
}

void SurfaceContact::gather_shank(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm) noexcept {
  const double per_mm = 1.0 / voxel_mm_;
  const Reach reach = shank_within(tool, margin_mm);
  TwoCylinders shape = cylinders_of(reach.from, reach.wide_from, reach.to, reach.slim, reach.thick, tool.axis, per_mm);
  bricks_within(volume, tool.axis, centre, reach, [&](int brick, IVec3 at) {
    features(
        volume, brick, at,
        [&](const float* x, const float* y, const float* z, int count, Vec3 corner_mm, auto&& pass) {
          shape.at = Vec3f((centre - corner_mm) * per_mm);
          for_inside(x, y, z, count, shape, pass);
        },
        [&](Vec3 point, const CutFeature& f) {
          Candidate candidate;
          candidate.point = point;
          candidate.normal = Vec3(f.normal);
          candidate.kind = Kind::shank;
          candidate.field = f.field;
          candidate.tissue = f.tissue;
          add(candidate, nullptr);
        });
  });
}

/// Brings what a search of one step from `centre` may touch to hand: a little more than that, for the next one or two.
void SurfaceContact::gather(const Volume& volume, const Tool& tool, Vec3 centre, double step) noexcept {
  const auto reaches = [&](const Gathered& g) {
    const Vec3 off = centre - g.centre;
    const double left = g.margin_mm - step;
    return g.valid && g.burr == tool.index && g.axis == tool.axis && left >= 0.0 && glm::dot(off, off) <= left * left;
  };
  const double margin = step < kSlowStep ? kSlowMargin : 2.0 * step;
  if (!reaches(gathered_)) {
    count_ = 0;
    gathered_ = {centre, margin, tool.index, true, tool.axis};
    gather_head(volume, tool, centre, margin);
    ball_count_ = count_;
    shank_.valid = false;
  }
  count_ = ball_count_;
  if (reaches(shank_)) {
    count_ += shank_count_;
    return;
  }
  // Where the neck all but touches, each further margin brings in a wall of candidates that no search comes near.
  const double shank_margin = shank_tight_ > 0 ? step : margin;
  shank_ = {centre, shank_margin, tool.index, true, tool.axis};
  gather_shank(volume, tool, centre, shank_margin);
  shank_count_ = count_ - ball_count_;
  shank_tight_ = shank_count_ > kManyShank ? kPause : shank_tight_ > 0 ? shank_tight_ - 1 : 0;
}

/// Lays the planes, seen from `at` and no further off than slack_mm, of all that a step from `centre` can reach.
void SurfaceContact::near_planes(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at,
                                 double slack_mm) noexcept {
  planes_.clear();
  near_cut_ = false;
  const double r = tool.burr->radius_mm;
  const double edge_mm = 0.7 * voxel_mm_;
  const double ball = r + step, edge = ball + edge_mm;
  const double ball2 = ball * ball, edge2 = edge * edge;
  // A plane is believed 0.8 voxel beside its point, an edge holds 0.7 along its tangent.
  const double beside = kPlaneReach * voxel_mm_;
  const double flat2 = (r + slack_mm) * (r + slack_mm) + beside * beside;
  const double bent = edges_ ? r + slack_mm + edge_mm : 0.0;
  const double wide = std::sqrt(std::max(flat2, bent * bent)) / voxel_mm_ + kLoose;
  std::size_t looked = 0;
  const auto lay = [&](std::size_t i, const Candidate& c) {
    Plane plane;
    bool trusted = false;
    ++looked;
    if (!plane_of(tool, c, at, slack_mm, plane, trusted)) return;
    origins_[planes_.size()] = {static_cast<std::int32_t>(i), trusted, false};
    planes_.add(plane.n, plane.c);
    near_cut_ = near_cut_ || (c.kind != Kind::shank && (c.field == Field::cut || c.kind == Kind::edge));
  };
  const Vec3f here((at - gathered_.centre) / voxel_mm_);
  if (tool.ball()) {
    for_near(place_x_.data(), place_y_.data(), place_z_.data(), static_cast<int>(ball_count_),
             here, static_cast<float>(wide * wide), [&](int k) {
               const auto i = static_cast<std::size_t>(k);
               const Candidate& c = made(volume, i);
               const Vec3 d = c.point - centre;
               if (glm::dot(d, d) <= (c.kind == Kind::surface ? ball2 : edge2)) lay(i, c);
             });
  } else {
    const Reach reach = head_within(tool, slack_mm + std::max(beside, edge_mm));
    TwoCylinders shape = cylinders_of(reach.from, reach.wide_from, reach.to, reach.slim, reach.thick, tool.axis, 1.0 / voxel_mm_);
    shape.at = here;
    for_inside(place_x_.data(), place_y_.data(), place_z_.data(), static_cast<int>(ball_count_), shape, [&](int k) {
      const auto i = static_cast<std::size_t>(k);
      const Candidate& c = made(volume, i);
      // A rim stands on the plane of a point that is beside it.
      const double far = step + std::max(beside, edge_mm);
      if (head_distance(*tool.burr, tool.axis, c.point - centre) <= far) lay(i, c);
    });
  }
  if (count_ > ball_count_) {
    // Of all at hand, what the step may touch (more may be at hand), and comes near there.
    const Reach shank = shank_within(tool, step), there = shank_within(tool, slack_mm);
    const auto touches = [&](const Reach& reach, Vec3 from, Vec3 p) {
      const Vec3 d = p - from;
      const double t = glm::dot(d, tool.axis);
      if (t < reach.from || t > reach.to) return false;
      const double radius = t > reach.wide_from ? reach.thick : reach.slim;
      return glm::dot(d, d) - t * t <= radius * radius;
    };
    for (std::size_t i = ball_count_; i < count_; ++i)
      if (touches(there, at, candidates_[i].point) && touches(shank, centre, candidates_[i].point)) lay(i, candidates_[i]);
  }
  if (looked > most_candidates_) most_candidates_ = looked;
}

void SurfaceContact::find_free(const Volume& volume, const Tool& tool, Vec3 pose) noexcept {
  free_.valid = false;
  // The plane of the nearest point, moved up to the highest point of every brick in reach of head, neck and shank, and
  // half a voxel more for what stands between points.
  Vec3 n = tool.axis;
  if (tool.ball())
    nearest_to_ball(volume, tool.burr->radius_mm, pose, n);
  else
    nearest_to_head(volume, tool, pose, n);
  if (!raise_free(volume, tool, pose, n)) free_pause_ = kPause;
}

/// Normal of the surface's point that is nearest to a head that is no ball; false, and n as it was, where none is near.
bool SurfaceContact::nearest_to_head(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept {
  const double per_mm = 1.0 / voxel_mm_;
  double nearest = 1e300;
  for (const double margin : {kCloseMm, kFreeMargin}) {
    const Reach reach = head_within(tool, margin);
    TwoCylinders shape = cylinders_of(reach.from, reach.wide_from, reach.to, reach.slim, reach.thick, tool.axis, per_mm);
    bricks_within(volume, tool.axis, pose, reach, [&](int brick, IVec3 at) {
      features(
          volume, brick, at,
          [&](const float* x, const float* y, const float* z, int count, Vec3 corner_mm, auto&& pass) {
            shape.at = Vec3f((pose - corner_mm) * per_mm);
            for_inside(x, y, z, count, shape, pass);
          },
          [&](Vec3 point, const CutFeature& f) {
            Vec3 gradient;
            const double gap = head_distance(*tool.burr, tool.axis, point - pose, gradient);
            if (gap >= nearest) return;
            nearest = gap;
            n = f.edge ? -gradient : Vec3(f.normal);
          });
    });
    if (nearest < 1e200) return true;
  }
  return false;
}

/// The same of a ball.
bool SurfaceContact::nearest_to_ball(const Volume& volume, double r, Vec3 pose, Vec3& n) noexcept {
  double nearest2 = 1e300;
  Vec3 nearest(0.0);
  for (const double reach : {r + kCloseMm, r + kFreeMargin}) {
    const double per_mm = 1.0 / voxel_mm_;
    const auto look = [&](const float* x, const float* y, const float* z, int count, Vec3 corner_mm, auto&& feature) {
      const double wide = (nearest2 < 1e200 ? std::sqrt(nearest2) : reach) * per_mm + kLoose;
      int best = -1;
      for_near(x, y, z, count, Vec3f((pose - corner_mm) * per_mm), static_cast<float>(wide * wide), [&](int i) {
        const Vec3 d = pose - (corner_mm + voxel_mm_ * Vec3(x[i], y[i], z[i]));
        const double d2 = glm::dot(d, d);
        if (d2 >= nearest2) return;
        nearest2 = d2;
        nearest = d;
        best = i;
      });
      if (best < 0) return;
      const CutFeature& f = feature(best);
      nearest = f.edge ? nearest / std::sqrt(nearest2) : Vec3(f.normal);
    };
    ball_bricks(volume, pose, reach, [&](int brick, IVec3 at, double square) {
      if (square > nearest2) return;
      const Grid& grid = volume.grid();
      const Vec3 corner_mm = grid.origin_mm + grid.voxel_mm * Vec3(at * kBrickEdge);
      if (!volume.has_cut(brick)) {
        const BasePoints points = volume.specimen().surface().in(brick);
        CutFeature own;
        look(points.x, points.y, points.z, points.count, corner_mm, [&](int i) -> const CutFeature& {
          base_feature(volume.specimen().surface(), points, i, grid.voxel_mm, own);
          return own;
        });
        return;
      }
      for (std::int32_t p = cut_.first(volume, brick); p >= 0; p = cut_.page(p).next) {
        const CutSurface::Page& page = cut_.page(p);
        look(page.x, page.y, page.z, page.count, corner_mm,
             [&](int i) -> const CutFeature& { return page.feature[i]; });
      }
    });
    if (nearest2 < 1e200) break;
  }
  if (nearest2 < 1e200) n = nearest;
  return nearest2 < 1e200;
}

/// Free space beyond a plane with normal n, if there is enough.
bool SurfaceContact::raise_free(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 n) noexcept {
  const Burr& burr = *tool.burr;
  FreeSpace found{pose, n, kFreeMargin - voxel_mm_, 0.0, tool.index, true, false, tool.axis};
  double highest = -1e300;
  const Vec3f slim_n(n);
  const auto raise = [&](int brick, IVec3 at) {
    // Its highest corner along n is not above what there is.
    if (found.bounded && !volume.has_cut(brick)) {
      const PointsBox& box = boxes_[static_cast<std::size_t>(brick)];
      const Vec3 low = box.low(), high = box.high();
      const double top = glm::dot(n, volume.grid().origin_mm + voxel_mm_ * Vec3(at * kBrickEdge)) +
                         voxel_mm_ * ((n.x > 0.0 ? high.x : low.x) * n.x + (n.y > 0.0 ? high.y : low.y) * n.y +
                                      (n.z > 0.0 ? high.z : low.z) * n.z);
      if (top <= highest) return;
    }
    features(
        volume, brick, at,
        [&](const float* x, const float* y, const float* z, int count, Vec3 corner_mm, auto&&) {
          if (count == 0) return;
          found.bounded = true;
          const double height = glm::dot(n, corner_mm) + voxel_mm_ * highest_along(x, y, z, count, slim_n);
          highest = height > highest ? height : highest;
        },
        [](Vec3, const CutFeature&) {});
  };
  head_bricks(volume, tool, pose, kFreeMargin, raise);
  bricks_within(volume, tool.axis, pose, shank_within(tool, kFreeMargin), raise);
  if (found.bounded) {
    const double up = glm::dot(n, tool.axis);
    if (up < 0.0) return false;
    // The lowest place of each part along n, from the pose.
    const double across2 = 1.0 - up * up;
    const double across = across2 > 0.0 ? std::sqrt(across2) : 0.0;
    const double neck = -across * burr.neck_radius_mm - up * burr.neck_radius_mm;
    const double shank = up * burr.neck_length_mm - across * burr.shank_radius_mm;
    double head = -burr.radius_mm;
    if (!tool.ball()) {
      const OnHalf deepest = burr.head.support({-up, across}, {});
      head = up * deepest.t - across * deepest.rho;
    }
    const double lowest = std::min(head, std::min(neck, shank));
    found.c = highest + 0.5 * voxel_mm_ + 0.01 - lowest;
    if (glm::dot(n, pose) - found.c < kLeastFree) return false;
  }
  free_ = found;
  return true;
}

void SurfaceContact::foot(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 device) noexcept {
  // The point under the head in the direction of the push, which no cell's own point need be near.
  const Vec3 push = device - pose;
  const double length = std::sqrt(glm::dot(push, push));
  if (length < 1e-6) return;
  const Vec3 x = pose + (tool.ball() ? push * (tool.burr->radius_mm / length) : head_furthest(*tool.burr, tool.axis, push / length));
  for (const Field field : {Field::base, Field::cut}) {
    FieldPoint at = fields_.at(volume, field, x);
    if (!at.known || at.d_mm > voxel_mm_ || at.d_mm < -voxel_mm_) continue;
    const Vec3 p = x - at.normal * at.d_mm;
    at = fields_.at(volume, field, p);
    if (!at.known || at.d_mm > 0.3 * voxel_mm_ || at.d_mm < -0.3 * voxel_mm_) continue;
    // Beside an edge the field is rounded; points and edges know better.
    if (at.creased && (sharp_ || field == Field::base)) continue;
    Candidate candidate;
    candidate.point = p - at.normal * at.d_mm;
    candidate.normal = at.normal;
    candidate.level = glm::dot(candidate.normal, candidate.point);
    candidate.field = field;
    CutFeature own;
    // Gone where the other field is empty.
    const FieldPoint other = fields_.at(volume, field == Field::base ? Field::cut : Field::base, candidate.point);
    if (other.d_mm > 0.0) continue;
    if (other.known && other.d_mm > -2.5 * voxel_mm_) {
      candidate.others = 1;
      own.other_d_mm = static_cast<float>(other.d_mm);
      own.other_normal = Vec3f(other.normal);
    }
    const Vec3 under = (candidate.point - at.normal * (0.5 * voxel_mm_) - volume.grid().origin_mm) / voxel_mm_;
    candidate.tissue = volume.tissue(cell_of_voxels(under + 0.5));
    add(candidate, &own);
  }
}

bool SurfaceContact::inside_tissue(const Volume& volume, Vec3 pose) const noexcept {
  return volume.s(cell_of_voxels((pose - volume.grid().origin_mm) / voxel_mm_ + 0.5)) >= kHalf;
}

bool SurfaceContact::clear_path(const Volume& volume, const Tool& tool, Vec3 from, Vec3 to) const noexcept {
  const Burr& burr = *tool.burr;
  // Every brick that the burr could sweep is all empty: then the proxy is the device point.
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const Vec3 low_mm = glm::min(from, to);
  const Vec3 high_mm = glm::max(from, to);
  const auto empty = [&](Vec3 a, Vec3 b) {
    const IVec3 low = glm::max(brick_floor(grid, a), IVec3(0));
    const IVec3 high = glm::min(brick_floor(grid, b), specimen.brick_count() - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
          const int brick = specimen.brick_index({x, y, z});
          if (specimen.s_of(brick) != nullptr || specimen.s_in(brick, 0) != 0) return false;
        }
    return true;
  };
  const double wide = head_reach(burr) + 2.0 * grid.voxel_mm;
  if (!empty(low_mm - wide, high_mm + wide)) return false;
  const Vec3 reach = tool.axis * (burr.neck_length_mm + burr.shank_length_mm);
  const double thick = std::max(burr.neck_radius_mm, burr.shank_radius_mm) + 2.0 * grid.voxel_mm;
  return empty(glm::min(low_mm, low_mm + reach) - thick, glm::max(high_mm, high_mm + reach) + thick);
}

}  // namespace cusp
