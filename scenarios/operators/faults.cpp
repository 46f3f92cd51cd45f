#include "scenarios/operators/faults.h"

#include <algorithm>
#include <utility>

#include "scenarios/operators/expert.h"

namespace cusp::scenarios {

namespace {
constexpr double kLooksDoneS = 450.0;  // to a novice, where tissues give way at their own speeds
}  // namespace

Hand faulty(HandFault fault, const Scenario& scenario, const Specimen& specimen, std::uint64_t seed) {
  PlanErrors errors;
  HandStyle style = steady_style(scenario, specimen, seed);
  switch (fault) {
    case HandFault::novice:
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
        // A narrow pit: further off, nothing of it would be drilled at all.
        errors.shift_mm = {0.1, 0.12, 0.0};
        style.muscles.tremor_mm = 0.05;
      }
      style.correct_per_s = 4.0;
      style.patience_s = 1.5;
      break;
    case HandFault::fair:
      errors.deeper_mm = 0.6 * scenario.leeway.floor_mm;
      errors.shift_mm = {0.4 * scenario.leeway.side_mm, 0.4 * scenario.leeway.side_mm, 0.0};
      style.muscles.tremor_mm = 0.05;
      break;
    case HandFault::too_deep:
      errors.deeper_mm = 0.8;
      break;
    case HandFault::too_shallow:
      errors.deeper_mm = -std::min(0.8, 0.5 * scenario.target.depth_mm);
      break;
    case HandFault::shaky:
      style.muscles.tremor_mm = 0.3;
      style.wander_mm = 1.0;
      style.arrive_mm = std::max(style.arrive_mm, 0.1);
      break;
    case HandFault::off_outline:
      errors.shift_mm = {0.0, 0.7, 0.0};
      break;
    case HandFault::pulp:
      errors.drill_to_pulp = true;
      break;
    case HandFault::dry:
      style.coolant = false;
      break;
  }
  Plan plan = plan_target(scenario, specimen, errors);
  if (fault == HandFault::novice) style.most_s = kLooksDoneS / light_speed_share(scenario, plan.bur);
  return Hand(std::move(plan), style, scenario);
}

std::optional<Hand> hand_by_name(std::string_view name, const Scenario& scenario, const Specimen& specimen,
                                 std::uint64_t seed) {
  if (name == "expert") return expert(scenario, specimen, seed);
  if (name == "novice") return faulty(HandFault::novice, scenario, specimen, seed);
  if (name == "fair") return faulty(HandFault::fair, scenario, specimen, seed);
  if (name == "too_deep") return faulty(HandFault::too_deep, scenario, specimen, seed);
  if (name == "too_shallow") return faulty(HandFault::too_shallow, scenario, specimen, seed);
  if (name == "shaky") return faulty(HandFault::shaky, scenario, specimen, seed);
  if (name == "off_outline") return faulty(HandFault::off_outline, scenario, specimen, seed);
  if (name == "dry") return faulty(HandFault::dry, scenario, specimen, seed);
  if (name == "pulp") return faulty(HandFault::pulp, scenario, specimen, seed);
  return std::nullopt;
}

}  // namespace cusp::scenarios
