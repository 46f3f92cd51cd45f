/// Who uses an exercise: students with graded attempts at any of its versions, and cohorts that have it assigned now. No widget.
/// Thread: GUI.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "storage/store.h"
#include "ui/editor/publish_facts.h"
#include "ui/modules.h"

namespace cusp::ui {

struct ExerciseUse {
  int students = 0, attempts = 0;  // graded attempts of users, without scripted operators
  std::optional<double> median_score{};
  std::vector<OlderUse> assigned{};  // not over yet
};

Stored<ExerciseUse> use_of(Store& store, const Actor& actor, ScenarioId exercise, std::int64_t now_utc_us);

/// "12 students, 40 graded attempts, median 81 points. Assigned now: Year 3."
QString use_text(const ExerciseUse& use);

}  // namespace cusp::ui
