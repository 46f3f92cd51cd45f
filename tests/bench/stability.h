/// The verb `stability`: every contact method, its guard on and off, through the cases of stability_cases.h. A row for
/// each case, method, guard, hand and voxel size; see rows.h for what its fields mean, and engine/lab/measures.h for how
/// they are taken.
#pragma once

#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/stability_cases.h"

namespace cusp::bench {

/// Everything that was measured for `stability`, filtered by the options. Budget: wall clock a row of kWayCases; the
/// others take what they take. Devices beyond the usual one are swept from a budget of kSweepBudgetS on.
inline constexpr double kSweepBudgetS = 0.5;
std::vector<Row> stability_rows(const Options& options);
int run_stability(const Options& options);

/// The device and hand of every row that names no other: 0.1 kg and 2 N s/m [M], no friction, 1 ms there and back, held
/// softly.
Setting usual_setting();

/// All that --device can ask for.
std::vector<std::string> device_names();

/// k_max of a method and of the exact proxy in one place, and what is met at half of it.
Row press_row(const CaseRun& what);

}  // namespace cusp::bench
