/// A cut along a known path, for tests and benches that know its exact surface.
#pragma once

#include <cmath>

#include "engine/contact/methods/tool_overlap.h"
#include "engine/removal/carve.h"
#include "engine/step/state.h"
#include "engine/tool/voxel_tool.h"
#include "tests/modules.h"

namespace cusp::test {

/// Every voxel that the cutting part of the voxelised bur covers with its pivot on the way loses all its density.
inline bool remove_along(StepState::Inner& state, const Bur& bur, Vec3 from_mm, Vec3 to_mm) {
  const Grid& grid = state.volume.grid();
  const VoxelTool tool = voxelise(bur, state.scene->tool_axis, grid.voxel_mm);
  const Vec3 way = to_mm - from_mm;
  const int samples = static_cast<int>(std::ceil(length_of(way) / (0.25 * grid.voxel_mm))) + 1;
  bool room = true;
  for (int i = 0; i <= samples; ++i) {
    const IVec3 pivot = ToolOverlap::voxel_at(grid, from_mm + way * (static_cast<double>(i) / samples));
    for (const IVec3& o : tool.cutting) {
      const IVec3 v = pivot + o;
      if (state.volume.occupied(v)) room = state.method->remove_voxels(state, {&v, 1}) && room;
    }
  }
  return room;
}

/// Carves the swept head. Pre: no stroke.
inline Carved carve_along(StepState::Inner& state, std::uint16_t bur, Vec3 from_mm, Vec3 to_mm) {
  const Bur& cutter = state.scene->burs[bur];
  const Vec3 axis = state.scene->tool_axis;
  if (!state.surface) return carve_sweep(state.volume, from_mm, to_mm, cutter, axis);
  Carved carved;
  if (cutter.head.ball()) {
    // A piece that begins where the last one ended goes on with it, as a sweep of its own.
    state.sweeps.seal();
    const std::int32_t id = state.sweeps.add(from_mm, to_mm, cutter.radius_mm);
    state.sweeps.seal();
    state.surface->set_cutting({.end = state.sweeps.size()});
    carved = carve_run(state.volume, state.sweeps, {id, id});
  } else {
    carved = carve_sweep(state.volume, from_mm, to_mm, cutter, axis);
    state.memory.add(from_mm, to_mm, {bur, axis});
    state.memory.break_path();
  }
  for_changed(carved, [&](const ChangedVoxels& changed) { state.surface->changed(state.volume, changed); });
  return carved;
}

/// Banded readings carve the swept head; filled ones lose the voxels that the voxelised bur covers. The proxy stays where it is.
/// False if the volume had no room. Pre: the store of sweeps has room.
inline bool cut_along(StepState& outer, std::uint16_t bur, Vec3 from_mm, Vec3 to_mm) {
  StepState::Inner& state = outer.inner();
  if (reading_of(state.scene->method) == Reading::filled) return remove_along(state, state.scene->burs[bur], from_mm, to_mm);
  const bool stroke = state.cut_valid || state.cut_pending || state.pending_sweep.waits;
  const bool room = !stroke || state.method->end_stroke(state);
  return !carve_along(state, bur, from_mm, to_mm).overflow && room;
}

}  // namespace cusp::test
