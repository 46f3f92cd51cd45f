#include "engine/removal/wear.h"

#include <array>
#include <cmath>

namespace cusp {

namespace {

/// 98 directions: the integer points of a cube's surface two voxels wide, made unit. Only sqrt: the same everywhere.
struct Directions {
  std::array<Vec3, 98> unit;
  constexpr static int kCount = 98;
  Directions() noexcept {
    std::size_t n = 0;
    for (int z = -2; z <= 2; ++z)
      for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
          const int most = std::max(std::abs(x), std::max(std::abs(y), std::abs(z)));
          if (most != 2) continue;
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
