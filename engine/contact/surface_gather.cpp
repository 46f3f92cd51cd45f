// Candidates of the surface proxy: which points, edges and normals of the two fields may touch within one step.
#include <algorithm>
#include <cmath>

#include "engine/contact/surface_contact.h"

namespace cusp {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

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
  const Vec3 x = (p - grid.origin_mm) / (grid.voxel_mm * kBrickEdge);
  return {static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)), static_cast<int>(std::floor(x.z))};
}

}  // namespace

bool SurfaceContact::add(const Candidate& candidate) noexcept {
  if (count_ == candidates_.size()) {
    overflow_ = true;
    return false;
  }
  candidates_[count_++] = candidate;
  return true;
}

bool SurfaceContact::base_candidate(const Volume& volume, int brick, IVec3 cell, const BasePoint& point,
                                    Candidate& out) noexcept {
  const Grid& grid = volume.grid();
  out = Candidate{};
  out.point = grid.origin_mm + grid.voxel_mm * (Vec3(cell) + Vec3(point.offset));
  out.normal = Vec3(point.normal);
  out.kind = Kind::surface;
  out.field = Field::base;
  out.tissue = point.tissue;
  // Where the cut is near, the point may be gone, or its plane end at the cut's edge.
  const IVec3 v = cell + IVec3(point.offset.x > 0.5f, point.offset.y > 0.5f, point.offset.z > 0.5f);
  const bool same_brick = (v.x >> 3) == (cell.x >> 3) && (v.y >> 3) == (cell.y >> 3) && (v.z >> 3) == (cell.z >> 3);
  if (same_brick && !volume.has_cut(brick)) return true;
  const std::uint16_t s = volume.cut(v);
  if (s == kSolid) return true;
  if (distance_from_solid(s) > 1.0) return false;
  CellField cut;
  cut.load(volume, Field::cut, cell);
  Vec3 g;
  const double d = cut.eval(Vec3(point.offset), g);
  if (d > 0.0) return false;
  const double length = length_of(g);
  if (d > -2.5 && length > 0.25) {
    out.near_other = true;
    out.other_d_mm = d * grid.voxel_mm / length;
    out.other_normal = g / length;
  }
  return true;
}

void SurfaceContact::gather_ball_brick(const Volume& volume, int brick, Vec3 centre, double reach) noexcept {
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  const double reach2 = reach * reach;
  Candidate candidate;
  for (const BasePoint& point : volume.specimen().surface().in(brick)) {
    const IVec3 cell = corner + IVec3(point.cell & 7, point.cell >> 3 & 7, point.cell >> 6);
    const Vec3 d = grid.origin_mm + grid.voxel_mm * (Vec3(cell) + Vec3(point.offset)) - centre;
    if (glm::dot(d, d) > reach2) continue;
    if (base_candidate(volume, brick, cell, point, candidate)) add(candidate);
  }
  const std::uint16_t* values = volume.cut_of(brick);
  if (values == nullptr) return;
  // Cells whose middle is further than reach and half a cell's diagonal hold nothing.
  const double far = reach + 1.2 * grid.voxel_mm;
  const double far2 = far * far;
  const Vec3 local = (centre - grid.centre_mm(corner)) / grid.voxel_mm - 0.5;
  const double far_v2 = far2 / (grid.voxel_mm * grid.voxel_mm);
  for (int z = 0; z < 8; ++z) {
    const double dz = z - local.z;
    if (dz * dz > far_v2) continue;
    for (int y = 0; y < 8; ++y) {
      const double dy = y - local.y;
      const double dyz = dz * dz + dy * dy;
      if (dyz > far_v2) continue;
      for (int x = 0; x < 8; ++x) {
        const int o = brick_offset(x, y, z);
        if (values[o] < 11000 || values[o] > 54500) continue;
        const double dx = x - local.x;
        if (dyz + dx * dx > far_v2) continue;
        const CutFeature* f = cut_.at(volume, brick, o);
        if (f == nullptr) continue;
        const Vec3 base(corner + IVec3(x, y, z));
        if (f->has_point) {
          candidate = Candidate{};
          candidate.point = grid.origin_mm + grid.voxel_mm * (base + Vec3(f->point));
          const Vec3 d = candidate.point - centre;
          if (glm::dot(d, d) <= reach2) {
            candidate.normal = Vec3(f->normal);
            candidate.field = Field::cut;
            candidate.tissue = f->tissue;
            candidate.near_other = f->near_other;
            candidate.other_normal = Vec3(f->other_normal);
            candidate.other_d_mm = f->other_d_mm;
            add(candidate);
          }
        }
        if (f->has_edge) {
          candidate = Candidate{};
          candidate.kind = Kind::edge;
          candidate.point = grid.origin_mm + grid.voxel_mm * (base + Vec3(f->edge));
          candidate.normal = Vec3(f->tangent);
          candidate.field = Field::cut;
          candidate.tissue = f->tissue;
          const Vec3 d = candidate.point - centre;
          if (glm::dot(d, d) <= far2) add(candidate);
        }
      }
    }
  }
}

void SurfaceContact::gather_shank_brick(const Volume& volume, int brick, const Burr& burr, Vec3 axis, Vec3 centre,
                                        double reach) noexcept {
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  // Up to here the neck lies within the ball, which answers for it.
  const double inner = burr.neck_radius_mm + reach;
  const double r2 = burr.radius_mm * burr.radius_mm - inner * inner;
  const double from = r2 > 0.0 ? std::sqrt(r2) : 0.0;
  const auto touches = [&](Vec3 p) {
    const Vec3 d = p - centre;
    const double t = glm::dot(d, axis);
    if (t < from || t > burr.neck_length_mm + burr.shank_length_mm + reach) return false;
    const double off2 = glm::dot(d, d) - t * t;
    const double wide = (t > burr.neck_length_mm - reach ? burr.shank_radius_mm : burr.neck_radius_mm) + reach;
    return off2 <= wide * wide;
  };
  Candidate candidate;
  for (const BasePoint& point : volume.specimen().surface().in(brick)) {
    const IVec3 cell = corner + IVec3(point.cell & 7, point.cell >> 3 & 7, point.cell >> 6);
    if (!touches(grid.origin_mm + grid.voxel_mm * (Vec3(cell) + Vec3(point.offset)))) continue;
    if (!base_candidate(volume, brick, cell, point, candidate)) continue;
    candidate.kind = Kind::shank;
    add(candidate);
  }
  const std::uint16_t* values = volume.cut_of(brick);
  if (values == nullptr) return;
  for (int o = 0; o < kBrickVoxels; ++o) {
    if (values[o] < 11000 || values[o] > 54500) continue;
    const IVec3 cell = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
    if (!touches(grid.centre_mm(cell) + 0.5 * grid.voxel_mm)) continue;
    const CutFeature* f = cut_.at(volume, brick, o);
    if (f == nullptr) continue;
    candidate = Candidate{};
    candidate.kind = Kind::shank;
    candidate.field = Field::cut;
    candidate.tissue = f->tissue;
    candidate.point = grid.origin_mm + grid.voxel_mm * (Vec3(cell) + Vec3(f->has_point ? f->point : f->edge));
    if (touches(candidate.point)) add(candidate);
  }
}

void SurfaceContact::gather(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 centre, double ball_reach,
                            double shank_reach, bool with_shank) noexcept {
  count_ = 0;
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const double edge = grid.voxel_mm * kBrickEdge;
  const auto used = [&](int brick) { return specimen.s_of(brick) != nullptr || volume.has_cut(brick); };
  {
    const double wide = ball_reach + grid.voxel_mm * 1.2;
    const IVec3 low = glm::max(brick_floor(grid, centre - wide), IVec3(0));
    const IVec3 high = glm::min(brick_floor(grid, centre + wide), specimen.brick_count() - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
          const int brick = specimen.brick_index({x, y, z});
          if (!used(brick)) continue;
          const Vec3 corner = grid.origin_mm + edge * Vec3(x, y, z);
          if (box_distance2(centre, corner, corner + edge) > wide * wide) continue;
          gather_ball_brick(volume, brick, centre, ball_reach);
        }
  }
  if (!with_shank) return;
  const Vec3 top = centre + axis * (burr.neck_length_mm + burr.shank_length_mm);
  const double wide = std::max(burr.neck_radius_mm, burr.shank_radius_mm) + shank_reach + grid.voxel_mm;
  const IVec3 low = glm::max(brick_floor(grid, glm::min(centre, top) - wide), IVec3(0));
  const IVec3 high = glm::min(brick_floor(grid, glm::max(centre, top) + wide), specimen.brick_count() - 1);
  const double half_diagonal = 0.8661 * edge;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const int brick = specimen.brick_index({x, y, z});
        if (!used(brick)) continue;
        const Vec3 middle = grid.origin_mm + edge * (Vec3(x, y, z) + 0.5) - centre;
        const double t = glm::dot(middle, axis);
        if (t < -half_diagonal) continue;
        const double radius = t + half_diagonal > burr.neck_length_mm - shank_reach ? wide
                              : burr.neck_radius_mm + shank_reach + grid.voxel_mm;
        const double off = radius + half_diagonal;
        if (glm::dot(middle, middle) - t * t > off * off) continue;
        gather_shank_brick(volume, brick, burr, axis, centre, shank_reach);
      }
}

void SurfaceContact::foot(const Volume& volume, Vec3 pose, Vec3 device, double radius) noexcept {
  // The point under the ball in the direction of the push, which no cell's own point need be near.
  const Vec3 push = device - pose;
  const double length = length_of(push);
  if (length < 1e-6) return;
  Vec3 x = pose + push * (radius / length);
  for (const Field field : {Field::base, Field::cut}) {
    FieldPoint at = field_at(volume, field, x);
    if (!at.known || at.d_mm > voxel_mm_ || at.d_mm < -voxel_mm_) continue;
    const Vec3 p = x - at.normal * at.d_mm;
    at = field_at(volume, field, p);
    if (!at.known || at.d_mm > 0.3 * voxel_mm_ || at.d_mm < -0.3 * voxel_mm_) continue;
    Candidate candidate;
    candidate.point = p - at.normal * at.d_mm;
    candidate.normal = at.normal;
    candidate.field = field;
    // Gone where the other field is empty.
    const FieldPoint other = field_at(volume, field == Field::base ? Field::cut : Field::base, candidate.point);
    if (other.d_mm > 0.0) continue;
    if (other.known && other.d_mm > -2.5 * voxel_mm_) {
      candidate.near_other = true;
      candidate.other_d_mm = other.d_mm;
      candidate.other_normal = other.normal;
    }
    const Vec3 under = (candidate.point - at.normal * (0.5 * voxel_mm_) - volume.grid().origin_mm) / voxel_mm_;
    candidate.tissue = volume.tissue({static_cast<int>(std::floor(under.x + 0.5)),
                                      static_cast<int>(std::floor(under.y + 0.5)),
                                      static_cast<int>(std::floor(under.z + 0.5))});
    add(candidate);
  }
}

bool SurfaceContact::clear_path(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 from, Vec3 to) const noexcept {
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
  const double wide = burr.radius_mm + 2.0 * grid.voxel_mm;
  if (!empty(low_mm - wide, high_mm + wide)) return false;
  const Vec3 reach = axis * (burr.neck_length_mm + burr.shank_length_mm);
  const double thick = std::max(burr.neck_radius_mm, burr.shank_radius_mm) + 2.0 * grid.voxel_mm;
  return empty(glm::min(low_mm, low_mm + reach) - thick, glm::max(high_mm, high_mm + reach) + thick);
}

}  // namespace cusp
