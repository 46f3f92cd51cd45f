#include "scenarios/metrics/width.h"

#include <cmath>

#include "scenarios/metrics/surface_search.h"

namespace cusp::scenarios {

namespace {

/// Wider than any crown: nothing faces the wall.
constexpr double kWidestMm = 15.0;

/// Distance from a wall level into the void to the next tissue, at most `at_most`; nullopt beyond.
std::optional<double> across(SurfaceSearch& search, const Grid& grid, Vec3 from, Vec3 into, double at_most) {
  const double step = 0.5 * grid.voxel_mm;
  if (!search.inside(from - grid.voxel_mm * into)) return std::nullopt;  // no tissue behind it: no wall
  // The first voxel and a half belong to the wall itself.
  for (double mm = 1.5 * grid.voxel_mm; mm <= at_most + step; mm += step) {
    const Vec3 p = from + mm * into;
    if (!grid.contains(nearest_voxel(grid, p))) return std::nullopt;
    if (!search.inside(p)) continue;
    // The voxel's centre is inside, the place itself may be half a voxel before the surface.
    const Vec3 surface = search.between(p - grid.voxel_mm * into, p + grid.voxel_mm * into);
    return std::sqrt(glm::dot(surface - from, surface - from));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Isthmus> isthmus(const CutFaces& faces, const Volume& volume, double point_sigma_mm) {
  SurfaceSearch search(volume, Solid::remaining);
  std::optional<Isthmus> best;
  double least = kWidestMm;
  for (const FaceName wall : {FaceName::mesial_wall, FaceName::distal_wall, FaceName::buccal_wall, FaceName::lingual_wall,
                              FaceName::side_wall})
    for (const CutFace& face : faces.of(wall)) {
      const Vec3 level(face.normal.x, face.normal.y, 0.0);
      const double length = std::sqrt(glm::dot(level, level));
      if (!(length > 0.0)) continue;
      const Vec3 into = level / length;
      const auto mm = across(search, volume.grid(), face.middle_mm, into, least);
      if (!mm || *mm >= least) continue;
      least = *mm;
      best = Isthmus{*mm, std::sqrt(2.0) * point_sigma_mm, face.middle_mm, face.middle_mm + *mm * into};
    }
  return best;
}

}  // namespace cusp::scenarios
