/// The shape `channel`: random holes in turn, one row for each HoleKind.
#pragma once

#include <vector>

#include "tests/bench/cut_shape.h"
#include "tests/bench/measure.h"

namespace cusp::bench {

/// `count` holes from `seed` on whose exact answer is unambiguous. In a bistable hole a bur that stays in and a bur
/// that slips out are both right. A hole counts if the exact proxy moves by less than 50 um at 1.5 and 0.6 of the
/// clearance and at 0.95 and 1.05 of the pull.
std::vector<std::shared_ptr<const Hole>> unambiguous_holes(double bur_radius_mm, HoleKind kind, std::uint64_t seed,
                                                     int count);

/// The bur moves to the end of each hole, 0.1 mm aside, out along the axis and back in.
Row measure_channel(const std::vector<std::shared_ptr<const Hole>>& holes, const Measure& what);

}  // namespace cusp::bench
