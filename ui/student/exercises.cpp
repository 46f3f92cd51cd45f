#include "ui/student/exercises.h"

#include <fstream>

#include "scenarios/format/read.h"
#include "scenarios/library/library.h"

namespace cusp {

const Exercise* ExerciseList::find(ScenarioId id) const {
  for (const Exercise& e : exercises) {
    if (e.scenario.id == id) return &e;
  }
  return nullptr;
}

Stored<ExerciseList> load_exercises(Store& store) {
  ExerciseList list;
  for (const std::string_view key : builtin_scenarios()) {
    auto scenario = load_builtin(key);
    if (scenario) list.exercises.push_back({std::move(*scenario), {}, 1, {}});
  }
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
      // The program's own may be newer than what was last played here: then it is published when it is played.
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
  if (error) return fail(StorageError::io, folder.string(), error.message());
  for (const auto& [name, hash] : exercise.files) {
    const std::filesystem::path file = folder / std::filesystem::path(name).filename();
    if (std::filesystem::exists(file, error)) continue;
    const auto bytes = store.blobs.get(hash);
    if (!bytes) return std::unexpected(bytes.error());
    // Written beside and renamed: a half file would be taken for the whole one next time.
    const std::filesystem::path part = file.string() + ".part";
    std::ofstream out(part, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    out.close();
    if (!out) return fail(StorageError::disk_full, file.string());
    std::filesystem::rename(part, file, error);
    if (error) return fail(StorageError::io, file.string(), error.message());
  }
  return folder;
}

}  // namespace cusp
