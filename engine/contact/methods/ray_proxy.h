/// Ray proxy (Vlasov, Friese and Wolter 2012, 2013). Taken from them, as the paper retells it: a ray from the last
/// proxy to the device point is walked in steps finer than a voxel, and the last position before the collision is the
/// proxy, so that nothing is ever jumped. And from their own papers, that after the collision a local path along the
/// surface is sought. The path itself is Cusp's: small steps across the surface's normal, up over what stands in the
/// way and down again, until the device point lies under it.
///
/// Not as theirs: they move a point, here free means that the superposed tool hits nothing; they make an implicit
/// surface on the fly, here the normal is the mean direction of the voxels near the bur. Where voxels stand on several
/// sides (corner, groove, hole) there is no one normal: there the path goes along the voxels' faces, or round a jag to
/// a neighbour, as long as it comes nearer to the device point. A tick has a bounded path, the rest comes with the
/// next.
///
/// Its limits: the proxy stands up to a voxel off the surface and steps by a voxel on a slope; in corners and holes it
/// is held back by jags as the occupancy proxy is. Thread: haptic; wait-free; memory at construction.
#pragma once

#include <vector>

#include "engine/contact/methods/tool_overlap.h"

namespace cusp::engine {

class RayProxy {
 public:
  RayProxy(const Scene& scene, const Volume& volume);

  /// Pre: from and device are not ToolOverlap::apart().
  VoxelContact solve(const Grid& grid, std::size_t bur, Vec3 from, Vec3 device) const noexcept;
  ToolOverlap& overlap() noexcept { return overlap_; }

 private:
  struct Near {
    std::vector<VoxelRow> rows;      // of a ball a little wider than the bur; of another head the layer round it
    double flat = 0.0;          // ball: least square of the mean's length over the mean square that counts as one surface
    std::vector<Vec3> normals;  // other heads: out of the head at each voxel of the rows
  };
  static Near near_head(const Bur& bur, Vec3 axis, double voxel_mm);
  struct At {
    Vec3 p;
    IVec3 voxel;
  };
  /// From a free position towards q; stops at the last free position. True when q was reached.
  bool walk(const Grid& grid, std::size_t bur, At& at, Vec3 q) const noexcept;
  /// What the occupied voxels near the bur say about a pivot.
  struct Side {
    Vec3 n{0.0};        // out of the tissue: away from their mean
    bool flat = false;  // they stand on one side: n is a surface's
  };
  /// False when none is near.
  bool look(std::size_t bur, IVec3 pivot, Side& side) const noexcept;
  bool look_round_head(const Near& near, IVec3 pivot, Side& side) const noexcept;
  /// Away from the surface, as far as there is room.
  void climb(const Grid& grid, std::size_t bur, At& at, Vec3 n, double by) const noexcept;
  /// One step of the path along a surface: over what stands in the way and down again. False: no way.
  bool step_over(const Grid& grid, std::size_t bur, At& at, Vec3 move, Vec3 n, Vec3 device) const noexcept;
  /// One step along the voxels' faces, or round a jag, to whatever is nearest to the device point. False: nothing is
  /// nearer.
  bool step_nearer(const Grid& grid, std::size_t bur, At& at, Vec3 device) const noexcept;

  ToolOverlap overlap_;
  std::vector<Near> near_;  // one for each bur of the scene
};

}  // namespace cusp::engine
