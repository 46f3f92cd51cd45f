/// Points of one value: piecewise linear (dental.md 2.4). Any thread.
#pragma once

#include <limits>
#include <string_view>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// 1 in [ideal_lo, ideal_hi], 1/2 at acc_lo and acc_hi, 0 at fail_lo and fail_hi and outside. Edges that coincide are a
/// step: the better side wins at the edge itself.
[[nodiscard]] double share_of_points(const Bands& bands, double value) noexcept;

/// Values that a metric can take (MetricKey), in its unit.
struct Possible {
  double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
};

/// "ideal", "acceptable" (inside [acc_lo, acc_hi]), "fail", or "borderline": an edge between two of these is nearer than
/// the uncertainty. A side whose three edges coincide where the metric ends (0 mm3, 100 %) has none; elsewhere they are a step.
[[nodiscard]] std::string_view band_of(const Bands& bands, double value, double uncertainty, Possible possible = {}) noexcept;

}  // namespace cusp::scenarios
