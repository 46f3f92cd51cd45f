/// Room in the store of sweeps: what no voxel names owns no wall any more. Thread: haptic. Wait-free; some milliseconds for a
/// full store, so the step calls it while the bur touches nothing.
#pragma once

#include "engine/contact/sweeps.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// Forgets the sweeps that no voxel names, but for Sweeps::kBeside beside a named one, if the store wants room.
/// True if it did: ids have changed, in the volume and for whoever keeps one.
bool make_room(Sweeps& sweeps, Volume& volume) noexcept;

}  // namespace cusp::engine
