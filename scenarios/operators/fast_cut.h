/// A plan cut at once: the sweeps of its strokes through the product's own removal, without a hand, a device or time.
/// Time, force and heat of such an attempt are not measured. Thread: any; one at a time for each volume.
#pragma once

#include <optional>
#include <string_view>

#include "engine/volume/volume.h"
#include "scenarios/operators/plan.h"

namespace cusp::scenarios {

/// Cuts what the bur's head sweeps in the plan's cutting strokes, and removes what that severs, as the step does. The bur
/// is held along the plan's axis. A filled volume loses each voxel that the voxelised bur meets. Tenths of a second for a cavity. False if
/// the volume has no room for the cuts; it then holds some of them. Pre: the plan's bur is one of the scenario's.
[[nodiscard]] bool cut_along(const Plan& plan, const Scenario& scenario, Volume& volume);

/// The same with a bur that is none of the plan's.
[[nodiscard]] bool cut_along(const Plan& plan, const Bur& bur, Volume& volume);

/// The plan of an operator whose cuts alone differ: "reference" (the target itself), and the paths of "competent", "novice",
/// "too_deep", "too_shallow", "off_outline", "pulp" (faults.h). nullopt for any other name.
[[nodiscard]] std::optional<Plan> plan_by_name(std::string_view name, const Scenario& scenario, const Specimen& specimen,
                                               PlanCancel cancel = nullptr);

}  // namespace cusp::scenarios
