/// report.json: what `cusp play` and `cusp grade` leave for other programs.
#pragma once

#include <functional>
#include <string>

#include "scenarios/grading/grade.h"

namespace cusp::scenarios {

struct ReportHead {
  std::string session;                          // UUID
  std::string scenario_id, scenario_hash;
  int scenario_version = 1;
  std::string student;
  std::string operator_name;                    // "expert", "novice", or empty: a student; written as "hand"
  int engine = kEngineVersion;
  std::string device;
  double duration_s = 0;
  std::string state;                            // "finished", "interrupted"
  std::string volume_hash;
};

/// The texts of the file in the reader's language, from ui. An empty function leaves the code.
struct ReportTexts {
  std::function<std::string(const CriterionGrade&)> label, reason;
};

/// UTF-8 JSON with exactly the fields of design.md, in its order, ending in a newline. Numbers are written so that they
/// read back as the same double; what was not measured has value and uncertainty null. Points are scaled_points(): they
/// are what the report shows, and their maxima sum to score_max.
[[nodiscard]] std::string report_json(const ReportHead& head, const Grade& grade, const ReportTexts& texts = {});

}  // namespace cusp::scenarios
