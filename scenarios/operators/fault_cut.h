/// The cut of one single fault: the reference's path, changed in one way. Cut at once, as fast_cut.h does.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/operators/plan.h"
#include "scenarios/operators/single_fault.h"

namespace cusp::scenarios {

struct FaultCut {
  /// A path and the bur that cuts along it: the reference's, or a wrong one.
  struct Pass {
    Plan plan;
    Bur bur;
  };
  std::vector<Pass> passes;  // in the order of time
  double dry_s = 0;          // time that a bur works without coolant
};

/// As cut_along(): false if the volume has no room for the cuts.
[[nodiscard]] bool cut_along(const FaultCut& fault, Volume& volume);

/// Another target, planned for the reference's bur, or the reference's path moved. nullopt where the exercise cannot have the
/// fault: no neighbour, caries, enamel, pulp, ridge or coolant. Seconds. `reference`: plan_target() of the exercise, with
/// strokes. Any thread.
[[nodiscard]] std::optional<FaultCut> fault_cut(SizedFault fault, const Scenario& scenario, const Specimen& specimen, const Plan& reference);

}  // namespace cusp::scenarios
