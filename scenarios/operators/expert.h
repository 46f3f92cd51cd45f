/// The expert: the target's own path, a steady hand. It must earn the pass mark of every built-in exercise.
#pragma once

#include "scenarios/operators/hand.h"

namespace cusp::scenarios {

/// A steady hand that can do what the scenario's method lets it feel.
[[nodiscard]] HandStyle steady_style(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed);
[[nodiscard]] Hand expert(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed = 1);

}  // namespace cusp::scenarios
