/// What a state's method has looked at. The one place where a bench looks inside a state.
#pragma once

#include <cstdint>

#include "engine/step/step.h"
#include "tests/modules.h"

namespace cusp::bench {

/// Most candidates that one search of the surface proxy has met so far; -1 for the other methods.
std::int64_t most_candidates(StepState& state);

/// Ticks so far that the surface proxy answered from the free space it knows, without a search; -1 for other methods.
std::int64_t answered_free(StepState& state);

}  // namespace cusp::bench
