/// The dense form of a specimen: generators and importers make it, files hold it, Specimen::build() reads it.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "engine/volume/tissue.h"

namespace cusp::engine {

/// A regular grid of cubic voxels in the specimen frame. Voxel (i,j,k) is a cube about centre_mm(i,j,k).
struct Grid {
  IVec3 size{0};          // voxels along x, y, z
  double voxel_mm = 0.1;  // edge of a voxel
  Vec3 origin_mm{0.0};    // centre of voxel (0,0,0)

  Vec3 centre_mm(IVec3 v) const noexcept { return origin_mm + voxel_mm * Vec3(v); }
  std::size_t voxels() const noexcept {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  }
  /// Position in [z][y][x] arrays, x fastest. Pre: contains(v).
  std::size_t index(IVec3 v) const noexcept {
    return static_cast<std::size_t>(v.x) +
           static_cast<std::size_t>(size.x) *
               (static_cast<std::size_t>(v.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(v.z));
  }
  bool contains(IVec3 v) const noexcept {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < size.x && v.y < size.y && v.z < size.z;
  }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Half width of the distance band, in voxels. No sample that a central difference at the surface reads is clamped, so
/// a plane is exact. 1.5 would give 0.7 degrees on a sphere.
inline constexpr double kBandVoxels = 2.75;
inline constexpr std::uint16_t kSolid = 65535;
/// Occupied while s >= kHalf (banded) or s > 0 (filled).
inline constexpr std::uint16_t kHalf = 32768;

/// Solid fraction of a signed distance (negative inside, in voxels): s = clamp(1/2 - d / 2w) in 1/65535.
inline std::uint16_t solid_from_distance(double d_voxels) noexcept {
  const double s = 0.5 - d_voxels / (2.0 * kBandVoxels);
  if (!(s > 0.0)) return 0;
  if (s >= 1.0) return kSolid;
  return static_cast<std::uint16_t>(s * 65535.0 + 0.5);
}
/// Signed distance in voxels, negative inside. At kBandVoxels either way it is a bound.
inline double distance_from_solid(std::uint16_t s) noexcept {
  return kBandVoxels - static_cast<double>(s) * (2.0 * kBandVoxels / 65535.0);
}

/// Dense specimen. tissue[z][y][x] is set wherever s > 0, in the outer half of the band to the nearest tissue;
/// elsewhere it is empty. s is the solid fraction in 1/65535; the surface is s = 1/2. The outermost four voxels on
/// every side are empty (generators pad by 4), unless a specimen fills its box.
struct VoxelVolume {
  Grid grid;
  std::vector<Tissue> tissue;
  std::vector<std::uint16_t> s;
  std::map<std::uint8_t, std::string> names;  // of the scenario's own tissues (codes from 16)

  explicit VoxelVolume(const Grid& g = {})
      : grid(g), tissue(g.voxels(), Tissue::empty), s(g.voxels(), 0) {}
};

}  // namespace cusp::engine
