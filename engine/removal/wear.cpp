#include "engine/removal/wear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace cusp {

namespace {

/// 152 directions: the points of a cube's surface with odd coordinates up to 5, made unit. None lies on a plane of the
/// grid, so that a seam there is shared evenly. Only sqrt: the same everywhere.
struct Directions {
  std::array<Vec3, 152> unit;
  Directions() noexcept {
    std::size_t n = 0;
    for (int z = -5; z <= 5; z += 2)
      for (int y = -5; y <= 5; y += 2)
        for (int x = -5; x <= 5; x += 2) {
          const int most = std::max(std::abs(x), std::max(std::abs(y), std::abs(z)));
          if (most != 5) continue;
          const Vec3 v(x, y, z);
          unit[n++] = v / std::sqrt(glm::dot(v, v));
        }
  }
};
const Directions kDirections;

}  // namespace

double front_speed(const Volume& volume, const Scene& scene, Vec3 pose_mm, double radius_mm, Vec3 direction,
                   double fallback_mm_s) noexcept {
  const Grid& grid = volume.grid();
  double weight = 0.0;
  double time = 0.0;
  for (const Vec3& u : kDirections.unit) {
    const double w = glm::dot(u, direction);
    if (w <= 0.0) continue;
    const Vec3 x = (pose_mm + u * radius_mm - grid.origin_mm) / grid.voxel_mm + 0.5;
    const IVec3 v(static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)),
                  static_cast<int>(std::floor(x.z)));
    // The front itself stands at s = 1/2: a quarter voxel of band either way counts as met.
    if (volume.s(v) < 26000) continue;
    const double speed = scene.tissues[index_of(volume.tissue(v))].speed_mm_s;
    if (!(speed > 0.0)) return 0.0;
    weight += w;
    time += w / speed;
  }
  return weight > 0.0 ? weight / time : fallback_mm_s;
}

}  // namespace cusp
