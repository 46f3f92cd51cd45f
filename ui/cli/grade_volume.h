/// cusp grade SCENARIO --volume FILE: a prepared volume, graded by an exercise's rubric without a session.
#pragma once

#include <string>

#include "ui/cli/verb.h"

namespace cusp::ui {

struct GradeVolumeOptions {
  std::string scenario, volume, rubric;
  std::string out;  // folder for report.json, or empty
};

/// Exit status of the verb. What only a session knows (time, force) is not measured. Seconds; stores nothing.
int grade_volume(const GradeVolumeOptions& options, const JsonOption& json);

}  // namespace cusp::ui
