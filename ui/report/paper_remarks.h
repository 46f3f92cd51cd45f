/// The report's last sheets: what instructors and examiners said, whole. Thread: GUI, or any without a window.
#pragma once

#include <functional>
#include <vector>

#include "ui/report/report_data.h"
#include "ui/widgets/paper.h"

namespace cusp::ui {

/// On as many sheets as the remarks need; none without remarks. `begin_sheet`: a new sheet with its head and
/// its foot, which begins below `bottom`, in the painter's units.
void write_remarks(const std::vector<Remark>& remarks, double bottom, const std::function<Paper()>& begin_sheet);

}  // namespace cusp::ui
