/// Which bricks' points lie near a ball, a head, a neck and a shank: walks that gathering and free space share. Only
/// surface_*.cpp include this.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/contact/features/head_band.h"
#include "engine/contact/features/near_points.h"
#include "engine/contact/surface_contact.h"

namespace cusp::engine {

/// Voxels that single precision may be off by in `for_near`, and then some.
inline constexpr double kFloatSlack = 1e-3;

/// Squared distance of a point to a box.
inline double box_distance2(Vec3 p, Vec3 low, Vec3 high) noexcept {
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double d = p[a] < low[a] ? low[a] - p[a] : p[a] > high[a] ? p[a] - high[a] : 0.0;
    sum += d * d;
  }
  return sum;
}

inline IVec3 brick_floor(const Grid& grid, Vec3 p) noexcept {
  return cell_of_voxels((p - grid.origin_mm) * (1.0 / (grid.voxel_mm * kBrickEdge)));
}

/// Place of a brick's first voxel, mm.
inline Vec3 brick_corner(const Grid& grid, IVec3 at) noexcept { return grid.origin_mm + grid.voxel_mm * Vec3(at * kBrickEdge); }

inline TwoCylinders SurfaceContact::Reach::cylinders(Vec3 axis, double voxel_mm) const noexcept {
  const double per_mm = 1.0 / voxel_mm;
  TwoCylinders out;
  out.axis = Vec3f(axis);
  const double narrow = slim * per_mm + kFloatSlack, wide = thick * per_mm + kFloatSlack;
  out.narrow2 = static_cast<float>(narrow * narrow);
  out.wide2 = static_cast<float>(wide * wide);
  out.from = static_cast<float>(from * per_mm - kFloatSlack);
  out.wide_from = static_cast<float>(wide_from * per_mm - kFloatSlack);
  out.to = static_cast<float>(to * per_mm + kFloatSlack);
  return out;
}

/// Calls look(x, y, z, count, feature) with the places of a brick's points and edges, in voxels from its first voxel, in cell
/// order; feature(i): what place i is. Of a brick that was cut at least those of cells().
template <class Cells, class Look>
void SurfaceContact::features(const Volume& volume, int brick, Cells&& cells, Look&& look) noexcept {
  if (!volume.has_cut(brick)) {
    const BasePoints points = volume.specimen().surface().in(brick);
    look(points.x, points.y, points.z, points.count, [&](int i) {
      CutFeature feature;
      base_feature(volume.specimen().surface(), points, i, voxel_mm_, feature);
      return feature;
    });
    return;
  }
  for (std::int32_t p = cut_.first(volume, brick, cells); p >= 0; p = cut_.page(p).next) {
    const CutSurface::Page& page = cut_.page(p);
    look(page.x, page.y, page.z, page.count, [&](int i) -> const CutFeature& { return page.feature[i]; });
  }
}

/// The box (mm) about the points of a brick; false where it has none. A brick that was cut fills its own.
inline bool SurfaceContact::points_box(const Volume& volume, int brick, IVec3 at, Vec3& low, Vec3& high) const noexcept {
  const PointsBox& box = boxes_[static_cast<std::size_t>(brick)];
  const bool cut = volume.has_cut(brick);
  if (!cut && box.empty()) return false;
  const Vec3 corner = brick_corner(volume.grid(), at);
  low = corner + voxel_mm_ * (cut ? Vec3(-0.2) : box.low());
  high = corner + voxel_mm_ * (cut ? Vec3(8.2) : box.high());
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
        if (zy2 + off2(0, x) > reach2) continue;
        Vec3 a, b;
        if (!points_box(volume, brick, {x, y, z}, a, b)) continue;
        const double square = box_distance2(centre, a, b);
        if (square <= reach2) visit(brick, IVec3(x, y, z), square);
      }
    }
  }
}

/// Calls visit(brick, at, cylinders) for each brick, in index order, whose surface may lie in two cylinders about an axis;
/// cylinders: the same in voxels from the brick's first voxel.
template <class Visit>
void SurfaceContact::bricks_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach,
                                   Visit&& visit) const noexcept {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  TwoCylinders shape = reach.cylinders(axis, voxel_mm_);
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
        Vec3 a, b;
        if (!points_box(volume, row + x, {x, y, z}, a, b)) continue;
        const Vec3 middle = 0.5 * (a + b) - centre, half = 0.5 * (b - a);
        const double t = glm::dot(middle, axis);
        const double along = half.x * std::fabs(axis.x) + half.y * std::fabs(axis.y) + half.z * std::fabs(axis.z);
        if (t + along < reach.from || t - along > reach.to) continue;
        const double wide = t + along > reach.wide_from ? thick : reach.slim;
        const double far = wide + std::sqrt(glm::dot(half, half));
        if (glm::dot(middle, middle) - t * t > far * far) continue;
        shape.at = Vec3f((centre - brick_corner(grid, {x, y, z})) * (1.0 / voxel_mm_));
        visit(row + x, IVec3(x, y, z), shape);
      }
    }
}

}  // namespace cusp::engine
