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

struct Depths {
  double required_mm = 0;
  double leeway_mm = 0;             // below the required depth
  std::optional<double> pulp_mm{};  // the highest pulp under the target; none: no pulp there
  double seen_mm = 0;               // the deepest that was reached
};

/// The scale's end, mm, in whole halves: every one of the depths is on the scale.
inline double depth_scale_mm(const Depths& depths) {
  const double wanted = std::max({depths.required_mm + depths.leeway_mm + kBelowTargetMm,
                                  depths.pulp_mm.value_or(0) + kBeyondPulpMm, depths.seen_mm});
  return std::ceil(2 * wanted - 1e-9) / 2;
}

}  // namespace cusp::ui
