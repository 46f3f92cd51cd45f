/// The task `mill` of `rate`: the cutting tick of every method while it mills the cavity of cavity.h. All lanes get the same
/// device points, in alternating blocks of kMillBlock ticks on one core. Times: thread CPU time of each tick, 0.2 us of the
/// clock included. Rows with shape "cavity" stand in cavity.csv.
#pragma once

#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"

namespace cusp::bench {

inline constexpr int kMillBlock = 200;
inline constexpr double kMillMinutes = 2.0;  // at a budget of 1 s and more; below in proportion

/// A row for each radius (0.4 mm), tremor (0.05 mm), time and method. ratio_to_occupancy: of both mean times.
std::vector<Row> mill_rows(const Options& options);

}  // namespace cusp::bench
