/// What `cusp export --gradebook` writes. Thread: the one that owns the store.
#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"
#include "storage/export/gradebook.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

struct GradebookWish {
  Gradebook system = Gradebook::moodle;
  CohortId cohort{};
  std::string exercise;                // its key or id, as typed
  std::optional<int> version{};        // of the exercise
  // These tell assignments of the exercise apart.
  std::optional<SessionKind> kind{};   // practice or assessment
  std::optional<std::string> due{};    // the day or second, or kNoDueDate
  std::string cohort_typed;            // for messages
};
inline constexpr const char* kNoDueDate = "none";

/// By its id or, of those that come with the program, its key.
[[nodiscard]] Stored<bool> is_called(Store& store, const ScenarioId& exercise, const std::string& typed);

struct AssignedGradebook {
  AssignmentId assignment{};
  GradebookFile file{};
};
/// Results of the one assignment that the wish names. A message where there is none, or more than one.
[[nodiscard]] Result<AssignedGradebook, Message> gradebook_of(Store& store, const Actor& actor, const GradebookWish& wish);

}  // namespace cusp::ui
