#include "scenarios/operators/faults.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "scenarios/operators/expert.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

namespace {
constexpr double kNoviceStopsS = 450.0;  // the novice ends then, where tissues give way at their own speeds

/// From the target's floor to its top, mm.
double depth_of(const Scenario& scenario, const Specimen& specimen) {
  const TargetShape target(scenario.target, lent(specimen));
  return target.top_mm() - target.floor_mm();
}

}  // namespace

std::optional<OperatorFault> fault_by_name(std::string_view name) noexcept {
  constexpr std::array<std::pair<std::string_view, OperatorFault>, 9> kKeys = {{{"novice", OperatorFault::novice},
                                                                                {"competent", OperatorFault::competent},
                                                                                {"fair", OperatorFault::competent},
                                                                                {"too_deep", OperatorFault::too_deep},
                                                                                {"too_shallow", OperatorFault::too_shallow},
                                                                                {"shaky", OperatorFault::shaky},
                                                                                {"off_outline", OperatorFault::off_outline},
                                                                                {"dry", OperatorFault::dry},
                                                                                {"pulp", OperatorFault::pulp}}};
  for (const auto& [key, fault] : kKeys)
    if (key == name) return fault;
  return std::nullopt;
}

PlanErrors errors_of(OperatorFault fault, const Scenario& scenario, const Specimen& specimen) {
  PlanErrors out;
  const bool banded = reading_of(scenario.method) == Reading::banded;
  switch (fault) {
    case OperatorFault::novice:
      out.deeper_mm = 0.9;
      // On the filled reading a narrow pit: a larger shift would miss it.
      out.shift_mm = banded ? Vec3(0.25, 0.35, 0.0) : Vec3(0.1, 0.12, 0.0);
      if (banded) {
        out.wider_mm = 0.15;
        out.bolder = 1.6;
      }
      break;
    case OperatorFault::competent:
      out.deeper_mm = 0.6 * scenario.leeway.floor_mm;
      out.shift_mm = {0.4 * scenario.leeway.side_mm, 0.4 * scenario.leeway.side_mm, 0.0};
      break;
    case OperatorFault::too_deep: out.deeper_mm = 0.8; break;
    case OperatorFault::too_shallow: out.deeper_mm = -std::min(0.8, 0.5 * depth_of(scenario, specimen)); break;
    case OperatorFault::off_outline: out.shift_mm = {0.0, 0.7, 0.0}; break;
    case OperatorFault::pulp: out.drill_to_pulp = true; break;
    case OperatorFault::shaky:
    case OperatorFault::dry: break;
  }
  return out;
}

ScriptedOperator faulty(OperatorFault fault, const Scenario& scenario, const Specimen& specimen, std::uint64_t seed) {
  OperatorStyle style = steady_style(scenario, specimen, seed);
  const bool banded = reading_of(scenario.method) == Reading::banded;
  switch (fault) {
    case OperatorFault::novice:
      style.coolant = false;
      style.arrive_mm = std::max(style.arrive_mm, 0.08);
      style.muscles.tremor_mm = banded ? 0.08 : 0.05;
      if (banded) style.wander_mm = 0.4;  // does not wait until the bur is back on its line
      style.correct_per_s = 4.0;
      style.patience_s = 1.5;
      break;
    case OperatorFault::competent: style.muscles.tremor_mm = 0.05; break;
    case OperatorFault::shaky:
      style.muscles.tremor_mm = 0.3;
      style.wander_mm = 1.0;
      style.arrive_mm = std::max(style.arrive_mm, 0.1);
      break;
    case OperatorFault::dry: style.coolant = false; break;
    default: break;
  }
  Plan plan = plan_target(scenario, specimen, errors_of(fault, scenario, specimen));
  if (fault == OperatorFault::novice) style.max_s = kNoviceStopsS / light_speed_share(scenario, plan.bur);
  return ScriptedOperator(std::move(plan), style, scenario);
}

std::optional<ScriptedOperator> operator_by_name(std::string_view name, const Scenario& scenario, const Specimen& specimen,
                                                 std::uint64_t seed) {
  if (name == "expert") return expert(scenario, specimen, seed);
  const auto fault = fault_by_name(name);
  return fault ? std::optional(faulty(*fault, scenario, specimen, seed)) : std::nullopt;
}

}  // namespace cusp::scenarios
