#include "tests/scenarios/teeth/measure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cusp::test {

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

ToothDims measured_dims(const VoxelVolume& volume, double cej_mesial, double cej_distal, Quadrant quadrant) {
  const double h = volume.grid.voxel_mm, all = 100.0, from = std::max(cej_mesial, cej_distal);
  // The slice nearest to that height.
  const auto slice = [&](int axis, int sign, double z) {
    const double at = volume.grid.origin_mm.z + h * std::floor((z - volume.grid.origin_mm.z) / h + 0.5);
    return extent(volume, axis, sign, at - 1e-6, at + 1e-6);
  };
  const int m = quadrant == Quadrant::mirrored ? -1 : 1;
  ToothDims d;
  d.crown_length = extent(volume, 2, 1, -all, all);
  d.root_length = -extent(volume, 2, -1, -all, all);
  d.mesiodistal = extent(volume, 0, 1, from, all) - extent(volume, 0, -1, from, all);
  d.buccolingual = extent(volume, 1, 1, 0.0, all) - extent(volume, 1, -1, 0.0, all);
  d.mesiodistal_neck = m * (slice(0, m, cej_mesial) - slice(0, -m, cej_distal));
  d.buccolingual_neck = slice(1, 1, 0.0) - slice(1, -1, 0.0);
  return d;
}

int components(const VoxelVolume& volume, const std::function<bool(std::size_t)>& wanted) {
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

double thickness_below(const VoxelVolume& v, Vec3 top, Tissue tissue) {
  const double step = 0.01;
  double gone = 0.0;
  while (tissue_at(v, top) == Tissue::empty && gone < 0.3) top.z -= step, gone += step;
  double thick = 0.0;
  while (tissue_at(v, top) == tissue) top.z -= step, thick += step;
  return thick;
}

PulpHeights pulp_heights(const VoxelVolume& v, Vec3 cusp_tip) {
  const Grid& g = v.grid;
  Vec3 sum(0.0);
  double count = 0.0;
  IVec3 p;
  for (p.z = 0; p.z < g.size.z; ++p.z) {
    const double z = g.centre_mm(p).z;
    if (z < -0.2 || z > 0.8) continue;
    for (p.y = 0; p.y < g.size.y; ++p.y) {
      for (p.x = 0; p.x < g.size.x; ++p.x) {
        if (v.tissue[g.index(p)] == Tissue::pulp) sum += g.centre_mm(p), count += 1.0;
      }
    }
  }
  const Vec3 middle = sum / count;
  double ceiling = -99.0, floor = 99.0, furcation = -99.0;
  for (double z = -6.0; z < 6.0; z += 0.02) {
    if (tissue_at(v, {middle.x, middle.y, z}) != Tissue::pulp) continue;
    ceiling = std::max(ceiling, z);
    floor = std::min(floor, z);
  }
  for (double dx = -1.5; dx <= 1.5; dx += 0.25) {
    for (double dy = -1.0; dy <= 1.0; dy += 0.25) {
      double z = -8.0;
      if (tissue_at(v, {middle.x + dx, middle.y + dy, z}) != Tissue::empty) continue;  // a root
      while (z < 0.0 && tissue_at(v, {middle.x + dx, middle.y + dy, z}) == Tissue::empty) z += 0.02;
      furcation = std::max(furcation, z);
    }
  }
  return {cusp_tip.z - ceiling, ceiling - floor,     cusp_tip.z - floor,
          floor - furcation,    ceiling - furcation, cusp_tip.z - furcation};
}

double furthest_from_quoted(const PulpHeights& h, const QuotedHeights& q) {
  const auto off = [](double v, Quoted quoted) { return std::fabs(v - quoted.mean) / quoted.deviation; };
  return std::max({off(h.cusp_to_ceiling, q.cusp_to_ceiling), off(h.chamber, q.chamber), off(h.cusp_to_floor, q.cusp_to_floor),
                   off(h.floor_to_furcation, q.floor_to_furcation), off(h.ceiling_to_furcation, q.ceiling_to_furcation),
                   off(h.cusp_to_furcation, q.cusp_to_furcation)});
}

Components components_of_tissues(const VoxelVolume& v) {
  const auto of = [&](Tissue t) { return components(v, [&](std::size_t i) { return v.s[i] >= kHalf && v.tissue[i] == t; }); };
  return {components(v, [&](std::size_t i) { return v.s[i] >= kHalf; }), of(Tissue::enamel), of(Tissue::dentine),
          of(Tissue::cementum), of(Tissue::pulp)};
}

}  // namespace cusp::test
