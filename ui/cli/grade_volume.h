/// cusp grade SCENARIO --volume FILE | --operator NAME: a prepared volume, graded by an exercise's rubric without a session.
#pragma once

#include <string>

#include "ui/cli/verb.h"

namespace cusp::ui {

struct GradeVolumeOptions {
  std::string scenario, rubric;
  std::string volume;         // a file, or
  std::string operator_name;  // whose cuts are made at once (scenarios/operators/fast_cut.h)
  std::string out;            // folder for report.json, and tooth.png of an operator's; or empty
};

/// Exit status of the verb. What only a session knows (time, force) is not measured. Seconds; stores nothing.
int grade_volume(const GradeVolumeOptions& options, const JsonOption& json);

}  // namespace cusp::ui
