/// report.json, report.pdf and tooth.png of an attempt.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/report/report_data.h"
#include "ui/report/report_text.h"
#include "ui/session/exercise_session.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

/// "report.json cannot be written."
Message cannot_write(const std::filesystem::path& file);

/// A line of stdout for each criterion, its points as people read them: they sum to the grade's, whatever version graded.
void print_criteria(const Grade& grade, const std::string& indent, const Region* whole = nullptr);

/// Points and result on one line of stdout, then critical events and criteria.
void print_grade(const Grade& grade, const Region& whole);

/// The names of those files.
std::vector<std::filesystem::path> report_files_in(const std::filesystem::path& folder);

/// Each file whole or not at all. Needs a QGuiApplication for the page.
Result<void, Message> write_report_files(const std::filesystem::path& folder, const SessionResult& result, Store& store,
                                         const Account& student);

/// report.pdf and tooth.png alone. Needs a QGuiApplication.
Result<void, Message> write_paper(const std::filesystem::path& folder, const ReportData& data);

}  // namespace cusp::ui
