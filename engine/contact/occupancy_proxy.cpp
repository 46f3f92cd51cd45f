#include "engine/contact/occupancy_proxy.h"

#include <algorithm>
#include <cmath>

namespace cusp {

namespace {
IVec3 voxel_at(const Grid& grid, Vec3 p) noexcept {
  const Vec3 x = (p - grid.origin_mm) / grid.voxel_mm + 0.5;
  return {static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)), static_cast<int>(std::floor(x.z))};
}
constexpr int kMoves = 64;
constexpr double kRayStepMm = 0.1;  // never coarser (paper, from [21]) ...
}  // namespace

OccupancyProxy::OccupancyProxy(const Scene& scene, const Volume& volume, bool pivot_only)
    : occupancy_(volume), pivot_only_(pivot_only) {
  std::size_t most = 0;
  for (const Burr& burr : scene.burrs) {
    tools_.push_back(voxelise(burr, scene.tool_axis, volume.grid().voxel_mm));
    most = std::max(most, tools_.back().cutting.size());
  }
  hit_.resize(most);
  low_ = volume.grid().size;
  high_ = IVec3(-1);
  const Specimen& specimen = volume.specimen();
  const IVec3 n = specimen.brick_count();
  for (int brick = 0; brick < n.x * n.y * n.z; ++brick) {
    const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
    if (specimen.uniform(brick)) {
      if (specimen.s_in(brick, 0) == 0) continue;
      low_ = glm::min(low_, corner);
      high_ = glm::max(high_, corner + (kBrickEdge - 1));
      continue;
    }
    for (int o = 0; o < kBrickVoxels; ++o)
      if (specimen.s_in(brick, o) > 0) {
        const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
        low_ = glm::min(low_, v);
        high_ = glm::max(high_, v);
      }
  }
}

bool OccupancyProxy::free(const VoxelTool& tool, IVec3 pivot) const noexcept {
  if (occupancy_.occupied(pivot)) return false;
  if (pivot_only_) return true;
  for (const IVec3& o : tool.cutting)
    if (occupancy_.occupied(pivot + o)) return false;
  for (const IVec3& o : tool.holder) {
    if (pivot.z + o.z > high_.z) break;  // in order of z: the rest is above all tissue
    if (occupancy_.occupied(pivot + o)) return false;
  }
  return true;
}

OccupancyContact OccupancyProxy::solve(const Volume& volume, const Scene& scene, std::size_t burr, Vec3 from,
                                       Vec3 device) noexcept {
  OccupancyContact out;
  hit_count_ = 0;
  const Grid& grid = volume.grid();
  const VoxelTool& tool = tools_[burr];

  // First stage: the burr's box against the tissue's box, widened by the tool's reach.
  const IVec3 a = voxel_at(grid, glm::min(from, device));
  const IVec3 b = voxel_at(grid, glm::max(from, device));
  const Burr& shape = scene.burrs[burr];
  const Vec3 holder = scene.tool_axis * ((shape.neck_length_mm + shape.shank_length_mm) / grid.voxel_mm);
  const int wide = std::max(tool.reach, static_cast<int>(std::ceil(std::max(shape.shank_radius_mm, shape.neck_radius_mm) / grid.voxel_mm))) + 1;
  const IVec3 reach_low = IVec3(glm::floor(glm::min(holder, Vec3(0.0)))) - wide;
  const IVec3 reach_high = IVec3(glm::ceil(glm::max(holder, Vec3(0.0)))) + wide;
  bool apart = false;
  for (int i = 0; i < 3; ++i) apart = apart || b[i] + reach_high[i] < low_[i] || a[i] + reach_low[i] > high_[i];
  if (apart) {
    out.pose_mm = device;
    return out;
  }

  // Second stage: neighbour by neighbour. Ties go to the lowest neighbour, z slowest.
  IVec3 at = voxel_at(grid, from);
  int moves = 0;
  for (; moves < kMoves; ++moves) {
    const Vec3 gap = grid.centre_mm(at) - device;
    double best = glm::dot(gap, gap);
    IVec3 next = at;
    for (int i = 0; i < 27; ++i) {
      const IVec3 n = at + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const Vec3 d = grid.centre_mm(n) - device;
      const double distance = glm::dot(d, d);
      if (distance < best && free(tool, n)) {
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
      const IVec3 v = voxel_at(grid, p);
      if (v != last) {
        if (!free(tool, v)) {
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
  if (arrived) return out;

  // What would hit one voxel further towards the device point.
  const Vec3 push = device - pose;
  const double most = std::max(std::fabs(push.x), std::max(std::fabs(push.y), std::fabs(push.z)));
  for (int i = 0; i < 3; ++i) out.step[i] = push[i] > 0.5 * most ? 1 : push[i] < -0.5 * most ? -1 : 0;
  const IVec3 pivot = voxel_at(grid, pose) + out.step;
  Vec3 sum(0.0);
  for (const IVec3& o : tool.cutting) {
    if (!occupancy_.occupied(pivot + o)) continue;
    hit_[hit_count_++] = pivot + o;
    sum -= Vec3(o) * grid.voxel_mm;
  }
  out.hits = static_cast<int>(hit_count_);
  if (out.hits > 0) out.mean_offset_mm = sum / static_cast<double>(out.hits);
  if (!pivot_only_)
    for (const IVec3& o : tool.holder) {
      if (pivot.z + o.z > high_.z) break;
      if (occupancy_.occupied(pivot + o)) {
        out.shank = true;
        break;
      }
    }
  return out;
}

bool OccupancyProxy::remove_along(Volume& volume, std::size_t burr, Vec3 from, Vec3 to) noexcept {
  const Grid& grid = volume.grid();
  const Specimen& specimen = volume.specimen();
  const Vec3 way = to - from;
  const int samples = static_cast<int>(std::ceil(std::sqrt(glm::dot(way, way)) / (0.25 * grid.voxel_mm))) + 1;
  bool room = true;
  for (int i = 0; i <= samples; ++i) {
    const IVec3 pivot = voxel_at(grid, from + way * (static_cast<double>(i) / samples));
    for (const IVec3& o : tools_[burr].cutting) {
      const IVec3 v = pivot + o;
      if (!occupancy_.occupied(v)) continue;
      const int brick = specimen.brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
      std::uint16_t* values = volume.cut_for_writing(brick);
      if (values == nullptr) {
        room = false;
        continue;
      }
      values[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = 0;
      occupancy_.vanish(v);
      volume.touched(brick);
    }
  }
  return room;
}

}  // namespace cusp
