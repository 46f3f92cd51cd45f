/// Hands that make mistakes: the novice, who fails for many reasons, the fair one between expert and novice, and single
/// faults, each of which a grade must find.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/operators/hand.h"

namespace cusp::scenarios {

enum class HandFault : std::uint8_t {
  novice,       // shakes, cuts too deep and over the edge, forgets the coolant
  fair,         // off by 0.6 of the leeway in depth and 0.4 at the side: its marks stand on the slopes of the bands, so
                // that an audit sees what voxels change; whether it passes is the exercise's: at level 1 it fails
  too_deep,     // floor 0.8 mm below the target's
  too_shallow,  // floor 0.8 mm above it (at most half the depth)
  shaky,        // the right path with a strong tremor
  off_outline,  // the whole outline 0.7 mm to the side
  pulp,         // the right path, then down into the pulp
  dry,          // the right path without coolant
};

[[nodiscard]] Hand faulty(HandFault fault, const Scenario& scenario, const Specimen& specimen, std::uint64_t seed = 1);

/// "expert", "novice", "fair", "too_deep", "too_shallow", "shaky", "off_outline", "pulp", "dry":
/// nullopt for anything else.
[[nodiscard]] std::optional<Hand> hand_by_name(std::string_view name, const Scenario& scenario,
                                               const Specimen& specimen, std::uint64_t seed = 1);

}  // namespace cusp::scenarios
