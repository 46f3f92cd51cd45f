/// Ray proxy (Vlasov, Friese and Wolter 2012, 2013). Taken from them, as the paper retells it: a ray from the last proxy to
/// the device point is walked in steps finer than a voxel, and the last position before the collision is the proxy, so
/// that nothing is ever jumped. And from their own papers: after the collision a local path is sought along the surface,
/// in small steps across the normal, up over what stands in the way and down again, until the device point lies under it.
/// Not as theirs: they move a point, here free means that the superposed tool hits nothing; they make an implicit surface
/// on the fly, here the normal is the mean direction of the voxels near the burr; the path ends after a bounded length,
/// the rest comes with the next tick.
/// Its limits: the proxy stands up to a voxel off the surface and steps by a voxel on a slope; a narrow corner has a
/// normal between its walls. Thread: haptic; wait-free; memory at construction.
#pragma once

#include <array>
#include <vector>

#include "engine/contact/tool_overlap.h"

namespace cusp {

class RayProxy {
 public:
  RayProxy(const Scene& scene, const Volume& volume);

  VoxelContact solve(const Volume& volume, const Scene& scene, std::size_t burr, Vec3 from, Vec3 device) noexcept;
  ToolOverlap& overlap() noexcept { return overlap_; }

 private:
  struct Row {
    int z, y, x0, x1;
  };
  struct At {
    Vec3 p;
    IVec3 voxel;
  };
  /// From a free position towards q; stops at the last free position. True when q was reached.
  bool walk(const Grid& grid, std::size_t burr, At& at, Vec3 q) const noexcept;
  /// Out of the tissue about a pivot: away from the mean of the occupied voxels near the burr. False: none, or no side.
  bool normal(std::size_t burr, IVec3 pivot, Vec3& n) const noexcept;

  ToolOverlap overlap_;
  std::vector<std::vector<Row>> near_;  // for each burr: a ball a little wider than it
};

}  // namespace cusp
