#include "scenarios/import/components.h"

namespace cusp::scenarios {
namespace {

/// Marks the connected component of the seeds where `open` holds; returns its voxels. Memory: its front only.
template <class Open>
std::size_t flood(const Grid& grid, std::vector<std::size_t> front, std::vector<bool>& marked, Open open) {
  std::size_t count = front.size();
  for (const std::size_t i : front) marked[i] = true;
  const auto nx = static_cast<std::size_t>(grid.size.x), ny = static_cast<std::size_t>(grid.size.y);
  std::vector<std::size_t> next;
  while (!front.empty()) {
    next.clear();
    for (const std::size_t i : front) {
      const std::size_t x = i % nx, y = i / nx % ny, z = i / (nx * ny);
      const auto visit = [&](std::size_t to) {
        if (marked[to] || !open(to)) return;
        marked[to] = true;
        ++count;
        next.push_back(to);
      };
      if (x > 0) visit(i - 1);
      if (x + 1 < nx) visit(i + 1);
      if (y > 0) visit(i - nx);
      if (y + 1 < ny) visit(i + nx);
      if (z > 0) visit(i - nx * ny);
      if (z + 1 < static_cast<std::size_t>(grid.size.z)) visit(i + nx * ny);
    }
    std::swap(front, next);
  }
  return count;
}

}  // namespace

std::size_t keep_largest_component(const Grid& grid, std::vector<Tissue>& labels) {
  const auto solid = [&](std::size_t i) { return labels[i] != Tissue::empty; };
  std::vector<bool> marked(labels.size());
  std::size_t most = 0, seed = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!solid(i) || marked[i]) continue;
    const std::size_t count = flood(grid, {i}, marked, solid);
    if (count > most) {
      most = count;
      seed = i;
    }
  }
  if (most == 0) return 0;
  marked.assign(labels.size(), false);
  flood(grid, {seed}, marked, solid);
  std::size_t removed = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!solid(i) || marked[i]) continue;
    labels[i] = Tissue::empty;
    ++removed;
  }
  return removed;
}

std::size_t fill_hollows(const Grid& grid, std::vector<Tissue>& labels, Tissue tissue) {
  const auto hollow = [&](std::size_t i) { return labels[i] == Tissue::empty; };
  std::vector<std::size_t> seeds;
  IVec3 v;
  std::size_t i = 0;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x, ++i) {
        const bool edge = v.x == 0 || v.y == 0 || v.z == 0 || v.x + 1 == grid.size.x || v.y + 1 == grid.size.y || v.z + 1 == grid.size.z;
        if (edge && hollow(i)) seeds.push_back(i);
      }
  std::vector<bool> reached(labels.size());
  flood(grid, std::move(seeds), reached, hollow);
  std::size_t filled = 0;
  for (i = 0; i < labels.size(); ++i) {
    if (!hollow(i) || reached[i]) continue;
    labels[i] = tissue;
    ++filled;
  }
  return filled;
}

}  // namespace cusp::scenarios
