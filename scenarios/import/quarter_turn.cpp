#include "scenarios/import/quarter_turn.h"

namespace cusp::scenarios {
namespace {

/// One quarter turn: the axis after `axis` becomes the one after that, which becomes the first, reversed.
VoxelVolume once(const VoxelVolume& from, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Grid grid = from.grid;
  grid.size[u] = from.grid.size[v];
  grid.size[v] = from.grid.size[u];
  grid.origin_mm[u] = -from.grid.centre_mm(from.grid.size - 1)[v];
  grid.origin_mm[v] = from.grid.origin_mm[u];
  VoxelVolume out(grid);
  out.names = from.names;
  IVec3 at;
  std::size_t i = 0;
  for (at.z = 0; at.z < from.grid.size.z; ++at.z)
    for (at.y = 0; at.y < from.grid.size.y; ++at.y)
      for (at.x = 0; at.x < from.grid.size.x; ++at.x, ++i) {
        IVec3 to = at;
        to[u] = from.grid.size[v] - 1 - at[v];
        to[v] = at[u];
        const std::size_t place = grid.index(to);
        out.s[place] = from.s[i];
        out.tissue[place] = from.tissue[i];
      }
  return out;
}

}  // namespace

VoxelVolume quarter_turned(const VoxelVolume& volume, int axis, int quarters) {
  VoxelVolume out = volume;
  for (int n = (quarters % 4 + 4) % 4; n > 0; --n) out = once(out, axis);
  return out;
}

}  // namespace cusp::scenarios
