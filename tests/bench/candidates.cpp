#include "tests/bench/candidates.h"

#include "engine/step/state.h"
#include "tests/modules.h"

namespace cusp::bench {

std::int64_t most_candidates(StepState& state) {
  const auto& surface = state.inner().surface;
  return surface ? static_cast<std::int64_t>(surface->most_candidates()) : -1;
}

std::int64_t answered_free(StepState& state) {
  const auto& surface = state.inner().surface;
  return surface ? static_cast<std::int64_t>(surface->answered_free()) : -1;
}

}  // namespace cusp::bench
