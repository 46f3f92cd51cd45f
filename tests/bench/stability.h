/// The verb `stability`: every contact method, its guard on and off, through the cases of stability_cases.h. A row for
/// each case, method, guard, hand and voxel size; see rows.h for what its fields mean, and engine/lab/measures.h for
/// how they are taken.
#pragma once

#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/stability_cases.h"

namespace cusp::bench {

/// All rows, filtered by the options. Budget: a row of kMotionCases gets two fifths of it, of the core's time, and one run
/// at least; k_max is found with five seeds, with two where the budget is below kWholeBudgetS. Other devices, grips,
/// frictions and delays than the usual ones are measured where they are asked for.
inline constexpr double kWholeBudgetS = 0.5;
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
