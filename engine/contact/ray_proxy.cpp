#include "engine/contact/ray_proxy.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cusp {

namespace {

constexpr double kStepVoxels = 0.25;   // of the ray
constexpr int kHalvings = 5;           // then the collision is known to 1/128 voxel
constexpr double kSlideVoxels = 0.5;   // one step of the path
constexpr int kSlides = 32;            // of one tick: 16 voxels of path
constexpr int kLifts = 8;              // quarter voxels: over what stands two voxels high
constexpr double kDropVoxels = 2.5;    // back to the surface after a step: what a lift may have gone up, and a little
constexpr double kRestVoxels = 1.0 / 64;
/// Voxels whose mean gives the normal lie up to this far from the burr: fewer make the normal step with the voxels, more
/// round every corner. Measured, face and sphere R 4, r 0.25, 10/128 mm: see the room's README.
constexpr double kNearVoxels = 2.5;

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// Sum of the positions of a byte's set bits.
constexpr std::array<std::uint8_t, 256> kPositions = [] {
  std::array<std::uint8_t, 256> out{};
  for (unsigned b = 0; b < 256; ++b)
    for (unsigned i = 0; i < 8; ++i)
      if (b >> i & 1u) out[b] = static_cast<std::uint8_t>(out[b] + i);
  return out;
}();

}  // namespace

RayProxy::RayProxy(const Scene& scene, const Volume& volume) : overlap_(scene, volume, false) {
  for (const Burr& burr : scene.burrs) {
    const double r = burr.radius_mm / volume.grid().voxel_mm + kNearVoxels;
    const int reach = static_cast<int>(std::ceil(r));
    std::vector<Row> rows;
    for (int z = -reach; z <= reach; ++z)
      for (int y = -reach; y <= reach; ++y) {
        int x = -1;
        while ((x + 1) * (x + 1) + y * y + z * z <= r * r) ++x;
        if (x >= 0) rows.push_back({z, y, -x, x});
      }
    near_.push_back(std::move(rows));
  }
}

bool RayProxy::normal(std::size_t burr, IVec3 pivot, Vec3& n) const noexcept {
  const Occupancy& occupancy = overlap_.occupancy();
  int count = 0;
  IVec3 sum(0);
  for (const Row& row : near_[burr]) {
    const int z = pivot.z + row.z;
    const int y = pivot.y + row.y;
    const int x1 = pivot.x + row.x1;
    for (int x = pivot.x + row.x0; x <= x1; x = (x | 7) + 1) {
      unsigned bits = 0xffu << (x & 7);
      if ((x | 7) > x1) bits &= 0xffu >> (7 - (x1 & 7));
      bits &= occupancy.row({x, y, z});
      if (bits == 0) continue;
      const int here = std::popcount(bits);
      count += here;
      sum.x += kPositions[bits & 0xffu] + ((x & ~7) - pivot.x) * here;
      sum.y += row.y * here;
      sum.z += row.z * here;
    }
  }
  const double length = length_of(Vec3(sum));
  if (count == 0 || length < 0.05 * count) return false;  // nothing there, or alike on all sides
  n = Vec3(sum) / -length;
  return true;
}

bool RayProxy::walk(const Grid& grid, std::size_t burr, At& at, Vec3 q) const noexcept {
  const Vec3 way = q - at.p;
  const double length = length_of(way);
  if (length < 1e-12) return true;
  const int steps = static_cast<int>(std::ceil(length / (kStepVoxels * grid.voxel_mm)));
  const Vec3 start = at.p;
  double reached = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const IVec3 v = ToolOverlap::voxel_at(grid, start + way * t);
    if (v != at.voxel) {
      if (!overlap_.free(burr, v)) {
        double free = reached, blocked = t;
        for (int half = 0; half < kHalvings; ++half) {
          const double middle = 0.5 * (free + blocked);
          (ToolOverlap::voxel_at(grid, start + way * middle) == at.voxel ? free : blocked) = middle;
        }
        at.p = start + way * free;
        return false;
      }
      at.voxel = v;
    }
    reached = t;
  }
  at.p = q;
  return true;
}

VoxelContact RayProxy::solve(const Volume& volume, const Scene& scene, std::size_t burr, Vec3 from,
                             Vec3 device) noexcept {
  VoxelContact out;
  overlap_.forget_hits();
  out.pose_mm = device;
  if (overlap_.apart(volume, scene, burr, from, device)) return out;

  const Grid& grid = volume.grid();
  const double voxel = grid.voxel_mm;
  At at{from, ToolOverlap::voxel_at(grid, from)};
  bool arrived = walk(grid, burr, at, device);

  Vec3 n(0.0);
  IVec3 normal_of = at.voxel;
  bool known = !arrived && normal(burr, at.voxel, n);
  Vec3 way(0.0);
  double most = kSlideVoxels * voxel;
  bool moved = false, resting = false;
  for (int slide = 0; slide < kSlides && known; ++slide) {
    const Vec3 gap = device - at.p;
    const Vec3 along = gap - n * glm::dot(gap, n);
    const double left = length_of(along);
    // Sent back by the next voxel's normal: shorter steps from here on.
    if (glm::dot(along, way) < 0.0) most *= 0.5;
    resting = left < kRestVoxels * voxel || most < kRestVoxels * voxel;
    if (resting) break;
    way = along;
    const Vec3 move = along * (std::min(left, most) / left);

    At next = at;
    if (!walk(grid, burr, next, at.p + move)) {
      // Up in quarter voxels until there is a way over.
      At up = at;
      bool over = false;
      for (int lift = 1; lift <= kLifts && !over; ++lift) {
        if (!walk(grid, burr, up, at.p + n * (kStepVoxels * voxel * lift))) break;
        next = up;
        over = walk(grid, burr, next, up.p + move);
      }
      resting = !over;
      if (!over) break;
    }
    const double above = glm::dot(next.p - device, n);
    if (above > 0.0) walk(grid, burr, next, next.p - n * std::min(above, kDropVoxels * voxel));
    const Vec3 rest = device - next.p;
    resting = length_of(rest - n * glm::dot(rest, n)) > left - 0.001 * voxel;
    if (resting) break;
    at = next;
    moved = true;
    if (at.voxel != normal_of) {
      known = normal(burr, at.voxel, n);
      normal_of = at.voxel;
    }
  }
  out.deferred = known && !resting;
  if (moved) arrived = walk(grid, burr, at, device);
  out.pose_mm = at.p;
  out.touching = !arrived;
  if (arrived) {
    out.deferred = false;
    return out;
  }
  overlap_.hit_further(volume, burr, device, out);
  return out;
}

}  // namespace cusp
