/// Which exercises there are: those that come with the program, and those published on this station; of each the
/// newest version. No window, no words.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/store.h"
#include "ui/modules.h"

namespace cusp::ui {

struct Exercise {
  Scenario scenario;
  VersionId version;   // nil: not played here yet, comes with the program
  int version_number = 1;
  std::map<std::string, Hash256> files;  // volumes beside it, in Blobs
};

struct ExerciseList {
  std::vector<Exercise> exercises;           // built-in ones first, in the order in which a newcomer meets them
  std::vector<StorageFailure> unreadable;    // stored versions that could not be read; `where` names them
  const Exercise* find(ScenarioId id) const;
};

Stored<ExerciseList> load_exercises(Store& store);

/// Folder in which the exercise's volume lies: its files are written there from the records when they are not yet.
/// Empty for an exercise without files.
Stored<std::filesystem::path> exercise_folder(Store& store, const Exercise& exercise,
                                              const std::filesystem::path& cache);

}  // namespace cusp::ui
