/// A row of the history as JSON: keys and codes that no language changes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/export/csv.h"
#include "ui/modules.h"

namespace cusp::ui {

nlohmann::ordered_json row_json(const HistoryRow& row);
/// With the student's name, the finish, and cohort and dates of the assignment besides. Times are ISO 8601, UTC.
nlohmann::ordered_json row_json(const ExportRow& row);

}  // namespace cusp::ui
