#include "engine/tool/voxel_tool.h"

#include <algorithm>
#include <cmath>

#include "engine/tool/swept.h"

namespace cusp::engine {

VoxelTool voxelise(const Bur& bur, Vec3 axis, double voxel_mm) {
  VoxelTool out;
  const double r = bur.radius_mm / voxel_mm;
  const auto cuts = [&](Vec3 v) {
    if (bur.head.ball()) return glm::dot(v, v) <= r * r;
    return head_distance(bur, axis, v * voxel_mm) <= 0.0;
  };
  out.reach = static_cast<int>(std::ceil(head_reach(bur) / voxel_mm));
  for (int z = -out.reach; z <= out.reach; ++z)
    for (int y = -out.reach; y <= out.reach; ++y)
      for (int x = -out.reach; x <= out.reach; ++x) {
        const Vec3 v(x, y, z);
        if (cuts(v)) out.cutting.push_back({x, y, z});
      }

  const double neck = bur.neck_length_mm / voxel_mm;
  const double end = neck + bur.shank_length_mm / voxel_mm;
  const auto inside = [&](Vec3 v) {
    const double t = glm::dot(v, axis);
    if (t < 0.0 || t > end) return false;
    const double radius = (t <= neck ? bur.neck_radius_mm : bur.shank_radius_mm) / voxel_mm;
    return glm::dot(v, v) - t * t <= radius * radius;
  };
  const double wide = std::max(bur.neck_radius_mm, bur.shank_radius_mm) / voxel_mm + 1.0;
  const IVec3 low(glm::floor(glm::min(Vec3(0.0), axis * end) - wide));
  const IVec3 high(glm::ceil(glm::max(Vec3(0.0), axis * end) + wide));
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const Vec3 v(x, y, z);
        if (cuts(v) || !inside(v)) continue;
        // The outer layer alone: a voxel that enters the holder crosses it.
        const bool outer = !inside(v + Vec3(1, 0, 0)) || !inside(v - Vec3(1, 0, 0)) || !inside(v + Vec3(0, 1, 0)) ||
                           !inside(v - Vec3(0, 1, 0)) || !inside(v + Vec3(0, 0, 1)) || !inside(v - Vec3(0, 0, 1));
        if (outer) out.holder.push_back({x, y, z});
      }
  return out;
}

}  // namespace cusp::engine
