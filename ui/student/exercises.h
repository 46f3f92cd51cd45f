/// The exercises of this station: built-in and published ones, each in its newest version. No widget, no text.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"
#include "storage/store.h"
#include "ui/modules.h"

namespace cusp::ui {

struct Exercise {
  Scenario scenario;
  VersionId version;   // nil for a built-in exercise that was never played here
  int version_number = 1;
  std::map<std::string, Hash256> files;  // its volumes, in Blobs
};

/// The version's number; of a built-in exercise that was never played here, its own.
int number_of(const Exercise& exercise);

struct ExerciseList {
  std::vector<Exercise> exercises;           // built-in ones first, in the order of the course
  std::vector<StorageFailure> unreadable;    // stored versions that cannot be read
  const Exercise* find(ScenarioId id) const;
};

Stored<ExerciseList> load_exercises(Store& store);
/// Reads those that come with the program: load_exercises() is short from then on. Any thread.
void read_builtin_exercises();
/// A stored version. bad_value if its text cannot be read.
Stored<Exercise> load_exercise(Store& store, VersionId version);

/// Folder with the exercise's files, written from the records on first use. Empty for an exercise without files.
Stored<std::filesystem::path> exercise_folder(Store& store, const Exercise& exercise,
                                              const std::filesystem::path& cache);

/// The names that an exercise's volume in `folder` gives its tissues, of the file's header; empty for an exercise without a volume.
std::map<std::uint8_t, std::string> tissue_names_in(const std::filesystem::path& folder, const Scenario& scenario);

/// Whether an attempt's time brings points.
bool asks_for_time(const Scenario& scenario);

/// A WholeFile (scenarios/import/whole_file.h): a failure leaves what was there, and no half file.
Stored<void> write_beside(const std::filesystem::path& file, const std::vector<std::byte>& bytes);

}  // namespace cusp::ui
