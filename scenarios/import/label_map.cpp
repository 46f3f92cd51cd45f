#include "scenarios/import/label_map.h"

#include <algorithm>
#include <cmath>

#include "scenarios/import/limits.h"

namespace cusp::scenarios {
namespace {

constexpr int kReach = 4;       // voxels: the band ends 2.75 + 0.5 from the other side's centres
constexpr std::uint8_t kFar = 4 * kReach * kReach;  // squared distance of "further than the reach"

/// Squared distance in voxels to the nearest voxel where `seed` holds, at most kFar: one pass along each axis.
template <class Seed>
std::vector<std::uint8_t> squared_distance(const Grid& grid, Seed seed) {
  std::vector<std::uint8_t> from(grid.voxels());
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = seed(i) ? std::uint8_t{0} : kFar;
  std::vector<std::uint8_t> to(from.size());
  const std::size_t strides[3] = {1, static_cast<std::size_t>(grid.size.x),
                                  static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y)};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t stride = strides[axis];
    IVec3 v;
    std::size_t i = 0;
    for (v.z = 0; v.z < grid.size.z; ++v.z)
      for (v.y = 0; v.y < grid.size.y; ++v.y)
        for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
          int least = from[i];
          for (int j = 1; j <= kReach; ++j) {
            const std::size_t step = stride * static_cast<std::size_t>(j);
            if (v[axis] >= j) least = std::min(least, from[i - step] + j * j);
            if (v[axis] + j < grid.size[axis]) least = std::min(least, from[i + step] + j * j);
          }
          to[i] = static_cast<std::uint8_t>(std::min<int>(least, kFar));
        }
    std::swap(from, to);
  }
  return from;
}

}  // namespace

Tissue nearest_label(const Grid& grid, const std::vector<Tissue>& labels, IVec3 at) {
  int least = 4 * kFar;
  Tissue found = Tissue::empty;
  const IVec3 low = glm::max(at - kReach, IVec3(0));
  const IVec3 high = glm::min(at + kReach, grid.size - 1);
  IVec3 v;
  for (v.z = low.z; v.z <= high.z; ++v.z)
    for (v.y = low.y; v.y <= high.y; ++v.y)
      for (v.x = low.x; v.x <= high.x; ++v.x) {
        const Tissue t = labels[grid.index(v)];
        if (t == Tissue::empty) continue;
        const IVec3 d = v - at;
        const int squared = d.x * d.x + d.y * d.y + d.z * d.z;
        if (squared < least) {
          least = squared;
          found = t;
        }
      }
  return found;
}

LabelBox box_of_labels(const Grid& grid, const std::vector<Tissue>& labels) {
  return box_where(grid, [&](std::size_t i) { return labels[i] != Tissue::empty; });
}

Grid padded_grid(const Grid& grid, const LabelBox& box) {
  Grid out = grid;
  out.size = box.last - box.first + 1 + 2 * kPadVoxels;
  out.origin_mm = grid.centre_mm(box.first - kPadVoxels);
  return out;
}

VoxelVolume volume_of_labels(const Grid& grid, const std::vector<Tissue>& labels) {
  const LabelBox box = box_of_labels(grid, labels);
  VoxelVolume out(padded_grid(grid, box));
  IVec3 v;
  for (v.z = box.first.z; v.z <= box.last.z; ++v.z)
    for (v.y = box.first.y; v.y <= box.last.y; ++v.y)
      for (v.x = box.first.x; v.x <= box.last.x; ++v.x)
        out.tissue[out.grid.index(v - box.first + kPadVoxels)] = labels[grid.index(v)];

  const std::vector<Tissue> inside = out.tissue;
  const auto to_tissue = squared_distance(out.grid, [&](std::size_t i) { return inside[i] != Tissue::empty; });
  const auto to_empty = squared_distance(out.grid, [&](std::size_t i) { return inside[i] == Tissue::empty; });
  std::size_t i = 0;
  for (v.z = 0; v.z < out.grid.size.z; ++v.z)
    for (v.y = 0; v.y < out.grid.size.y; ++v.y)
      for (v.x = 0; v.x < out.grid.size.x; ++v.x, ++i) {
        const bool in = inside[i] != Tissue::empty;
        const double d = std::sqrt(static_cast<double>(in ? to_empty[i] : to_tissue[i])) - 0.5;
        out.s[i] = solid_from_distance(in ? -d : d);
        if (!in && out.s[i] > 0) out.tissue[i] = nearest_label(out.grid, inside, v);
      }
  return out;
}

}  // namespace cusp::scenarios
