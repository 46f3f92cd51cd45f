/// The cut of one single fault: the reference's path, changed in one way. Cut at once, as fast_cut.h does.
#pragma once

#include <memory>
#include <optional>

#include "scenarios/operators/plan.h"
#include "scenarios/operators/single_fault.h"

namespace cusp::scenarios {

struct FaultCut {
  Plan plan;
  Bur bur;           // that cuts: the reference's, or a wrong one
  double dry_s = 0;  // time that the bur works without coolant
};

/// Another target, planned for the reference's bur, or the reference's path moved. nullopt where the exercise cannot have the
/// fault: no neighbour, caries, enamel, pulp, ridge or coolant. Seconds. `reference`: plan_target() of the exercise, with
/// strokes. Any thread.
[[nodiscard]] std::optional<FaultCut> fault_cut(SizedFault fault, const Scenario& scenario, const Specimen& specimen, const Plan& reference);

}  // namespace cusp::scenarios
