#include "tests/scenarios/teeth/measure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cusp {

double extent(const VoxelVolume& volume, int axis, int sign, double z_low, double z_high) {
  const Grid& g = volume.grid;
  const IVec3 step(axis == 0, axis == 1, axis == 2);
  double best = -1e9;
  IVec3 v;
  for (v.z = 1; v.z + 1 < g.size.z; ++v.z) {
    const double z = g.centre_mm(v).z;
    if (z < z_low || z > z_high) continue;
    for (v.y = 1; v.y + 1 < g.size.y; ++v.y) {
      for (v.x = 1; v.x + 1 < g.size.x; ++v.x) {
        const double in = distance_from_solid(volume.s[g.index(v)]), out = distance_from_solid(volume.s[g.index(v + sign * step)]);
        if (in > 0.0 || out <= 0.0) continue;
        const double at = g.centre_mm(v)[axis] + sign * g.voxel_mm * in / (in - out);
        best = std::max(best, sign * at);
      }
    }
  }
  return sign * best;
}

ToothDims measured_dims(const VoxelVolume& volume, double cej_mesial, double cej_distal, bool mirrored) {
  const double h = volume.grid.voxel_mm, all = 100.0, from = std::max(cej_mesial, cej_distal);
  // The slice nearest to that height.
  const auto slice = [&](int axis, int sign, double z) {
    const double at = volume.grid.origin_mm.z + h * std::floor((z - volume.grid.origin_mm.z) / h + 0.5);
    return extent(volume, axis, sign, at - 1e-6, at + 1e-6);
  };
  const int m = mirrored ? -1 : 1;
  ToothDims d;
  d.crown_length = extent(volume, 2, 1, -all, all);
  d.root_length = -extent(volume, 2, -1, -all, all);
  d.mesiodistal = extent(volume, 0, 1, from, all) - extent(volume, 0, -1, from, all);
  d.buccolingual = extent(volume, 1, 1, 0.0, all) - extent(volume, 1, -1, 0.0, all);
  d.mesiodistal_neck = m * (slice(0, m, cej_mesial) - slice(0, -m, cej_distal));
  d.buccolingual_neck = slice(1, 1, 0.0) - slice(1, -1, 0.0);
  return d;
}

int pieces(const VoxelVolume& volume, const std::function<bool(std::size_t)>& wanted) {
  const Grid& g = volume.grid;
  std::vector<std::uint8_t> open(g.voxels());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = wanted(i);
  int count = 0;
  std::vector<IVec3> stack;
  IVec3 v;
  for (v.z = 0; v.z < g.size.z; ++v.z) {
    for (v.y = 0; v.y < g.size.y; ++v.y) {
      for (v.x = 0; v.x < g.size.x; ++v.x) {
        if (!open[g.index(v)]) continue;
        ++count;
        open[g.index(v)] = 0;
        stack.push_back(v);
        while (!stack.empty()) {
          const IVec3 at = stack.back();
          stack.pop_back();
          for (const IVec3 d : {IVec3(1, 0, 0), IVec3(-1, 0, 0), IVec3(0, 1, 0), IVec3(0, -1, 0), IVec3(0, 0, 1), IVec3(0, 0, -1)}) {
            if (!g.contains(at + d) || !open[g.index(at + d)]) continue;
            open[g.index(at + d)] = 0;
            stack.push_back(at + d);
          }
        }
      }
    }
  }
  return count;
}

int peaks(const VoxelVolume& volume, double prominence_mm) {
  const Grid& g = volume.grid;
  const int nx = g.size.x, ny = g.size.y;
  std::vector<double> height(static_cast<std::size_t>(nx * ny), -1e9);
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      for (int z = g.size.z - 2; z > 0; --z) {
        const double in = distance_from_solid(volume.s[g.index({x, y, z})]);
        if (in > 0.0) continue;
        const double out = distance_from_solid(volume.s[g.index({x, y, z + 1})]);
        height[static_cast<std::size_t>(x + nx * y)] = g.centre_mm({x, y, z}).z + g.voxel_mm * in / (in - out);
        break;
      }
    }
  }
  // From the top down: a column is a new peak, or joins those beside it; where two peaks meet, the lower one ends.
  std::vector<int> order(height.size()), parent(height.size(), -1);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return height[std::size_t(a)] > height[std::size_t(b)]; });
  const std::function<int(int)> root = [&](int i) {
    while (parent[std::size_t(i)] != i) i = parent[std::size_t(i)];
    return i;
  };
  int count = 0;
  for (const int i : order) {
    const double h = height[std::size_t(i)];
    if (h < 0.0) break;  // below the neck
    parent[std::size_t(i)] = i;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = i % nx + dx, y = i / nx + dy;
        if (x < 0 || y < 0 || x >= nx || y >= ny || parent[std::size_t(x + nx * y)] < 0) continue;
        int a = root(i), b = root(x + nx * y);
        if (a == b) continue;
        if (height[std::size_t(a)] < height[std::size_t(b)]) std::swap(a, b);
        if (height[std::size_t(b)] - h >= prominence_mm) ++count;
        parent[std::size_t(b)] = a;
      }
    }
  }
  return count + 1;  // and the highest
}

double distance_mm(const VoxelVolume& volume, Vec3 at_mm) {
  const Grid& g = volume.grid;
  const Vec3 q = (at_mm - g.origin_mm) / g.voxel_mm, b = glm::floor(q), f = q - b;
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const IVec3 o(c & 1, c >> 1 & 1, c >> 2);
    const double w = (o.x ? f.x : 1 - f.x) * (o.y ? f.y : 1 - f.y) * (o.z ? f.z : 1 - f.z);
    sum += w * distance_from_solid(volume.s[g.index(IVec3(b) + o)]);
  }
  return sum * g.voxel_mm;
}

Tissue tissue_at(const VoxelVolume& volume, Vec3 at_mm) {
  const Grid& g = volume.grid;
  const IVec3 v(glm::floor((at_mm - g.origin_mm) / g.voxel_mm + 0.5));
  if (!g.contains(v) || volume.s[g.index(v)] < kHalf) return Tissue::empty;
  return volume.tissue[g.index(v)];
}

double pulp_cover_mm(const VoxelVolume& volume, double z_from, double most_mm) {
  const Grid& g = volume.grid;
  const int reach = static_cast<int>(most_mm / g.voxel_mm) + 1;
  double best = most_mm;
  IVec3 v;
  for (v.z = reach; v.z + reach < g.size.z; ++v.z) {
    if (g.centre_mm(v).z < z_from) continue;
    for (v.y = reach; v.y + reach < g.size.y; ++v.y) {
      for (v.x = reach; v.x + reach < g.size.x; ++v.x) {
        if (volume.tissue[g.index(v)] != Tissue::pulp) continue;
        bool rim = false;
        for (const IVec3 d : {IVec3(1, 0, 0), IVec3(-1, 0, 0), IVec3(0, 1, 0), IVec3(0, -1, 0), IVec3(0, 0, 1), IVec3(0, 0, -1)}) {
          rim = rim || volume.tissue[g.index(v + d)] != Tissue::pulp;
        }
        if (!rim) continue;
        IVec3 o;
        for (o.z = -reach; o.z <= reach; ++o.z) {
          for (o.y = -reach; o.y <= reach; ++o.y) {
            for (o.x = -reach; o.x <= reach; ++o.x) {
              const double d = g.voxel_mm * glm::length(Vec3(o));
              if (d >= best) continue;
              const std::size_t i = g.index(v + o);
              const bool inside = volume.s[i] >= kHalf && (volume.tissue[i] == Tissue::pulp || volume.tissue[i] == Tissue::dentine);
              if (!inside) best = d;
            }
          }
        }
      }
    }
  }
  return best;
}

}  // namespace cusp
