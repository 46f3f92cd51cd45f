/// Names of the measurement groups of scenarios/metrics/groups.h. Private to ui/text.
#pragma once

#include <QString>
#include <string>

namespace cusp::ui {

/// Empty for a key of no group.
QString group_metric_name(const std::string& metric);
/// What to do next time, for a criterion of a group that lost points; empty for any other. `too_little`: the value is below
/// what earns full points.
QString group_advice(const std::string& metric, bool too_little);

}  // namespace cusp::ui
