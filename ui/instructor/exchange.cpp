#include "ui/instructor/exchange.h"

#include "scenarios/format/write.h"
#include "storage/base/files.h"
#include "ui/editor/draft_folder.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/free_name.h"
#include "ui/editor/texts_form.h"
#include "ui/modules.h"
#include "ui/session/file_bytes.h"
#include "ui/student/exercises.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

Stored<ExerciseFile> file_of_draft(const Scenario& draft, const fs::path& database) {
  ExerciseFile out{draft, {}};
  if (!draft.specimen.generator.empty()) return out;
  auto bytes = bytes_of(drafts_folder(database, draft.id) / draft.specimen.volume);
  if (!bytes) return std::unexpected(bytes.error());
  out.volume = std::move(*bytes);
  return out;
}

Stored<ExerciseFile> file_of_published(Store& store, const Exercise& exercise) {
  ExerciseFile out{exercise.scenario, {}};
  if (!exercise.scenario.specimen.generator.empty()) return out;
  const auto named = exercise.files.find(exercise.scenario.specimen.volume);
  if (named == exercise.files.end()) return fail(StorageError::not_found, exercise.scenario.specimen.volume);
  auto volume = store.blobs.get(named->second);
  if (!volume) return std::unexpected(volume.error());
  out.volume = std::move(*volume);
  return out;
}

/// The number of a version and the name of a volume's file are the station's own, and a key names an exercise of the program.
bool same_content(const ExerciseFile& a, const ExerciseFile& b) {
  Scenario as_b = a.scenario;
  as_b.version = b.scenario.version;
  as_b.key = b.scenario.key;
  as_b.specimen.volume = b.scenario.specimen.volume;
  return as_b == b.scenario && a.volume == b.volume;
}

bool holds(const fs::path& file, const std::vector<std::byte>& bytes) {
  const auto here = bytes_of(file, bytes.size());
  return here && *here == bytes;
}

/// Under the file's own name for it. A number follows if a draft has another volume of that name: instructors share the folder.
Stored<std::string> keep_volume(const ExerciseFile& file, const fs::path& folder) {
  return write_under_free_name(folder, file.scenario.specimen.volume,
                               {[&file](const fs::path& there) { return holds(there, file.volume); },
                                [&file](const fs::path& fresh) { return write_beside(fresh, file.volume); }});
}

/// Makes the folder, and holds it.
Stored<std::shared_ptr<const void>> folder_for_volume(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(error_from_errno(error.value()), folder.string(), error.message());
  return hold_folder(folder);
}

}  // namespace

Stored<ExerciseFile> file_of(Store& store, const LibraryRow& row, const fs::path& database) {
  return row.exercise ? file_of_published(store, *row.exercise) : file_of_draft(*row.draft, database);
}

Stored<Standing> standing_of(Store& store, const ExerciseFile& file, const LibraryRow* row, const fs::path& database) {
  if (row == nullptr) {
    const auto versions = store.scenarios.versions(file.scenario.id);  // withdrawn ones
    if (!versions) return std::unexpected(versions.error());
    return versions->empty() ? Standing::unknown : Standing::different;
  }
  if (row->exercise) {
    const auto here = file_of_published(store, *row->exercise);
    if (!here) return std::unexpected(here.error());
    if (same_content(file, *here)) return Standing::same;
  }
  if (row->draft) {
    // A draft whose volume is gone is another content.
    if (const auto here = file_of_draft(*row->draft, database); here && same_content(file, *here)) return Standing::same;
  }
  return Standing::different;
}

Stored<EditorStart> take_in(Store& store, const Actor& actor, const ExerciseFile& file, KeepId keep, const fs::path& database) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  Scenario draft = file.scenario;
  if (keep == KeepId::no) {
    draft.id = ScenarioId::make();
    draft.title = title_of_copy(draft.title);
  }
  draft.key.clear();
  draft.version = 1;
  std::shared_ptr<const void> held;  // until the draft stands: another window may discard one of this id
  if (!file.volume.empty()) {
    const fs::path folder = drafts_folder(database, draft.id);
    auto made = folder_for_volume(folder);
    if (!made) return std::unexpected(made.error());
    held = std::move(*made);
    auto name = keep_volume(file, folder);
    if (!name) return std::unexpected(name.error());
    draft.specimen.volume = std::move(*name);
  }
  const std::string json = canonical_json(draft);
  const auto saved = store.scenarios.save_draft(actor, draft.id, json, std::nullopt);
  if (!saved) return std::unexpected(saved.error());
  if (*saved == DraftSave::changed_elsewhere) return fail(StorageError::duplicate, "scenario_drafts");
  return open_draft(draft, json, database);
}

}  // namespace cusp::ui
