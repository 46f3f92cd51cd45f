/// The text of report.json: keys are fixed, names in the installed language. Needs no window.
#pragma once

#include <string>

#include "scenarios/grading/report_json.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"

namespace cusp::ui {

std::string report_text(const SessionResult& result, Store& store, const Account& student);

/// Names and reasons of a report's criteria, in the installed language. `result` outlives them.
ReportTexts report_texts(const SessionResult& result);

}  // namespace cusp::ui
