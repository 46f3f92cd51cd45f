/// Charts over goes, as plain data: no widget.
#pragma once

#include <vector>

#include "storage/summary/history.h"
#include "ui/modules.h"
#include "ui/widgets/chart.h"

namespace cusp::ui {

/// Minutes against points, the goes joined in the order in which they were made, the newest one filled and named.
/// `goes`: of one exercise and one device class; those without a grade are left out.
ChartData time_and_score(const std::vector<HistoryRow>& goes);

/// Points against the number of the go.
ChartData score_by_go(const std::vector<HistoryRow>& goes);

}  // namespace cusp::ui
