#include "tests/bench/candidates.h"

#include "engine/step/state.h"
#include "tests/modules.h"

namespace cusp::bench {

std::int64_t most_candidates(StepState& state) {
  const auto& surface = state.inner().surface;
  return surface ? static_cast<std::int64_t>(surface->most_candidates()) : -1;
}

std::int64_t counted_work(StepState& state) {
  const auto& surface = state.inner().surface;
  return surface ? surface->candidates_visited() : -1;
}

std::int64_t answered_free(StepState& state) {
  const auto& surface = state.inner().surface;
  return surface ? static_cast<std::int64_t>(surface->answered_free()) : -1;
}

bool newest_sweep(StepState& state, Vec3& from_mm, Vec3& to_mm) {
  const engine::Sweeps& sweeps = state.inner().sweeps;
  const engine::CutMemory& memory = state.inner().memory;
  if (sweeps.size() > 0) {
    const engine::Sweep newest = sweeps[sweeps.size() - 1];
    from_mm = newest.a;
    to_mm = newest.b;
  } else if (memory.size() > 0) {
    const engine::CutMemory::Segment& newest = memory.segment(memory.size() - 1);
    from_mm = newest.a;
    to_mm = newest.b;
  }
  return sweeps.size() > 0 || memory.size() > 0;
}

}  // namespace cusp::bench
