/// Scripted operators that make mistakes: the novice, the competent one between expert and novice, and single faults.
/// A grade must find each single fault.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/operators/scripted_operator.h"

namespace cusp::scenarios {

enum class OperatorFault : std::uint8_t {
  novice,       // shakes, cuts too deep and over the edge, forgets the coolant
  competent,    // off by 0.6 of the tolerance zone in depth and 0.4 at the side: its marks lie on the slopes of the bands,
                // where an audit sees what voxels change; it fails the blocks of level 1
  too_deep,     // floor 0.8 mm below the target's
  too_shallow,  // floor 0.8 mm above it (at most half the depth)
  shaky,        // the right path with a strong tremor
  off_outline,  // the whole outline 0.7 mm to the side
  pulp,         // the right path, then down into the pulp
  dry,          // the right path without coolant
};

/// Key of scripts and records; "fair" is read as "competent": records of earlier versions hold it.
[[nodiscard]] std::optional<OperatorFault> fault_by_name(std::string_view name) noexcept;

/// How the fault changes the path.
[[nodiscard]] PlanErrors errors_of(OperatorFault fault, const Scenario& scenario, const Specimen& specimen);

[[nodiscard]] ScriptedOperator faulty(OperatorFault fault, const Scenario& scenario, const Specimen& specimen,
                                      std::uint64_t seed = 1);

/// "expert", or a fault's key; nullopt for any other name.
[[nodiscard]] std::optional<ScriptedOperator> operator_by_name(std::string_view name, const Scenario& scenario,
                                                               const Specimen& specimen, std::uint64_t seed = 1);

}  // namespace cusp::scenarios
