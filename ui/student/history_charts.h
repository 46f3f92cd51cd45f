/// Charts over attempts, as plain data: no widget. An axis of points ends at 100; it begins at 40, or at 0 if an attempt or the pass
/// mark lies below 40.
#pragma once

#include <vector>

#include "storage/summary/history.h"
#include "ui/modules.h"
#include "ui/widgets/chart.h"

namespace cusp::ui {

/// Minutes against points, up to 60 attempts joined in the order in which they were made, the newest one filled and named.
/// `attempts`: of one exercise and one device class; those without a grade are left out.
ChartData time_and_score(const std::vector<HistoryRow>& attempts);

/// Points against the number of the attempt.
ChartData score_by_attempt(const std::vector<HistoryRow>& attempts);

/// Own assessment less what was measured, in points of 100, against the number of the attempt. Oldest first.
ChartData own_against_measured(const std::vector<RatedAttempt>& attempts);

/// Whose the points are that the first two, or the last one, draw: in their order.
std::vector<SessionId> sessions_drawn(const std::vector<HistoryRow>& attempts);
std::vector<SessionId> sessions_drawn(const std::vector<RatedAttempt>& attempts);

}  // namespace cusp::ui
