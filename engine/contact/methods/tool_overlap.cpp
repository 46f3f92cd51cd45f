#include "engine/contact/methods/tool_overlap.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"

namespace cusp::engine {

IVec3 ToolOverlap::voxel_at(const Grid& grid, Vec3 p) noexcept {
  return cell_of_voxels((p - grid.origin_mm) / grid.voxel_mm + 0.5);
}

std::vector<VoxelRow> ToolOverlap::rows_of(const std::vector<IVec3>& voxels) {
  std::vector<VoxelRow> out;
  for (const IVec3& v : voxels) {
    if (!out.empty() && out.back().z == v.z && out.back().y == v.y && out.back().x1 + 1 == v.x) {
      out.back().x1 = v.x;
    } else {
      out.push_back({v.z, v.y, v.x, v.x});
    }
  }
  return out;
}

ToolOverlap::ToolOverlap(const Scene& scene, const Volume& volume)
    : occupancy_(volume), tissue_(volume.specimen()), pivot_only_(scene.method == Method::occupancy_pivot) {
  std::size_t most = 0;
  for (const Bur& bur : scene.burs) {
    Tool tool;
    tool.voxels = voxelise(bur, scene.tool_axis, volume.grid().voxel_mm);
    tool.cutting = rows_of(tool.voxels.cutting);
    tool.holder = rows_of(tool.voxels.holder);
    most = std::max(most, tool.voxels.cutting.size());
    tools_.push_back(std::move(tool));
  }
  hit_.resize(most);
}

bool ToolOverlap::any(const std::vector<VoxelRow>& rows, IVec3 pivot) const noexcept {
  for (const VoxelRow& row : rows) {
    const int z = pivot.z + row.z;
    if (z > tissue_.high.z) break;  // in order of z: the rest is above all tissue
    const int y = pivot.y + row.y;
    if (z < tissue_.low.z || y < tissue_.low.y || y > tissue_.high.y) continue;
    const VoxelRow inside{row.z, row.y, std::max(row.x0, tissue_.low.x - pivot.x), std::min(row.x1, tissue_.high.x - pivot.x)};
    unsigned hit = 0;
    for_occupied(occupancy_, inside, pivot, [&](int, unsigned bits) { hit |= bits; });
    if (hit != 0) return true;
  }
  return false;
}

bool ToolOverlap::free(std::size_t bur, IVec3 pivot) const noexcept {
  if (occupancy_.occupied(pivot)) return false;
  if (pivot_only_) return true;
  return !any(tools_[bur].cutting, pivot) && !any(tools_[bur].holder, pivot);
}

bool ToolOverlap::apart(const Grid& grid, const Scene& scene, std::size_t bur, Vec3 from, Vec3 to) const noexcept {
  const IVec3 a = voxel_at(grid, glm::min(from, to));
  const IVec3 b = voxel_at(grid, glm::max(from, to));
  const Bur& shape = scene.burs[bur];
  const Vec3 holder = scene.tool_axis * ((shape.neck_length_mm + shape.shank_length_mm) / grid.voxel_mm);
  const int wide =
      std::max(tools_[bur].voxels.reach,
               static_cast<int>(std::ceil(std::max(shape.shank_radius_mm, shape.neck_radius_mm) / grid.voxel_mm))) +
      1;
  const IVec3 reach_low = IVec3(glm::floor(glm::min(holder, Vec3(0.0)))) - wide;
  const IVec3 reach_high = IVec3(glm::ceil(glm::max(holder, Vec3(0.0)))) + wide;
  for (int i = 0; i < 3; ++i)
    if (b[i] + reach_high[i] < tissue_.low[i] || a[i] + reach_low[i] > tissue_.high[i]) return true;
  return false;
}

void ToolOverlap::hit_further(const Grid& grid, std::size_t bur, Vec3 device, VoxelContact& contact) noexcept {
  const Tool& tool = tools_[bur];
  const Vec3 push = device - contact.pose_mm;
  const double most = std::max(std::fabs(push.x), std::max(std::fabs(push.y), std::fabs(push.z)));
  for (int i = 0; i < 3; ++i) contact.step[i] = push[i] > 0.5 * most ? 1 : push[i] < -0.5 * most ? -1 : 0;
  const IVec3 pivot = voxel_at(grid, contact.pose_mm) + contact.step;
  Vec3 sum(0.0);
  hit_count_ = 0;
  for (const IVec3& o : tool.voxels.cutting) {
    if (!occupancy_.occupied(pivot + o)) continue;
    hit_[hit_count_++] = pivot + o;
    sum -= Vec3(o) * grid.voxel_mm;
  }
  if (hit_count_ > 0) contact.mean_offset_mm = sum / static_cast<double>(hit_count_);
  contact.shank = !pivot_only_ && any(tool.holder, pivot);
}

}  // namespace cusp::engine
