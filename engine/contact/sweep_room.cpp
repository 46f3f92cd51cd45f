#include "engine/contact/sweep_room.h"

namespace cusp::engine {

namespace {

/// Calls visit(id) for every id that a voxel keeps.
template <class Visit>
void for_each_name(Volume& volume, Visit&& visit) noexcept {
  for (const std::int32_t brick : volume.cut_bricks()) {
    std::int32_t* ids = volume.sweeps_for_writing(brick);
    if (ids == nullptr) continue;
    for (int o = 0; o < kBrickVoxels; ++o)
      if (ids[o] != Volume::kNoSweep) visit(ids[o]);
  }
}

}  // namespace

bool make_room(Sweeps& sweeps, Volume& volume) noexcept {
  if (!sweeps.wants_room()) return false;
  sweeps.clear_marks();
  for_each_name(volume, [&](std::int32_t id) { sweeps.mark(id); });
  sweeps.drop_unmarked();
  for_each_name(volume, [&](std::int32_t& id) { id = sweeps.renumbered(id); });
  return true;
}

}  // namespace cusp::engine
