/// Places of the surface along a straight line, below a voxel. Not for the haptic thread.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Nearest voxel of a place.
inline IVec3 nearest_voxel(const Grid& grid, Vec3 p) noexcept {
  const Vec3 v = (p - grid.origin_mm) / grid.voxel_mm + 0.5;
  return cell_of_voxels(v);
}

/// Nearest voxels of many places: nearest_voxel() bit for bit, without its divisions.
class NearestVoxel {
 public:
  explicit NearestVoxel(const Grid& grid) noexcept : grid_(grid), per_mm_(1.0 / grid.voxel_mm) {}
  IVec3 of(Vec3 p) const noexcept {
    const Vec3 v = (p - grid_.origin_mm) * per_mm_ + 0.5;
    const IVec3 cell = cell_of_voxels(v);
    // Within a thousand voxels a product is off a quotient by less than a millionth of this.
    constexpr double kDoubtful = 1e-6;
    const Vec3 in = v - Vec3(cell);
    const bool certain = std::min({in.x, in.y, in.z}) > kDoubtful && std::max({in.x, in.y, in.z}) < 1.0 - kDoubtful;
    return certain ? cell : nearest_voxel(grid_, p);
  }

 private:
  const Grid& grid_;
  double per_mm_;
};

/// Whose surface is searched: the specimen's before cutting, or what is left now.
enum class Solid : std::uint8_t { original, remaining };

class SurfaceSearch {
 public:
  SurfaceSearch(const Volume& volume, Solid solid) : volume_(volume), voxels_(volume.grid()), solid_(solid) {}

  bool inside(Vec3 p) const noexcept {
    const IVec3 v = voxels_.of(p);
    return solid_ == Solid::original ? volume_.specimen().s(v) >= kHalf : volume_.occupied(v);
  }
  /// The place of the surface between two places less than two voxels apart, by halving. Pre: not both on one side.
  Vec3 between(Vec3 outside, Vec3 within) noexcept {
    for (int pass = 0; pass < 24; ++pass) {
      const Vec3 middle = 0.5 * (outside + within);
      (distance(middle) < 0.0 ? within : outside) = middle;
    }
    return 0.5 * (outside + within);
  }
  /// Signed distance of the fields: negative inside, a bound beyond their band.
  double distance(Vec3 p) noexcept {
    const double base = cells_.at(volume_, Field::base, p).d_mm;
    return solid_ == Solid::original ? base : std::max(base, cells_.at(volume_, Field::cut, p).d_mm);
  }

 private:

  const Volume& volume_;
  NearestVoxel voxels_;
  Solid solid_;
  FieldCells cells_;
};

}  // namespace cusp::scenarios
