// Candidates of the surface proxy: which points, edges and normals of the two fields may touch within one step.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_near.h"
#include "engine/tool/swept.h"

namespace cusp {

namespace {

constexpr std::size_t kManyShank = 24;
constexpr int kTightLooks = 16;       // looks for which a crowded shank's margin is kept small
constexpr double kSlowStep = 0.016;   // mm in a tick (16 mm/s): below, candidates are gathered ...
constexpr double kSlowMargin = 0.024; // ... for as long as the burr stays this near; else for two steps

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

void SurfaceContact::gather_shank(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm) noexcept {
  features_within(volume, tool.axis, centre, shank_within(tool, margin_mm), [&](Vec3 point, const CutFeature& f) {
    Candidate candidate;
    candidate.point = point;
    candidate.normal = Vec3(f.normal);
    candidate.kind = Kind::shank;
    candidate.field = f.field;
    candidate.tissue = f.tissue;
    add(candidate, nullptr);
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
  shank_tight_ = shank_count_ > kManyShank ? kTightLooks : shank_tight_ > 0 ? shank_tight_ - 1 : 0;
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

}  // namespace cusp
