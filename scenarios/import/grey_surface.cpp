#include "scenarios/import/grey_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/import/triangle_distance.h"

namespace cusp::scenarios {
namespace {

constexpr float kLeast = 1e-3f;  // no corner lies on the surface itself: its triangles would have no area

/// How far a value is from the nearest threshold that parts something from nothing.
float clearance(double value, const std::vector<std::pair<double, Tissue>>& thresholds) {
  double least = 1e9;
  Tissue before = Tissue::empty;
  for (const auto& [from, tissue] : thresholds) {
    if ((before == Tissue::empty) != (tissue == Tissue::empty)) least = std::min(least, std::abs(value - from));
    before = tissue;
  }
  return std::max(static_cast<float>(least), kLeast);
}

/// The surface within one tetrahedron: where its edges go from above to below nothing.
template <class Each>
void cross(const std::array<Vec3, 4>& at, const std::array<float, 4>& f, Each each) {
  std::array<int, 4> in{}, out{};
  int ins = 0, outs = 0;
  for (int i = 0; i < 4; ++i) {
    if (f[static_cast<std::size_t>(i)] > 0.0f) in[static_cast<std::size_t>(ins++)] = i;
    else out[static_cast<std::size_t>(outs++)] = i;
  }
  if (ins == 0 || outs == 0) return;
  const auto meet = [&](int a, int b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const double t = static_cast<double>(f[i]) / static_cast<double>(f[i] - f[j]);
    return at[i] + t * (at[j] - at[i]);
  };
  if (ins == 2) {
    const Vec3 a = meet(in[0], out[0]), b = meet(in[0], out[1]), c = meet(in[1], out[1]), d = meet(in[1], out[0]);
    each(std::array<Vec3, 3>{a, b, c});
    each(std::array<Vec3, 3>{a, c, d});
  } else if (ins == 1) {
    each(std::array<Vec3, 3>{meet(in[0], out[0]), meet(in[0], out[1]), meet(in[0], out[2])});
  } else {
    each(std::array<Vec3, 3>{meet(in[0], out[0]), meet(in[1], out[0]), meet(in[2], out[0])});
  }
}

/// Six tetrahedra about the diagonal of a cell from corner 0 to corner 7.
constexpr std::array<std::array<std::size_t, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

}  // namespace

double GreyField::at(Vec3 mm) const noexcept {
  std::array<std::size_t, 3> low{}, high{};
  Vec3 t;
  for (int i = 0; i < 3; ++i) {
    const double x = std::clamp((mm[i] - origin_mm[i]) / spacing_mm[i], 0.0, static_cast<double>(size[i] - 1));
    const int first = std::min(static_cast<int>(x), size[i] - 1);
    low[static_cast<std::size_t>(i)] = static_cast<std::size_t>(first);
    high[static_cast<std::size_t>(i)] = static_cast<std::size_t>(std::min(first + 1, size[i] - 1));
    t[i] = x - first;
  }
  const auto nx = static_cast<std::size_t>(size.x), ny = static_cast<std::size_t>(size.y);
  const auto row = [&](std::size_t y, std::size_t z) {
    const float* p = &value[nx * (y + ny * z)];
    const double a = static_cast<double>(p[low[0]]), b = static_cast<double>(p[high[0]]);
    return a + t.x * (b - a);
  };
  const double near_low = row(low[1], low[2]), near_high = row(high[1], low[2]);
  const double far_low = row(low[1], high[2]), far_high = row(high[1], high[2]);
  const double front = near_low + t.y * (near_high - near_low), back = far_low + t.y * (far_high - far_low);
  return front + t.z * (back - front);
}

IVec3 GreyField::nearest(Vec3 mm) const noexcept {
  IVec3 out;
  for (int i = 0; i < 3; ++i)
    out[i] = static_cast<int>(std::clamp(std::floor((mm[i] - origin_mm[i]) / spacing_mm[i] + 0.5), 0.0, static_cast<double>(size[i] - 1)));
  return out;
}

VoxelVolume volume_of_grey(const GreyField& field, const std::vector<std::pair<double, Tissue>>& thresholds, const Grid& grid,
                           const std::vector<Tissue>& labels, const LabelBox& box, const ImportProgress& progress) {
  VoxelVolume out(padded_grid(grid, box));
  const Grid& g = out.grid;
  const IVec3 shift = box.first - kPadVoxels;
  std::vector<Tissue> inside(g.voxels(), Tissue::empty);
  std::vector<float> f(g.voxels());  // above 0 within
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < g.size.z; ++v.z)
    for (v.y = 0; v.y < g.size.y; ++v.y)
      for (v.x = 0; v.x < g.size.x; ++v.x, ++i) {
        const IVec3 from = v + shift;
        if (grid.contains(from)) inside[i] = labels[grid.index(from)];
        const double value = field.at(g.centre_mm(v));
        // Beyond the file there is nothing, and what was cut off there ends half-way to its last voxel's neighbour.
        f[i] = clearance(value, thresholds);
        if (inside[i] == Tissue::empty) f[i] = -f[i];
      }

  std::vector<float> squared(g.voxels(), static_cast<float>(kDistanceReach * kDistanceReach));
  const std::array<std::size_t, 3> stride = {1, static_cast<std::size_t>(g.size.x),
                                             static_cast<std::size_t>(g.size.x) * static_cast<std::size_t>(g.size.y)};
  for (v.z = 0; v.z + 1 < g.size.z; ++v.z) {
    if (progress) progress(0.5 + 0.45 * v.z / g.size.z);
    for (v.y = 0; v.y + 1 < g.size.y; ++v.y)
      for (v.x = 0; v.x + 1 < g.size.x; ++v.x) {
        std::array<float, 8> corner{};
        std::array<Vec3, 8> at;
        int ins = 0;
        const std::size_t first = g.index(v);
        for (std::size_t n = 0; n < 8; ++n) {
          corner[n] = f[first + (n & 1) * stride[0] + (n >> 1 & 1) * stride[1] + (n >> 2) * stride[2]];
          at[n] = Vec3(v) + Vec3(static_cast<double>(n & 1), static_cast<double>(n >> 1 & 1), static_cast<double>(n >> 2));
          ins += corner[n] > 0.0f;
        }
        if (ins == 0 || ins == 8) continue;
        for (const auto& t : kTetrahedra) {
          cross({at[t[0]], at[t[1]], at[t[2]], at[t[3]]}, {corner[t[0]], corner[t[1]], corner[t[2]], corner[t[3]]},
                [&](const std::array<Vec3, 3>& triangle) { stamp_triangle(triangle, g, squared); });
        }
      }
  }
  i = 0;
  for (v.z = 0; v.z < g.size.z; ++v.z)
    for (v.y = 0; v.y < g.size.y; ++v.y)
      for (v.x = 0; v.x < g.size.x; ++v.x, ++i) {
        const bool in = inside[i] != Tissue::empty;
        const double d = std::sqrt(static_cast<double>(squared[i]));
        out.s[i] = solid_from_distance(in ? -d : d);
        if (out.s[i] > 0) out.tissue[i] = in ? inside[i] : nearest_label(g, inside, v);
        if (out.tissue[i] == Tissue::empty) out.s[i] = 0;
      }
  return out;
}

}  // namespace cusp::scenarios
