/// The expert: the target's own path, a steady hand. It must earn the pass mark of every built-in exercise.
#pragma once

#include "scenarios/hands/hand.h"

namespace cusp {

[[nodiscard]] Hand expert(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed = 1);

}  // namespace cusp
