/// Counters of the surface proxy's search. Only this header reads a state's inner members for the benches.
#pragma once

#include <cstdint>

#include "engine/step/step.h"
#include "tests/modules.h"

namespace cusp::bench {

/// Most candidates of one search so far; -1 for the other methods.
std::int64_t most_candidates(StepState& state);

/// Units of 25 to 50 ns that the search for the proxy has counted so far (SurfaceContact::Budget); -1 for the other
/// methods.
std::int64_t counted_work(StepState& state);

/// Ticks so far that the cached free space answered without a search; -1 for the other methods.
std::int64_t answered_free(StepState& state);

/// The surface method's newest swept segment of cut poses: of balls, else of other heads. False if there is none.
bool newest_sweep(StepState& state, Vec3& from_mm, Vec3& to_mm);

}  // namespace cusp::bench
