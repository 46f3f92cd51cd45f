/// Names of the measurement groups of scenarios/metrics/groups.h. Private to ui/text.
#pragma once

#include <QString>
#include <cstdint>
#include <string>

namespace cusp::ui {

/// Empty for a key of no group.
QString group_metric_name(const std::string& metric);
/// On which side of what earns full points a value lies.
enum class OffBy : std::uint8_t { too_little, too_much };
/// What to do next time, for a criterion of a group that lost points; empty for any other.
QString group_advice(const std::string& metric, OffBy off);

}  // namespace cusp::ui
