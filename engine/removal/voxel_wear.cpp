#include "engine/removal/voxel_wear.h"

#include <cmath>

namespace cusp::engine {

VoxelWear wear_voxels(Volume& volume, Occupancy& occupancy, const Scene& scene, std::span<const IVec3> hit, IVec3 step,
                      double alpha, double dt_s, std::array<double, kTissueCodes>& remainder) noexcept {
  VoxelWear out;
  const Specimen& specimen = volume.specimen();
  std::array<int, kTissueCodes> count{};
  for (const IVec3& v : hit) ++count[index_of(specimen.tissue(v))];
  const Vec3 way(step);
  const double diagonal = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    if (count[t] == 0) continue;
    const double speed = scene.tissues[t].speed_mm_s;
    const double quanta = 65535.0 * alpha * speed * dt_s / (volume.grid().voxel_mm * diagonal) + remainder[t];
    const auto whole = static_cast<std::int64_t>(std::floor(quanta));
    remainder[t] = quanta - static_cast<double>(whole);
    if (whole <= 0) continue;
    for (const IVec3& v : hit) {
      if (index_of(specimen.tissue(v)) != t) continue;
      const int brick = specimen.brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
      std::uint16_t* values = volume.cut_for_writing(brick);
      if (values == nullptr) {
        out.overflow = true;
        continue;
      }
      std::uint16_t& s = values[brick_offset(v.x & 7, v.y & 7, v.z & 7)];
      s = s > whole ? static_cast<std::uint16_t>(s - whole) : std::uint16_t{0};
      if (s == 0) {
        occupancy.vanish(v);
        volume.touched(brick);
        out.low = out.gone ? glm::min(out.low, v) : v;
        out.high = out.gone ? glm::max(out.high, v) : v;
        out.gone = true;
      }
      out.any = true;
    }
  }
  return out;
}

}  // namespace cusp::engine
