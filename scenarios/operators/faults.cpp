#include "scenarios/operators/faults.h"

#include <algorithm>
#include <utility>

#include "scenarios/operators/expert.h"

namespace cusp::scenarios {

namespace {
constexpr double kNoviceStopsS = 450.0;  // the novice ends then, where tissues give way at their own speeds
}  // namespace

ScriptedOperator faulty(OperatorFault fault, const Scenario& scenario, const Specimen& specimen, std::uint64_t seed) {
  PlanErrors errors;
  OperatorStyle style = steady_style(scenario, specimen, seed);
  switch (fault) {
    case OperatorFault::novice:
      errors.deeper_mm = 0.9;
      style.coolant = false;
      style.arrive_mm = std::max(style.arrive_mm, 0.08);
      if (reading_of(scenario.method) == Reading::banded) {
        errors.shift_mm = {0.25, 0.35, 0.0};
        errors.wider_mm = 0.15;
        style.muscles.tremor_mm = 0.08;
        errors.bolder = 1.6;
        style.wander_mm = 0.4;  // does not wait until the bur is back on its line
      } else {
        // A narrow pit: a larger shift would miss it.
        errors.shift_mm = {0.1, 0.12, 0.0};
        style.muscles.tremor_mm = 0.05;
      }
      style.correct_per_s = 4.0;
      style.patience_s = 1.5;
      break;
    case OperatorFault::competent:
      errors.deeper_mm = 0.6 * scenario.leeway.floor_mm;
      errors.shift_mm = {0.4 * scenario.leeway.side_mm, 0.4 * scenario.leeway.side_mm, 0.0};
      style.muscles.tremor_mm = 0.05;
      break;
    case OperatorFault::too_deep:
      errors.deeper_mm = 0.8;
      break;
    case OperatorFault::too_shallow:
      errors.deeper_mm = -std::min(0.8, 0.5 * scenario.target.outline.depth_mm);
      break;
    case OperatorFault::shaky:
      style.muscles.tremor_mm = 0.3;
      style.wander_mm = 1.0;
      style.arrive_mm = std::max(style.arrive_mm, 0.1);
      break;
    case OperatorFault::off_outline:
      errors.shift_mm = {0.0, 0.7, 0.0};
      break;
    case OperatorFault::pulp:
      errors.drill_to_pulp = true;
      break;
    case OperatorFault::dry:
      style.coolant = false;
      break;
  }
  Plan plan = plan_target(scenario, specimen, errors);
  if (fault == OperatorFault::novice) style.max_s = kNoviceStopsS / light_speed_share(scenario, plan.bur);
  return ScriptedOperator(std::move(plan), style, scenario);
}

std::optional<ScriptedOperator> operator_by_name(std::string_view name, const Scenario& scenario, const Specimen& specimen,
                                                 std::uint64_t seed) {
  if (name == "expert") return expert(scenario, specimen, seed);
  if (name == "novice") return faulty(OperatorFault::novice, scenario, specimen, seed);
  if (name == "competent" || name == "fair") return faulty(OperatorFault::competent, scenario, specimen, seed);
  if (name == "too_deep") return faulty(OperatorFault::too_deep, scenario, specimen, seed);
  if (name == "too_shallow") return faulty(OperatorFault::too_shallow, scenario, specimen, seed);
  if (name == "shaky") return faulty(OperatorFault::shaky, scenario, specimen, seed);
  if (name == "off_outline") return faulty(OperatorFault::off_outline, scenario, specimen, seed);
  if (name == "dry") return faulty(OperatorFault::dry, scenario, specimen, seed);
  if (name == "pulp") return faulty(OperatorFault::pulp, scenario, specimen, seed);
  return std::nullopt;
}

}  // namespace cusp::scenarios
