/// The report's table of criteria on paper. Thread: GUI, or any without a window.
#pragma once

#include <functional>

#include "ui/report/report_data.h"
#include "ui/widgets/paper.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

inline constexpr double kCriteriaRow = 18;  // px of the screen at 100 %: a line of the table

/// Begins another sheet if what is `needed`, in the painter's units, does not fit above the foot; true if it did.
using MakeRoom = std::function<bool(double needed)>;

/// A row is as high as its highest text: one that is wider than its column takes a second line. A new sheet repeats the heads.
void write_criteria(Paper& paper, const ReportData& data, const Tokens& tokens, const MakeRoom& make_room);

}  // namespace cusp::ui
