/// The shape `channel`: thirty random holes in turn, as one row a kind.
#pragma once

#include <vector>

#include "tests/bench/cut_shape.h"
#include "tests/bench/measure.h"

namespace cusp::bench {

/// Holes that are meant: in some the exact bur stays in or slips out by a hair, and either is right. So only those
/// count in which the exact proxy stands within 50 um of where it would at 1.5 or 0.6 of the clearance and at a pull of
/// 0.95 or 1.05. From seed on, `count` of them.
std::vector<std::shared_ptr<const Hole>> unambiguous_holes(double bur_radius_mm, HoleKind kind, std::uint64_t seed,
                                                     int count);

/// Each hole: cut, the bur led to its end, pulled aside by 0.1 mm, out along the axis and back in. Lag: how much
/// further behind the device point, along the axis, the method's proxy stands than the exact one.
Row measure_channel(const std::vector<std::shared_ptr<const Hole>>& holes, const Measure& what);

}  // namespace cusp::bench
