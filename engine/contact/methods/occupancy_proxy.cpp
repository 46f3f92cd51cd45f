#include "engine/contact/methods/occupancy_proxy.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine {

namespace {
constexpr int kMoves = 64;
constexpr double kRayStepMm = 0.1;  // never coarser (paper, from [21]), nor than a quarter voxel
}  // namespace

VoxelContact OccupancyProxy::solve(const Grid& grid, std::size_t bur, Vec3 from, Vec3 device) const noexcept {
  VoxelContact out;
  // Second stage: neighbour by neighbour. Ties go to the lowest neighbour, z slowest.
  IVec3 at = ToolOverlap::voxel_at(grid, from);
  int moves = 0;
  for (; moves < kMoves; ++moves) {
    const Vec3 gap = grid.centre_mm(at) - device;
    double best = glm::dot(gap, gap);
    IVec3 next = at;
    for (int i = 0; i < 27; ++i) {
      const IVec3 n = at + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const Vec3 d = grid.centre_mm(n) - device;
      const double distance = glm::dot(d, d);
      if (distance < best && overlap_.free(bur, n)) {
        best = distance;
        next = n;
      }
    }
    if (next == at) break;
    at = next;
  }
  out.deferred = moves == kMoves;

  // Third stage: along the ray to the last free point.
  Vec3 pose = grid.centre_mm(at);
  const Vec3 ray = device - pose;
  const double length = std::sqrt(glm::dot(ray, ray));
  const double coarse = std::min(kRayStepMm, 0.25 * grid.voxel_mm);
  bool arrived = true;
  if (length > 1e-12) {
    const int samples = static_cast<int>(std::ceil(length / coarse));
    IVec3 last = at;
    for (int i = 1; i <= samples; ++i) {
      const Vec3 p = grid.centre_mm(at) + ray * (static_cast<double>(i) / samples);
      const IVec3 v = ToolOverlap::voxel_at(grid, p);
      if (v != last) {
        if (!overlap_.free(bur, v)) {
          arrived = false;
          break;
        }
        last = v;
      }
      pose = p;
    }
    if (arrived) pose = device;
  }
  out.pose_mm = pose;
  out.touching = !arrived;
  return out;
}

}  // namespace cusp::engine
