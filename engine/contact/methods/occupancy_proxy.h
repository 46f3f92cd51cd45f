/// The paper's proxy: a voxel at a time to the free neighbour nearest to the device point, then along the ray.
/// A voxel is free when the superposed tool hits nothing; by the pivot alone in the variant kept for the record.
/// Source: paper, "Choosing the position of the proxy"; design, "Contact methods", 1. Thread: haptic; wait-free.
#pragma once

#include "engine/contact/methods/tool_overlap.h"

namespace cusp::engine {

class OccupancyProxy {
 public:
  OccupancyProxy(const Scene& scene, const Volume& volume) : overlap_(scene, volume) {}

  /// Pre: from and device are not ToolOverlap::apart().
  VoxelContact solve(const Grid& grid, std::size_t bur, Vec3 from, Vec3 device) const noexcept;
  ToolOverlap& overlap() noexcept { return overlap_; }

 private:
  ToolOverlap overlap_;
};

}  // namespace cusp::engine
