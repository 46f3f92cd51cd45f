/// How far down the depth gauge reaches. Pure.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace cusp::ui {

/// Below the tolerance zone this much is still read off the scale, mm: about what a bur gets too deep in a moment.
inline constexpr double kBelowTargetMm = 1.0;
/// And this much beyond the first pulp under the target, mm.
inline constexpr double kBeyondPulpMm = 0.5;

/// The scale's end for a required depth with its leeway and for the depth of the highest pulp under the target (nullopt:
/// none), mm; whole halves. `seen_mm`: the deepest that was reached, which the scale always shows.
inline double depth_scale_mm(double required_mm, double leeway_mm, std::optional<double> pulp_mm, double seen_mm = 0) {
  const double wanted = std::max({required_mm + leeway_mm + kBelowTargetMm, pulp_mm.value_or(0) + kBeyondPulpMm, seen_mm});
  return std::ceil(2 * wanted - 1e-9) / 2;
}

}  // namespace cusp::ui
