#include "scenarios/import/part_precedence.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {
namespace {

constexpr double kDeepVoxels = 1.0;        // a wall that two parts share is known to less than this
constexpr double kSamplesOfAPart = 20000;  // one each hundredth of a square millimetre of a crown
constexpr double kMaxSamplesOfATriangle = 4096;
constexpr double kSharedWallVoxels = 0.05;  // by which two measures of one wall differ: mesh_accuracy_test.cpp
constexpr double kLeastOverlapMm3 = 0.01;
constexpr double kWholeShare = 0.995;       // of a part's voxels: its outermost ones may be counted to either
constexpr int kBand = 3;                    // whole voxels that hold the band, kBandVoxels

struct SurfacePoint {
  IVec3 voxel;
  double mm2;
};

/// Points spread evenly over a part's own surface, each with the area that it stands for.
std::vector<SurfacePoint> surface_points(const MeshPart& part, const Grid& grid) {
  const double each = std::max(part.checked.area / kSamplesOfAPart, 4.0 * grid.voxel_mm * grid.voxel_mm);
  std::vector<SurfacePoint> out;
  for (std::size_t n = 0; n < part.first_cap && n < part.mesh.triangles.size(); ++n) {
    const auto& t = part.mesh.triangles[n];
    const Vec3 a = part.mesh.points[t[0]], b = part.mesh.points[t[1]] - a, c = part.mesh.points[t[2]] - a;
    const double area = 0.5 * glm::length(glm::cross(b, c));
    const double count = std::clamp(std::ceil(area / each), 1.0, kMaxSamplesOfATriangle);
    for (double k = 0.0; k < count; ++k) {
      // The R2 sequence (Roberts 2018), folded into the triangle.
      double u = std::fmod(0.5 + k * 0.7548776662466927, 1.0), v = std::fmod(0.5 + k * 0.5698402909980532, 1.0);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      out.push_back({IVec3(glm::round((a + u * b + v * c - grid.origin_mm) / grid.voxel_mm)), area / count});
    }
  }
  return out;
}

/// [i * parts + j]: share of i's own surface that lies deep in j.
std::vector<double> shares_within(const std::vector<MeshPart>& parts, const std::vector<PartField>& fields, const Grid& grid) {
  const std::uint16_t deep = solid_from_distance(-kDeepVoxels);
  std::vector<double> out(parts.size() * parts.size(), 0.0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<SurfacePoint> points = surface_points(parts[i], grid);
    double all = 0.0;
    for (const SurfacePoint& p : points) all += p.mm2;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (i == j || !(all > 0.0)) continue;
      for (const SurfacePoint& p : points)
        if (fields[j].at(p.voxel) >= deep) out[i * parts.size() + j] += p.mm2 / all;
    }
  }
  return out;
}

/// Calls each(index in the grid, index in the field) for every voxel of a part's box.
template <class Each>
void for_each_voxel(const PartField& field, const Grid& grid, Each each) {
  std::size_t i = 0;
  for (int z = 0; z < field.size.z; ++z)
    for (int y = 0; y < field.size.y; ++y) {
      std::size_t at = grid.index(field.first + IVec3(0, y, z));
      for (int x = 0; x < field.size.x; ++x, ++i, ++at) each(at, i);
    }
}

/// Marks what lies within kBand voxels of a marked one along an axis.
void widen(const Grid& grid, int axis, const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to) {
  const std::size_t strides[3] = {1, static_cast<std::size_t>(grid.size.x),
                                  static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y)};
  const std::size_t stride = strides[axis];
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
        std::uint8_t marked = from[i];
        for (int j = 1; j <= kBand && !marked; ++j) {
          const std::size_t step = stride * static_cast<std::size_t>(j);
          if (v[axis] >= j) marked |= from[i - step];
          if (v[axis] + j < grid.size[axis]) marked |= from[i + step];
        }
        to[i] = marked;
      }
}

/// Where two parts meet in one wall each alone ends there; deep inside both together it is solid. bands[i]: how many
/// parts have their band at a voxel.
void close_inner_walls(VoxelVolume& volume, const std::vector<std::uint8_t>& bands) {
  std::vector<std::uint8_t> near(volume.s.size()), wider(volume.s.size());
  for (std::size_t i = 0; i < near.size(); ++i) near[i] = volume.s[i] < kHalf;
  for (int axis = 0; axis < 3; ++axis) {
    widen(volume.grid, axis, near, wider);
    std::swap(near, wider);
  }
  for (std::size_t i = 0; i < near.size(); ++i)
    if (!near[i] && bands[i] > 1) volume.s[i] = kSolid;
}

}  // namespace

PartOrder innermost_first(const std::vector<MeshPart>& parts, const std::vector<PartField>& fields, const Grid& grid) {
  const std::size_t n = parts.size();
  const std::vector<double> within = shares_within(parts, fields, grid);
  PartOrder left(n), out;
  for (std::size_t i = 0; i < n; ++i) left[i] = i;
  // How deep a part lies among those that are left: in the one that it lies in most.
  const auto depth = [&](std::size_t i) {
    double most = -1.0;
    for (const std::size_t j : left)
      if (j != i) most = std::max(most, within[i * n + j] - within[j * n + i]);
    return most;
  };
  const auto lies_further_out = [&](std::size_t a, std::size_t b) {
    const double da = depth(a), db = depth(b);
    if (da != db) return da < db;
    const double va = std::abs(parts[a].checked.volume), vb = std::abs(parts[b].checked.volume);
    return va != vb ? va > vb : parts[a].mesh.name > parts[b].mesh.name;
  };
  while (!left.empty()) {
    const auto outermost = std::ranges::min_element(left, lies_further_out);
    out.push_back(*outermost);
    left.erase(outermost);
  }
  std::ranges::reverse(out);
  return out;
}

std::vector<PartOverlap> overlaps_of(const PartOrder& order, const std::vector<PartField>& fields, const Grid& grid) {
  const std::uint16_t inside = solid_from_distance(-kSharedWallVoxels);
  const double voxel_mm3 = grid.voxel_mm * grid.voxel_mm * grid.voxel_mm;
  std::vector<PartOverlap> out;
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const PartField &winner = fields[order[a]], &loser = fields[order[b]];
      std::size_t both = 0, all = 0;
      IVec3 v;
      std::size_t i = 0;
      for (v.z = 0; v.z < winner.size.z; ++v.z)
        for (v.y = 0; v.y < winner.size.y; ++v.y)
          for (v.x = 0; v.x < winner.size.x; ++v.x, ++i) {
            if (winner.s[i] < inside) continue;
            ++all;
            both += loser.at(winner.first + v) >= inside;
          }
      const double mm3 = static_cast<double>(both) * voxel_mm3;
      if (mm3 >= kLeastOverlapMm3)
        out.push_back({order[a], order[b], mm3, static_cast<double>(both) >= kWholeShare * static_cast<double>(all)});
    }
  return out;
}

VoxelVolume put_together(const PartOrder& order, const std::vector<MeshPart>& parts, const std::vector<PartField>& fields,
                         const Grid& grid) {
  VoxelVolume out(grid);
  std::vector<std::uint8_t> bands(order.size() > 1 ? grid.voxels() : 0);
  // The winner comes last and lies over the others.
  for (auto n = order.rbegin(); n != order.rend(); ++n) {
    const std::vector<std::uint16_t>& s = fields[*n].s;
    for_each_voxel(fields[*n], grid, [&](std::size_t at, std::size_t i) {
      if (s[i] >= kHalf || (out.s[at] < kHalf && s[i] > out.s[at])) out.tissue[at] = parts[*n].tissue;
      out.s[at] = std::max(out.s[at], s[i]);
      if (!bands.empty() && bands[at] < 2 && s[i] > 0 && s[i] < kSolid) ++bands[at];
    });
  }
  if (!bands.empty()) close_inner_walls(out, bands);
  return out;
}

}  // namespace cusp::scenarios
