/// The expert follows the target's own path with little tremor. It earns the pass mark of every built-in exercise.
#pragma once

#include "scenarios/operators/scripted_operator.h"

namespace cusp::scenarios {

/// The expert's style: tolerances follow what the scenario's method resolves.
[[nodiscard]] OperatorStyle steady_style(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed);
[[nodiscard]] ScriptedOperator expert(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed = 1);

}  // namespace cusp::scenarios
