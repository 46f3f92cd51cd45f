/// The report's second sheet: a picture of each place where points were lost. Thread: GUI, or any without a window.
#pragma once

#include <vector>

#include "ui/widgets/paper.h"
#include "ui/report/report_data.h"

namespace cusp::ui {

inline constexpr std::size_t kCloseupsShown = 20;  // that fit one sheet; the longest rubric has 17 criteria

/// From the paper's y() on. `closeups`: of the first entries of next_time() that have a place, in the same order.
void write_closeups(Paper& paper, const ReportData& data, const std::vector<CloseUp>& closeups,
                    const std::vector<int>& numbers);

}  // namespace cusp::ui
