#include "engine/contact/methods/ray_proxy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/tool/swept.h"

namespace cusp::engine {

namespace {

constexpr double kStepVoxels = 0.25;  // of the ray
constexpr int kHalvings = 5;          // then the collision is known to 1/128 voxel
constexpr double kSlideVoxels = 0.5;  // one step of the path
constexpr int kSlides = 32;           // of one tick: 16 voxels of path
constexpr int kLifts = 8;             // quarter voxels: over what stands two voxels high
constexpr double kDropVoxels = 2.5;   // back to the surface after a step: what a lift may have gone up, and a little
constexpr double kRestVoxels = 1.0 / 64;
constexpr double kLeastVoxels = 0.001;  // of a step that counts
/// The length of the near voxels' mean over their root mean square distance is about (1 + r / reach) / 2 at a face,
/// half the square root of two of that in a right angle, less in a groove or a hole. Between the first two lies what
/// counts as one surface. Of a head that is no ball the mean is that of the head's normals towards the near voxels: one at
/// a face, the same half the square root of two in a right angle.
constexpr double kFlat = 0.85;
/// Voxels whose mean gives the normal lie up to this far from the bur: fewer make the normal step with the voxels,
/// more round every corner. Mean angle on a face, r 0.25, 10/128 mm: 1.5 gives 2.5 degrees, 2.5 gives 0.8, 3.5 gives
/// 0.6.
constexpr double kNearVoxels = 2.5;

/// Sums over a byte's set bits: of their places, and of the squares of these.
template <unsigned kPower>
constexpr std::array<std::uint8_t, 256> kSums = [] {
  std::array<std::uint8_t, 256> out{};
  for (unsigned b = 0; b < 256; ++b)
    for (unsigned i = 0; i < 8; ++i)
      if (b >> i & 1u) out[b] = static_cast<std::uint8_t>(out[b] + (kPower == 1 ? i : i * i));
  return out;
}();
constexpr const auto& kPositions = kSums<1>;
constexpr const auto& kSquares = kSums<2>;

}  // namespace

RayProxy::RayProxy(const Scene& scene, const Volume& volume) : overlap_(scene, volume) {
  for (const Bur& bur : scene.burs) {
    if (!bur.head.ball()) {
      near_.push_back(near_head(bur, scene.tool_axis, volume.grid().voxel_mm));
      continue;
    }
    const double r = bur.radius_mm / volume.grid().voxel_mm + kNearVoxels;
    const int reach = static_cast<int>(std::ceil(r));
    Near near;
    const double face = 0.5 * (1.0 + bur.radius_mm / volume.grid().voxel_mm / r);
    near.flat = kFlat * kFlat * face * face;
    for (int z = -reach; z <= reach; ++z)
      for (int y = -reach; y <= reach; ++y) {
        int x = -1;
        while ((x + 1) * (x + 1) + y * y + z * z <= r * r) ++x;
        if (x >= 0) near.rows.push_back({z, y, -x, x});
      }
    near_.push_back(std::move(near));
  }
}

RayProxy::Near RayProxy::near_head(const Bur& bur, Vec3 axis, double voxel_mm) {
  Near out;
  const int reach = static_cast<int>(std::ceil(head_reach(bur) / voxel_mm + kNearVoxels));
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y) {
      bool open = false;
      for (int x = -reach; x <= reach; ++x) {
        Vec3 gradient;
        const double away = head_distance(bur, axis, Vec3(x, y, z) * voxel_mm, gradient);
        const bool near = away > 0.0 && away <= kNearVoxels * voxel_mm;
        if (near && !open) out.rows.push_back({z, y, x, x});
        if (near) {
          out.rows.back().x1 = x;
          out.normals.push_back(gradient);
        }
        open = near;
      }
    }
  return out;
}

bool RayProxy::look_round_head(const Near& near, IVec3 pivot, Side& side) const noexcept {
  const Occupancy& occupancy = overlap_.occupancy();
  Vec3 sum(0.0);
  int count = 0;
  std::size_t first = 0;
  for (const VoxelRow& row : near.rows) {
    for_occupied(occupancy, row, pivot, [&](int x, unsigned bits) {
      for (; bits != 0; bits &= bits - 1) {
        const int at = x + std::countr_zero(bits) - pivot.x - row.x0;
        sum += near.normals[first + static_cast<std::size_t>(at)];
        ++count;
      }
    });
    first += static_cast<std::size_t>(row.x1 - row.x0 + 1);
  }
  if (count == 0) return false;
  const double length = length_of(sum);
  side.flat = length > kFlat * count;
  if (length > 0.0) side.n = sum / -length;
  return true;
}

bool RayProxy::look(std::size_t bur, IVec3 pivot, Side& side) const noexcept {
  if (!near_[bur].normals.empty()) return look_round_head(near_[bur], pivot, side);
  const Occupancy& occupancy = overlap_.occupancy();
  int count = 0;
  IVec3 sum(0);
  std::int64_t squares = 0;
  for (const VoxelRow& row : near_[bur].rows)
    for_occupied(occupancy, row, pivot, [&](int x, unsigned bits) {
      if (bits == 0) return;
      const int here = std::popcount(bits);
      const int from = x - pivot.x;
      const int places = kPositions[bits];
      count += here;
      sum.x += places + from * here;
      sum.y += row.y * here;
      sum.z += row.z * here;
      squares += kSquares[bits] + 2 * from * places + (from * from + row.y * row.y + row.z * row.z) * here;
    });
  if (count == 0) return false;
  const double length = length_of(Vec3(sum));
  side.flat = length * length > near_[bur].flat * static_cast<double>(squares) * count;
  if (length > 0.0) side.n = Vec3(sum) / -length;
  return true;
}

bool RayProxy::walk(const Grid& grid, std::size_t bur, At& at, Vec3 q) const noexcept {
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
      if (!overlap_.free(bur, v)) {
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

void RayProxy::climb(const Grid& grid, std::size_t bur, At& at, Vec3 n, double by) const noexcept {
  if (walk(grid, bur, at, at.p + n * by)) return;
  // On a jag the normal itself may lead into a voxel: then by its parts, the longest first.
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [n](int a, int b) {
    return std::fabs(n[a]) != std::fabs(n[b]) ? std::fabs(n[a]) > std::fabs(n[b]) : a < b;
  });
  for (const int axis : order) {
    Vec3 part(0.0);
    part[axis] = n[axis] * by;
    walk(grid, bur, at, at.p + part);
  }
}

bool RayProxy::step_over(const Grid& grid, std::size_t bur, At& at, Vec3 move, Vec3 n, Vec3 device) const noexcept {
  const double quarter = kStepVoxels * grid.voxel_mm;
  At next = at;
  if (!walk(grid, bur, next, at.p + move)) {
    // Up in quarter voxels until there is a way over.
    At up = at;
    bool over = false;
    for (int lift = 1; lift <= kLifts && !over; ++lift) {
      climb(grid, bur, up, n, quarter);
      next = up;
      over = walk(grid, bur, next, up.p + move);
    }
    if (!over) return false;
  }
  const double above = glm::dot(next.p - device, n);
  if (above > 0.0) walk(grid, bur, next, next.p - n * std::min(above, kDropVoxels * grid.voxel_mm));
  at = next;
  return true;
}

bool RayProxy::step_nearer(const Grid& grid, std::size_t bur, At& at, Vec3 device) const noexcept {
  const double longest = kSlideVoxels * grid.voxel_mm;
  const Vec3 gap = device - at.p;
  double best = length_of(gap) - kLeastVoxels * grid.voxel_mm;
  At nearest = at;
  bool found = false, jag = false;
  for (int choice = 0; choice < 6; ++choice) {
    // Without one axis, then along one axis alone.
    Vec3 part(0.0);
    if (choice < 3) {
      part = gap;
      part[choice] = 0.0;
    } else {
      part[choice - 3] = gap[choice - 3];
    }
    const double length = length_of(part);
    if (length < kLeastVoxels * grid.voxel_mm) continue;
    At next = at;
    walk(grid, bur, next, at.p + part * (std::min(length, longest) / length));
    const double distance = length_of(device - next.p);
    if (distance < best) {
      best = distance;
      nearest = next;
      found = true;
    }
  }
  // Nothing along a face: round a jag to a neighbour, as the paper goes. No tissue is thinner than a voxel.
  for (int choice = 0; choice < 27 && !found; ++choice) {
    const IVec3 to(choice % 3 - 1, choice / 3 % 3 - 1, choice / 9 - 1);
    const double distance = length_of(gap - Vec3(to) * grid.voxel_mm);
    if (distance >= best || !overlap_.free(bur, at.voxel + to)) continue;
    best = distance;
    nearest = {at.p + Vec3(to) * grid.voxel_mm, at.voxel + to};
    jag = true;
  }
  at = nearest;
  return found || jag;
}

VoxelContact RayProxy::solve(const Grid& grid, std::size_t bur, Vec3 from, Vec3 device) const noexcept {
  VoxelContact out;
  const double voxel = grid.voxel_mm;
  At at{from, ToolOverlap::voxel_at(grid, from)};
  bool arrived = walk(grid, bur, at, device);

  Side side;
  IVec3 side_of = at.voxel;
  bool known = !arrived && look(bur, at.voxel, side);
  Vec3 way(0.0);
  double most = kSlideVoxels * voxel;
  bool moved = false, resting = false;
  for (int slide = 0; slide < kSlides && known && !resting; ++slide) {
    At next = at;
    const Vec3 gap = device - at.p;
    if (side.flat) {
      const double out_of = glm::dot(gap, side.n);
      const Vec3 along = gap - side.n * out_of;
      const double left = length_of(along);
      // Sent back by the next voxel's normal: shorter steps from here on.
      if (glm::dot(along, way) < 0.0) most *= 0.5;
      way = along;
      resting = left < kRestVoxels * voxel || most < kRestVoxels * voxel ||
                !step_over(grid, bur, next, along * (std::min(left, most) / left), side.n, device);
      const Vec3 rest = device - next.p;
      resting = resting || length_of(rest - side.n * glm::dot(rest, side.n)) > left - kLeastVoxels * voxel;
    } else {
      resting = !step_nearer(grid, bur, next, device);
    }
    if (resting) break;
    at = next;
    moved = true;
    if (at.voxel != side_of) {
      known = look(bur, at.voxel, side);
      side_of = at.voxel;
    }
  }
  if (moved) arrived = walk(grid, bur, at, device);
  out.pose_mm = at.p;
  out.touching = !arrived;
  out.deferred = known && !resting && !arrived;
  return out;
}

}  // namespace cusp::engine
