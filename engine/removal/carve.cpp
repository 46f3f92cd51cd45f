#include "engine/removal/carve.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine {

Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm, CarvePart part) noexcept {
  Carved out;
  const Grid& grid = volume.grid();
  const Specimen& specimen = volume.specimen();
  const double voxel = grid.voxel_mm;
  // All in voxels from here on.
  const Vec3 p = (a - grid.origin_mm) / voxel;
  const Vec3 q = (b - grid.origin_mm) / voxel;
  const double r = radius_mm / voxel;
  const double far = r + kBandVoxels;
  const IVec3 low = glm::max(IVec3(glm::floor(glm::min(p, q) - far)), IVec3(0));
  const IVec3 high = glm::min(IVec3(glm::ceil(glm::max(p, q) + far)), grid.size - 1);
  const Vec3 along = q - p;
  const double square = glm::dot(along, along);
  const double inverse = square > 1e-24 ? 1.0 / square : 0.0;
  const double far2 = far * far;
  const double near_r = r > kBandVoxels ? r - kBandVoxels : 0.0;
  const double near2 = near_r * near_r;

  int walked = 0;
  for (int bz = low.z >> 3; bz <= high.z >> 3; ++bz)
    for (int by = low.y >> 3; by <= high.y >> 3; ++by)
      for (int bx = low.x >> 3; bx <= high.x >> 3; ++bx) {
        if (walked++ < part.first) continue;
        if (out.bricks == part.most) {
          out.next = walked - 1;
          return out;
        }
        const int brick = specimen.brick_index({bx, by, bz});
        if (brick < 0 || !volume.cuttable(brick)) continue;
        const IVec3 corner = IVec3(bx, by, bz) * kBrickEdge;
        // The whole brick is out of reach: its middle is further than its half diagonal beyond the band.
        const Vec3 middle = Vec3(corner) + 3.5;
        double tm = glm::dot(middle - p, along) * inverse;
        tm = tm < 0.0 ? 0.0 : tm > 1.0 ? 1.0 : tm;
        const Vec3 dm = middle - (p + along * tm);
        const double reach = far + 6.07;
        if (glm::dot(dm, dm) > reach * reach) continue;

        const IVec3 from = glm::max(low - corner, IVec3(0));
        const IVec3 to = glm::min(high - corner, IVec3(7));
        std::uint16_t* values = nullptr;
        bool changed = false;
        Carved::Box box;
        for (int z = from.z; z <= to.z; ++z)
          for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
              const Vec3 v = Vec3(corner + IVec3(x, y, z)) - p;
              double t = glm::dot(v, along) * inverse;
              t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
              const Vec3 d = v - along * t;
              const double d2 = glm::dot(d, d);
              if (d2 >= far2) continue;
              const std::uint16_t s = d2 <= near2 ? std::uint16_t{0} : solid_from_distance(r - std::sqrt(d2));
              if (s == kSolid) continue;
              const int o = brick_offset(x, y, z);
              if (values == nullptr) {
                values = volume.cut_for_writing(brick);
                if (values == nullptr) {
                  out.overflow = true;
                  goto next;
                }
              }
              if (s < values[o]) {
                values[o] = s;
                const IVec3 at = corner + IVec3(x, y, z);
                box.low = changed ? glm::min(box.low, at) : at;
                box.high = changed ? glm::max(box.high, at) : at;
                changed = true;
              }
            }
      next:
        if (!changed) continue;
        volume.touched(brick);
        out.low = out.any ? glm::min(out.low, box.low) : box.low;
        out.high = out.any ? glm::max(out.high, box.high) : box.high;
        out.any = true;
        if (out.bricks < Carved::kBoxes) out.box[out.bricks] = box;
        ++out.bricks;
      }
  return out;
}

}  // namespace cusp::engine
