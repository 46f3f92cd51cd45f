/// What is wrong or doubtful about regions: validate()'s part for the target and what is protected. Inside of
/// scenarios/format.
#pragma once

#include <vector>

#include "scenarios/format/validate.h"

namespace cusp::scenarios {

/// Below a limit that is itself a product of rounded numbers (3 voxels of 0.1 mm are a hair more than 0.3).
inline bool below(double value, double limit) noexcept { return value < limit - 1e-9; }

/// Findings of the scenario's target and of its protected regions, appended. `specimen` may be null.
void check_target(const Scenario& scenario, const SpecimenFacts* specimen, std::vector<Finding>& out);

}  // namespace cusp::scenarios
