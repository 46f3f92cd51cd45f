#include "scenarios/shapes/voxel_index.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {

namespace {

double box_gap_squared(Vec3 p, Vec3 low, Vec3 high) noexcept {
  const Vec3 off = glm::max(glm::max(low - p, p - high), Vec3(0.0));
  return glm::dot(off, off);
}

}  // namespace

VoxelIndex::VoxelIndex(const Specimen& specimen, const TissueSet& tissues) : grid_(specimen.grid()) {
  const IVec3 bricks = specimen.brick_count();
  const auto is_one = [&](IVec3 v) { return tissues[index_of(specimen.tissue(v))] && was_solid(specimen, v); };
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (specimen.uniform(b) && !tissues[index_of(specimen.tissue_in(b, 0))]) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (!is_one(v)) continue;
      bool outermost = false;
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -1; step <= 1; step += 2) {
          IVec3 next = v;
          next[axis] += step;
          outermost = outermost || !is_one(next);
        }
      if (outermost) voxels_.push_back(v);
    }
  }
  index();
}

VoxelIndex::VoxelIndex(const Grid& grid, std::vector<IVec3> voxels) : grid_(grid), voxels_(std::move(voxels)) {
  const auto key = [](IVec3 v) { return std::array{v.z, v.y, v.x}; };
  std::ranges::sort(voxels_, {}, key);
  voxels_.erase(std::unique(voxels_.begin(), voxels_.end()), voxels_.end());
  index();
}

/// Blocks of four voxels along an edge become the tree's leaves.
void VoxelIndex::index() {
  const auto block = [](IVec3 v) { return std::array{v.z >> 2, v.y >> 2, v.x >> 2}; };
  std::ranges::stable_sort(voxels_, {}, block);
  std::vector<Node> leaves;
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    const Vec3 centre = grid_.centre_mm(voxels_[i]);
    const Vec3 low = centre - 0.5 * grid_.voxel_mm, high = centre + 0.5 * grid_.voxel_mm;
    if (i == 0 || block(voxels_[i]) != block(voxels_[i - 1])) leaves.push_back({low, high, i, i});
    Node& leaf = leaves.back();
    leaf.low = glm::min(leaf.low, low);
    leaf.high = glm::max(leaf.high, high);
    leaf.last = i + 1;
  }
  if (!leaves.empty()) root_ = grow(leaves);
}

std::int32_t VoxelIndex::grow(std::span<Node> leaves) {
  Node node = leaves.front();
  if (leaves.size() > 1) {
    for (const Node& leaf : leaves) {
      node.low = glm::min(node.low, leaf.low);
      node.high = glm::max(node.high, leaf.high);
    }
    const Vec3 size = node.high - node.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const std::size_t half = leaves.size() / 2;
    std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
                     [axis](const Node& a, const Node& b) { return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis]; });
    node.first = node.last = 0;
    node.left = grow(leaves.first(half));
    node.right = grow(leaves.subspan(half));
  }
  nodes_.push_back(node);
  return static_cast<std::int32_t>(nodes_.size()) - 1;
}

double VoxelIndex::distance_mm(Vec3 p, double at_most_mm) const noexcept {
  if (root_ < 0) return at_most_mm;
  double best = at_most_mm * at_most_mm;
  struct Waiting {
    std::int32_t node;
    double gap;
  };
  std::array<Waiting, 64> stack;  // a balanced tree of 2^32 leaves is not deeper than 32
  std::size_t waiting = 0;
  const auto gap_of = [&](std::int32_t node) {
    const Node& n = nodes_[static_cast<std::size_t>(node)];
    return box_gap_squared(p, n.low, n.high);
  };
  stack[waiting++] = {root_, gap_of(root_)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.gap >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(next.node)];
    if (node.left < 0) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        const Vec3 centre = grid_.centre_mm(voxels_[i]);
        best = std::min(best, box_gap_squared(p, centre - 0.5 * grid_.voxel_mm, centre + 0.5 * grid_.voxel_mm));
      }
      continue;
    }
    // The nearer half is looked into first.
    Waiting a{node.left, gap_of(node.left)}, b{node.right, gap_of(node.right)};
    if (a.gap < b.gap) std::swap(a, b);
    if (a.gap < best) stack[waiting++] = a;
    if (b.gap < best) stack[waiting++] = b;
  }
  return std::sqrt(best);
}

}  // namespace cusp::scenarios
