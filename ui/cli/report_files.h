/// report.json, report.pdf and tooth.png of an attempt.
#pragma once

#include <filesystem>
#include <optional>
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

/// A line of stdout for each criterion, its points as people read them: they sum to the grade's, whatever version graded.
/// `own`: the names that the tooth's volume gives its tissues.
void print_criteria(const Grade& grade, const std::string& indent, const Region* whole = nullptr, const TissueNames& own = {});

/// Points and result on one line of stdout, then critical events and criteria.
void print_grade(const SessionResult& result);

/// The result that counts and each change of an examiner, then the measured result, named so, with its criteria.
void print_changed_grade(const EffectiveGrade& counts, const SessionResult& measured, Store& store);

/// What a report is made for. `changed`: what counts, if an examiner changed the stored result.
struct ReportOrder {
  Account student;
  Actor reader;
  std::optional<EffectiveGrade> changed{};
};

/// The names of those files.
std::vector<std::filesystem::path> report_files_in(const std::filesystem::path& folder);

/// The text of report.json: the measured result; with `changed` also an object "effective" with the result that counts.
std::string report_file_text(const SessionResult& result, Store& store, const ReportOrder& order);

/// Each file whole or not at all. The page shows the result that counts. Needs a QGuiApplication for it.
Result<void, Message> write_report_files(const std::filesystem::path& folder, const SessionResult& result, Store& store,
                                         const ReportOrder& order);

/// report.pdf and tooth.png alone. Needs a QGuiApplication.
Result<void, Message> write_paper(const std::filesystem::path& folder, const ReportData& data);

}  // namespace cusp::ui
