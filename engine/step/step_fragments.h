/// Severed fragments in a tick: crumbs at once, named fragments brick by brick (engine/volume/fragments.h).
/// Thread: haptic. Wait-free.
#pragma once

#include "engine/removal/carve.h"
#include "engine/step/state.h"

namespace cusp::engine {

/// Removes the crumbs beside what a carving changed. False if the volume had no room.
bool drop_crumbs(StepState::Inner& state, const Carved& carved) noexcept;
/// The same of voxels low..high.
bool drop_crumbs(StepState::Inner& state, IVec3 low, IVec3 high) noexcept;

/// Receives the input's half of a name, and removes the next part of a named fragment. False if the volume had no room.
bool remove_fragments(StepState::Inner& state, std::uint16_t named) noexcept;

}  // namespace cusp::engine
