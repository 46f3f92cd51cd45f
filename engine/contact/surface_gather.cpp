// Candidates of the surface proxy: which points, edges and normals of the two fields may touch within one step.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_near.h"

namespace cusp::engine {

namespace {

// Margin of the candidates, in steps: they serve while the bur stays within it. With 8 steps p99 of exploring is 1.18 of this.
constexpr double kStepsAhead = 5.0, kStepsMeanwhile = 2.0;
constexpr double kLeastMargin = 0.06;  // mm
constexpr double kGoneMm = 1e9;        // where no bur reaches
/// Voxels from an inner edge to where its rounding ends: a cell's field reads one sample beyond it.
constexpr double kRimReach = 1.0;

}  // namespace

/// A candidate that is only made when a search comes near it. x, y, z: voxels from where it is gathered.
inline void SurfaceContact::add_unmade(float x, float y, float z, Source source) noexcept {
  if (count_ == known_.size()) {
    overflow_ = true;
    return;
  }
  place_x_[count_] = x;
  place_y_[count_] = y;
  place_z_[count_] = z;
  known_[count_] = Known::unmade;
  sources_[count_++] = source;
}

/// Pre: it is not made yet.
void SurfaceContact::make(const Volume& volume, const Tool& tool, std::size_t i) noexcept {
  Candidate& out = candidates_[i];
  const Source source = sources_[i];
  const PointList& list = point_lists_[static_cast<std::size_t>(source.list)];
  const Grid& grid = volume.grid();
  Vec3 place;
  CutFeature base;
  const CutFeature* feature = &base;
  if (list.page != nullptr) {
    const CutSurface::Page& page = *list.page;
    place = Vec3(page.x[source.index], page.y[source.index], page.z[source.index]);
    feature = &page.feature[source.index];
  } else {
    const BaseSurface& surface = volume.specimen().surface();
    const BasePoints points = surface.in(list.brick);
    place = Vec3(points.x[source.index], points.y[source.index], points.z[source.index]);
    base_feature(surface, points, source.index, grid.voxel_mm, base);
  }
  out.point = grid.origin_mm + grid.voxel_mm * (Vec3(list.at * kBrickEdge) + place);
  if (source.kind == Kind::shank && sweeps_.size() > 0 && !walls_.move_out(volume, {0, -1}, kMostMovedOut * voxel_mm_, out.point))
    out.point = Vec3(kGoneMm);
  out.normal = Vec3(feature->normal);
  out.level = glm::dot(out.normal, out.point);
  out.kind = source.kind;
  if (out.kind == Kind::inside) out.level = feature->other_d_mm;
  out.field = feature->field;
  out.tissue = feature->tissue;
  out.others = source.kind == Kind::shank ? std::uint8_t{0} : feature->others;
  out.feature = feature;
  known_[i] = out.kind == Kind::edge && tool.ball() ? Known::edge : Known::other;
  if (out.kind == Kind::surface && out.others == 0) {
    out.feature = nullptr;
    known_[i] = out.field == Field::base ? Known::base_face : Known::cut_face;
    faces_[i] = {out.point.x,  out.point.y,  out.point.z, out.normal.x,
                 out.normal.y, out.normal.z, out.level,   tool.bur->radius_mm - tool.thin(out.field)};
  } else if (feature == &base) {
    features_[i] = base;
    out.feature = &features_[i];
  }
}

/// Candidates from a brick, not made yet. near(x, y, z, count, local, has_edges, pass): which places to take, in cells(local, slices);
/// local: the centre in voxels from the brick's corner; has_edges: edges may be among them.
template <class Cells, class Choose>
void SurfaceContact::gather_from(const Volume& volume, const Tool& tool, Vec3 centre, int brick, IVec3 at, ToolPart part,
                                 Cells&& cells, Choose&& near) noexcept {
  const bool cut = volume.has_cut(brick);
  const bool has_edges = cut || boxes_[static_cast<std::size_t>(brick)].edges;
  edges_ = edges_ || has_edges;
  const Vec3f local((centre - brick_corner(volume.grid(), at)) * (1.0 / voxel_mm_));
  const SweptVoid::Known* walls = cut && tool.ball() && part == ToolPart::head ? &walls_.known(volume, brick) : nullptr;
  const BasePoints base_points = cut ? BasePoints{} : volume.specimen().surface().in(brick);
  const auto gather_near = [&](const float* x, const float* y, const float* z, int count, const CutSurface::Page* page) {
    // Candidates lie by rising list, so that lists are at most as many, and one more.
    const std::int32_t list = count_ == 0 ? 0 : sources_[count_ - 1].list + 1;
    point_lists_[static_cast<std::size_t>(list)] = {page, brick, at};
    near(x, y, z, count, local, has_edges, [&](int i) {
      // At an inner edge a head that is no ball has exact places inside, all else the rounded point.
      const bool of_head = !tool.ball() && part == ToolPart::head;
      if (page != nullptr && (of_head ? page->feature[i].inner_edge : page->feature[i].inside)) return;
      // Of these cells a ball has walls and ridges; its neck and shank have points.
      if (walls != nullptr && page != nullptr && (page->feature[i].swept || walls->has(page->feature[i].cell))) return;
      const bool edge = page == nullptr ? has_edges && base_points.normal[i].edge() : page->feature[i].edge;
      const Kind kind = part == ToolPart::shank                       ? Kind::shank
                        : edge                                        ? Kind::edge
                        : page != nullptr && page->feature[i].inside ? Kind::inside
                                                                      : Kind::surface;
      // Up to eight cells have the same voxel inside, and the same plane of it.
      if (kind == Kind::inside) {
        const IVec3 voxel = at * kBrickEdge + IVec3(static_cast<int>(x[i]), static_cast<int>(y[i]), static_cast<int>(z[i]));
        if (!insides_.add(voxel)) return;
      }
      add_unmade(x[i] - local.x, y[i] - local.y, z[i] - local.z, {list, static_cast<std::uint16_t>(i), kind});
    });
  };
  if (!cut) {
    gather_near(base_points.x, base_points.y, base_points.z, base_points.count, nullptr);
    return;
  }
  for (std::int32_t p = cut_.first(volume, brick, [&](unsigned slices) { return cells(local, slices); }); p >= 0; p = cut_.page(p).next) {
    const CutSurface::Page& page = cut_.page(p);
    const std::size_t before = count_;
    gather_near(page.x, page.y, page.z, page.count, &page);
    if (cut_.kept(p)) continue;
    // A page that is not kept serves until the next brick is asked for.
    for (std::size_t i = before; i < count_; ++i) {
      make(volume, tool, i);
      if (candidates_[i].feature == nullptr) continue;
      features_[i] = *candidates_[i].feature;
      candidates_[i].feature = &features_[i];
    }
  }
}

void SurfaceContact::gather_head(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm) noexcept {
  edges_ = false;
  insides_.clear();
  const double per_mm = 1.0 / voxel_mm_;
  // With the shank's cells in the same bricks: what brings a brick's cells up to date moves its pages.
  TwoCylinders shank = shank_within(tool, margin_mm + kMostMovedOut * voxel_mm_).cylinders(tool.axis, voxel_mm_);
  const auto shank_cells = [&shank](Vec3f local, unsigned slices) {
    shank.at = local;
    return CellsNear::cylinders(shank, slices);
  };
  if (!tool.ball()) {
    const double beside_mm = kPlaneReach * voxel_mm_;
    HeadBand band(tool.bur->head, tool.axis, margin_mm, beside_mm, per_mm);
    bricks_within(volume, tool.axis, centre, head_within(tool, margin_mm + beside_mm), [&](int brick, IVec3 at, const TwoCylinders& shape) {
      gather_from(volume, tool, centre, brick, at, ToolPart::head, [&](Vec3f local, unsigned slices) { return CellsNear::cylinders(shape, slices) | shank_cells(local, slices); },
                  [&](const float* x, const float* y, const float* z, int count, Vec3f local, bool, auto&& pass) {
                    band.at = VecLanes(local);
                    for_band(x, y, z, count, band, [&](int i, bool) { pass(i); });
                  });
    });
    return;
  }
  const double reach = tool.bur->radius_mm + margin_mm;
  // An edge holds 0.7 voxel either way along its tangent.
  const double edge_reach = reach + kHalfEdge * voxel_mm_;
  ball_bricks(volume, centre, edge_reach, [&](int brick, IVec3 at, double) {
    gather_from(volume, tool, centre, brick, at, ToolPart::head,
                [&](Vec3f local, unsigned slices) {
                  const CellsNear near = CellsNear::ball(local, static_cast<float>(edge_reach * per_mm + kFloatSlack), slices);
                  return near.without(walls_.known(volume, brick).slice) | shank_cells(local, slices);
                },
                [&](const float* x, const float* y, const float* z, int count, Vec3f local, bool has_edges, auto&& pass) {
                  const double wide = (has_edges ? edge_reach : reach) * per_mm + kFloatSlack;
                  for_near(x, y, z, count, local, static_cast<float>(wide * wide), pass);
                });
  });
}

void SurfaceContact::Reach::layer(const Grid& grid, Vec3 axis, Vec3 centre, int z, IVec3& low, IVec3& high) const noexcept {
  const double slack = kBeyondBrick * grid.voxel_mm, widest = std::max(slim, thick), up = axis.z;
  double t0 = from, t1 = to;
  if (up != 0.0) {
    const double rise = widest * std::sqrt(std::max(0.0, 1.0 - up * up)) + slack;  // of a circle about the axis over its middle
    const double low_end = (brick_corner(grid, {0, 0, z}).z - rise - centre.z) / up, high_end = (brick_corner(grid, {0, 0, z + 1}).z + rise - centre.z) / up;
    t0 = std::clamp(std::min(low_end, high_end), from, to);
    t1 = std::clamp(std::max(low_end, high_end), from, to);
  }
  const Vec3 a = centre + axis * t0, b = centre + axis * t1;
  const double beside = (t1 > wide_from ? widest : slim) + slack;
  low = glm::max(brick_floor(grid, glm::min(a, b) - beside), low);
  high = glm::min(brick_floor(grid, glm::max(a, b) + beside), high);
}

/// Of the neck and the shank. Up to `inner` along the axis the neck lies within a ball, which answers for it.
SurfaceContact::Reach SurfaceContact::shank_within(const Tool& tool, double margin_mm) noexcept {
  const Bur& b = *tool.bur;
  const double inner = b.neck_radius_mm + margin_mm;
  const double r2 = tool.ball() ? b.radius_mm * b.radius_mm - inner * inner : 0.0;
  return {r2 > 0.0 ? std::sqrt(r2) : tool.neck_from(), b.neck_length_mm - margin_mm,
          b.neck_length_mm + b.shank_length_mm + margin_mm, b.neck_radius_mm + margin_mm, b.shank_radius_mm + margin_mm};
}

/// Of a head that is no ball.
SurfaceContact::Reach SurfaceContact::head_within(const Tool& tool, double margin_mm) noexcept {
  const Profile& head = tool.bur->head;
  const double wide = head.widest() + margin_mm;
  return {head.low() - margin_mm, head.low() - margin_mm, head.high() + margin_mm, wide, wide};
}

void SurfaceContact::gather_shank(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm) noexcept {
  const bool edges = edges_;  // an edge of theirs is a point
  bricks_within(volume, tool.axis, centre, shank_within(tool, margin_mm + kMostMovedOut * voxel_mm_), [&](int brick, IVec3 at, const TwoCylinders& shape) {
    const CylinderLanes inside(shape);
    gather_from(volume, tool, centre, brick, at, ToolPart::shank, [&](Vec3f, unsigned slices) { return CellsNear::cylinders(shape, slices); },
                [&](const float* x, const float* y, const float* z, int count, Vec3f, bool, auto&& pass) {
                  for_inside(x, y, z, count, inside, pass);
                });
  });
  edges_ = edges;
}

/// Brings what a search of one step from `centre` may touch to hand: a little more than that, for the next few.
void SurfaceContact::gather(const Volume& volume, const Tool& tool, Vec3 centre, double step, double most_margin_mm) noexcept {
  const Gathered& g = gathered_;
  const Vec3 off = centre - g.centre;
  const double left = g.margin_mm - step;
  if (!(g.valid && g.revision == cut_.revision() && g.carved == walls_.cutting().end && g.bur == tool.index && g.axis == tool.axis && left >= 0.0 &&
        glm::dot(off, off) <= left * left)) {
    // While the bur cuts it serves until the next piece is carved, while edges are found or the axis turns until the next tick.
    const double steps = all_resolved_ && gathered_.axis == tool.axis ? kStepsAhead : kStepsMeanwhile;
    const double margin = step + std::min(most_margin_mm, std::max(kLeastMargin, steps * step));
    count_ = 0;
    gather_head(volume, tool, centre, margin);
    ball_count_ = count_;
    gather_shank(volume, tool, centre, margin);
    shank_count_ = count_ - ball_count_;
    gathered_ = {centre, margin, tool.index, true, tool.axis, cut_.revision(), walls_.cutting().end};
  }
  count_ = ball_count_ + shank_count_;
}

/// True at a rim, which reaches further into an inner edge than the field does.
bool SurfaceContact::near_rim(const Tool& tool, Vec3 from_pivot) const noexcept {
  OnHalf rim;
  return !tool.ball() && tool.bur->head.rim(by_axis(tool.axis, from_pivot).at, kRimReach * voxel_mm_, rim);
}

void SurfaceContact::foot(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 device) noexcept {
  // The point under the head in the direction of the push, which no cell's own point need be near.
  const Vec3 push = device - pose;
  const double length = std::sqrt(glm::dot(push, push));
  if (length < 1e-6) return;
  const Vec3 x = pose + (tool.ball() ? push * (tool.bur->radius_mm / length) : head_furthest(*tool.bur, tool.axis, push / length));
  for (const Field field : {Field::base, Field::cut}) {
    FieldPoint at = fields_.at(volume, field, x);
    if (!at.known || at.d_mm > voxel_mm_ || at.d_mm < -voxel_mm_) continue;
    const Vec3 p = x - at.normal * at.d_mm;
    at = fields_.at(volume, field, p);
    if (!at.known || at.d_mm > 0.3 * voxel_mm_ || at.d_mm < -0.3 * voxel_mm_) continue;
    // Beside an edge the field is rounded; points and edges know better.
    if (at.creased && (all_resolved_ || field == Field::base)) continue;
    if (at.inner_edge && near_rim(tool, x - pose)) continue;
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
    candidate.tissue = tissue_under(volume, candidate.point, at.normal);
    if (count_ == candidates_.size()) {
      overflow_ = true;
      return;
    }
    known_[count_] = Known::other;
    features_[count_] = own;
    candidate.feature = &features_[count_];
    candidates_[count_++] = candidate;
  }
}

}  // namespace cusp::engine
