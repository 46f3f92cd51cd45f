/// The verb `stability`: every contact method, guard on and off, in the cases of stability_cases.h. rows.h gives the
/// fields of a row; engine/lab/measures.h defines the measures.
#pragma once

#include <vector>

#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/stability_cases.h"

namespace cusp::bench {

/// All rows, filtered by the options. A row of kMotionCases takes two fifths of the budget in CPU time, and one run at
/// least. k_max takes five seeds, or two if the budget is below kWholeBudgetS. Other devices, grips, frictions and delays
/// than usual_setting() are measured on request.
inline constexpr double kWholeBudgetS = 0.5;
std::vector<Row> stability_rows(const Options& options);
int run_stability(const Options& options);

/// Default device and hand: 0.1 kg and 2 N s/m (assumed; no source publishes them), no friction, loop delay 1 ms, soft
/// grip.
Setting usual_setting();

/// Values of --device.
std::vector<std::string> device_names();

/// k_max of a method and of the exact proxy in one place, and the other measures at half of it.
Row press_row(const CaseRun& what);

}  // namespace cusp::bench
