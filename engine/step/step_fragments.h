/// Severed pieces in a tick: crumbs at once, named pieces brick by brick (engine/volume/fragments.h).
/// Thread: haptic; wait-free.
#pragma once

#include "engine/removal/carve.h"
#include "engine/step/state.h"

namespace cusp::engine {

/// After a carving: crumbs beside what it changed go with it. False when the volume had no room.
bool drop_crumbs(StepState::Inner& state, const Carved& carved) noexcept;
/// The same of voxels low..high.
bool drop_crumbs(StepState::Inner& state, IVec3 low, IVec3 high) noexcept;

/// Takes in what the input names, and lets the next brick of a named piece go. False when the volume had no room.
bool let_pieces_go(StepState::Inner& state, std::uint16_t named) noexcept;

}  // namespace cusp::engine
