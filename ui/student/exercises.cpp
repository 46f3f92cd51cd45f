#include "ui/student/exercises.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "scenarios/format/read.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/whole_file.h"
#include "scenarios/library/library.h"
#include "storage/base/files.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

/// Those that come with the program. The first call reads them.
const std::vector<Exercise>& builtin_exercises() {
  static const std::vector<Exercise> all = [] {
    std::vector<Exercise> out;
    for (const std::string_view key : builtin_scenarios())
      if (auto scenario = load_builtin(key)) out.push_back({std::move(*scenario), {}, 1, {}});
    return out;
  }();
  return all;
}

}  // namespace

int number_of(const Exercise& exercise) { return exercise.version.is_nil() ? exercise.scenario.version : exercise.version_number; }

bool asks_for_time(const Scenario& scenario) {
  return std::ranges::any_of(scenario.rubric.criteria, [](const Criterion& one) { return one.metric == "time"; });
}

Stored<void> write_beside(const std::filesystem::path& file, const std::vector<std::byte>& bytes) {
  const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  if (auto done = write_whole_file(file, text); !done) return std::unexpected(failure_from(done.error(), file));
  return {};
}

void read_builtin_exercises() { static_cast<void>(builtin_exercises()); }

const Exercise* ExerciseList::find(ScenarioId id) const {
  for (const Exercise& e : exercises) {
    if (e.scenario.id == id) return &e;
  }
  return nullptr;
}

Stored<Exercise> load_exercise(Store& store, VersionId id) {
  const auto version = store.scenarios.version(id);
  if (!version) return std::unexpected(version.error());
  auto scenario = read_scenario(version->json);
  if (!scenario) return fail(StorageError::bad_value, scenario.error().where, id.text());
  return Exercise{std::move(*scenario), version->id, version->number, version->files};
}

Stored<ExerciseList> load_exercises(Store& store) {
  ExerciseList list{builtin_exercises(), {}};
  const auto stored = store.scenarios.library();
  if (!stored) return std::unexpected(stored.error());
  for (const ScenarioVersion& version : *stored) {
    auto scenario = read_scenario(version.json);
    if (!scenario) {
      list.unreadable.push_back({StorageError::bad_value, scenario.error().where, version.id.text()});
      continue;
    }
    Exercise fresh{std::move(*scenario), version.id, version.number, version.files};
    bool replaced = false;
    for (Exercise& e : list.exercises) {
      if (e.scenario.id != version.scenario) continue;
      // The built-in version may be newer than the stored one; playing it publishes it.
      if (e.scenario.version <= version.number) e = fresh;
      replaced = true;
    }
    if (!replaced) list.exercises.push_back(std::move(fresh));
  }
  return list;
}

Stored<std::filesystem::path> exercise_folder(Store& store, const Exercise& exercise,
                                              const std::filesystem::path& cache) {
  if (exercise.files.empty()) return std::filesystem::path{};
  const std::filesystem::path folder = cache / exercise.version.text();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return std::unexpected(failure_from(error, folder));
  for (const auto& [name, hash] : exercise.files) {
    const std::filesystem::path file = folder / std::filesystem::path(name).filename();
    // No volume is empty: such a file is what a power cut has left of one.
    if (const auto size = std::filesystem::file_size(file, error); !error && size > 0) continue;
    const auto bytes = store.blobs.get(hash);
    if (!bytes) return std::unexpected(bytes.error());
    if (auto written = write_beside(file, *bytes); !written) return std::unexpected(written.error());
  }
  return folder;
}

std::map<std::uint8_t, std::string> tissue_names_in(const std::filesystem::path& folder, const Scenario& scenario) {
  const SpecimenSource& source = scenario.specimen;
  if (!source.generator.empty() || source.volume.empty()) return {};
  return nrrd_names(folder / source.volume);
}

}  // namespace cusp::ui
