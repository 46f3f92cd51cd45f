/// Points of one value: piecewise linear (dental.md 2.4). Any thread.
#pragma once

#include <string_view>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// 1 in [ideal_lo, ideal_hi], 1/2 at acc_lo and acc_hi, 0 at fail_lo and fail_hi and outside. Edges that coincide are a
/// step: the better side wins at the edge itself.
[[nodiscard]] double share_of_points(const Bands& bands, double value) noexcept;

/// "ideal", "acceptable" (inside [acc_lo, acc_hi]), "fail", or "borderline": an edge between two of these is nearer than
/// the uncertainty. A side whose three edges coincide is a natural end (0 mm3, 100 %), not an edge.
[[nodiscard]] std::string_view band_of(const Bands& bands, double value, double uncertainty) noexcept;

}  // namespace cusp::scenarios
