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
/// Voxels: a cell's point may stand a tenth outside its cell, and the brick's last cells end a voxel beyond it.
inline constexpr double kBeyondBrick = 0.2;

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
  low = corner + voxel_mm_ * (cut ? Vec3(-kBeyondBrick) : box.low());
  high = corner + voxel_mm_ * (cut ? Vec3(kBrickEdge + kBeyondBrick) : box.high());
  return true;
}

/// Calls visit(brick, at, square) for each brick, in index order, with points that may lie within reach of a place: squared
/// distance of the box about them.
template <class Visit>
void SurfaceContact::ball_bricks(const Volume& volume, Vec3 centre, double reach, Visit&& visit) const noexcept {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const double slack = kBeyondBrick * voxel_mm_;
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
  const double thick = std::max(reach.thick, reach.slim), slack = kBeyondBrick * voxel_mm_;
  const Vec3 first = centre + axis * reach.from, last = centre + axis * reach.to;
  const int low_z = std::max(brick_floor(grid, glm::min(first, last) - (thick + slack)).z, bricks_low_.z);
  const int high_z = std::min(brick_floor(grid, glm::max(first, last) + (thick + slack)).z, bricks_high_.z);
  for (int z = low_z; z <= high_z; ++z) {
    IVec3 low = bricks_low_, high = bricks_high_;
    reach.layer(grid, axis, centre, z, low, high);
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
}

}  // namespace cusp::engine
