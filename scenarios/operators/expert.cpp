#include "scenarios/operators/expert.h"

namespace cusp::scenarios {

OperatorStyle steady_style(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed) {
  OperatorStyle style;
  style.muscles.seed = seed;
  style.muscles.tremor_mm = 0.01;  // braced fingers [M]
  if (reading_of(scenario.method) == Reading::filled) {
    // The proxy moves from voxel to voxel: no tolerance below a voxel can be met.
    const double voxel = specimen.grid().voxel_mm;
    style.arrive_mm = 1.2 * voxel;
    style.wander_mm = 2.5 * voxel;
    style.blunt_mm = voxel;
    style.feel_s = 0.15;
    style.side_push_n = 0.4;
    style.patience_s = 6.0;
    style.correct_per_s = 20.0;
  }
  return style;
}

ScriptedOperator expert(const Scenario& scenario, const Specimen& specimen, std::uint64_t seed) {
  PlanErrors none;
  // The filled reading stops the bur up to half a voxel before a wall.
  if (reading_of(scenario.method) == Reading::filled) none.wider_mm = 0.5 * specimen.grid().voxel_mm;
  return ScriptedOperator(plan_target(scenario, specimen, none), steady_style(scenario, specimen, seed), scenario);
}

}  // namespace cusp::scenarios
