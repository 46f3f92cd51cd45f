#include "ui/editor/editor_records.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/import/whole_file.h"
#include "scenarios/library/library.h"
#include "storage/base/files.h"
#include "ui/editor/free_name.h"
#include "ui/modules.h"
#include "ui/session/file_bytes.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

/// Makes the folder of `to`. The copy is whole or not there: a half one would take a volume's name.
Stored<void> copy_volume(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (error) return std::unexpected(failure_from(error, to.parent_path()));
  WholeFile out(to);
  auto copied = for_pieces(from, kMostVolumeBytes, [&](std::string_view piece) -> Stored<void> {
    if (const auto written = out.write(piece); !written) return std::unexpected(failure_from(written.error(), to));
    return {};
  });
  if (!copied) return copied;
  if (const auto done = out.finish(); !done) return std::unexpected(failure_from(done.error(), to));
  return {};
}

/// Removes the folder of a copy that failed: no draft names it, and each new copy makes one of its own.
std::unexpected<StorageFailure> without_folder(const fs::path& folder, const StorageFailure& why) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return std::unexpected(why);
}

/// Copies the volume of a published version beside the draft: all volumes that a draft names lie in one folder. Returns its name
/// there: a number follows if a draft's volume has the name, as after an exchange with another station.
Stored<std::string> unpack_volume(Store& store, const Exercise& exercise, const fs::path& to, const fs::path& cache) {
  const std::string& volume = exercise.scenario.specimen.volume;
  if (!exercise.scenario.specimen.generator.empty()) return volume;
  const auto from = exercise_folder(store, exercise, cache);
  if (!from) return std::unexpected(from.error());
  std::error_code error;
  fs::create_directories(to, error);
  if (error) return std::unexpected(failure_from(error, to));
  const fs::path there = *from / volume;
  return write_under_free_name(to, volume, {[&there](const fs::path& file) { return hold_the_same(there, file); },
                                            [&there](const fs::path& file) { return copy_volume(there, file); }});
}

/// Whether the version that the model was opened with is withdrawn by now.
Stored<bool> is_withdrawn(Store& store, const EditorModel& model) {
  if (!model.published()) return false;
  const auto versions = store.scenarios.versions(model.scenario().id);
  if (!versions) return std::unexpected(versions.error());
  const auto opened = std::ranges::find(*versions, model.published()->version, &ScenarioVersion::number);
  return opened == versions->end() ? false : store.scenarios.withdrawn(opened->id);
}

}  // namespace

fs::path drafts_folder(const fs::path& database, ScenarioId scenario) {
  return database.parent_path() / (database.stem().string() + "-drafts") / scenario.text();
}

Stored<EditorStart> open_for_editing(Store& store, const Actor& actor, const Exercise& exercise,
                                     const fs::path& database, const fs::path& cache) {
  EditorStart start;
  start.published = exercise.scenario;
  // The records number the versions; the number in the file comes from another station.
  start.published->version = number_of(exercise);
  const fs::path folder = drafts_folder(database, exercise.scenario.id);
  auto volume = unpack_volume(store, exercise, folder, cache);
  if (!volume) return std::unexpected(volume.error());
  start.published->specimen.volume = std::move(*volume);
  start.folder = folder.string();
  start.draft = *start.published;
  const auto draft = store.scenarios.draft(actor, exercise.scenario.id);
  if (!draft) return std::unexpected(draft.error());
  if (*draft) {
    if (auto read = read_scenario((*draft)->json)) {
      start.draft = std::move(*read);
      start.kept = (*draft)->json;
    }
  }
  const auto versions = store.scenarios.versions(start.draft.id);
  if (!versions) return std::unexpected(versions.error());
  start.draft.version = 1 + std::max(start.published->version, versions->empty() ? 0 : versions->back().number);
  return start;
}

EditorStart open_draft(const Scenario& draft, const std::string& json, const fs::path& database) {
  return {draft, std::nullopt, drafts_folder(database, draft.id).string(), json};
}

EditorStart open_new(const Scenario& exercise, const fs::path& database) {
  return {exercise, std::nullopt, drafts_folder(database, exercise.id).string(), std::nullopt};
}

Stored<EditorStart> copy_exercise(Store& store, const Exercise& pattern, const LocalText& title,
                                  const fs::path& database, const fs::path& cache) {
  EditorStart start;
  start.draft = pattern.scenario;
  start.draft.id = ScenarioId::make();
  start.draft.key.clear();
  start.draft.version = 1;
  start.draft.title = title;
  const fs::path folder = drafts_folder(database, start.draft.id);
  auto volume = unpack_volume(store, pattern, folder, cache);
  if (!volume) return without_folder(folder, volume.error());
  start.draft.specimen.volume = std::move(*volume);
  start.folder = folder.string();
  return start;
}

Stored<DraftSave> keep_draft(Store& store, const Actor& actor, const EditorModel& model, std::optional<std::string>& kept) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  const Scenario& s = model.scenario();
  if (model.unchanged()) {
    if (!kept) return DraftSave::kept;
    const auto withdrawn = is_withdrawn(store, model);
    if (!withdrawn) return std::unexpected(withdrawn.error());
    if (!*withdrawn) {
      const auto done = store.scenarios.drop_draft(actor, s.id, *kept);
      if (done && *done == DraftSave::kept) kept.reset();
      return done;
    }
  }
  std::string json = canonical_json(s);
  if (json == kept) return DraftSave::kept;  // nothing to write
  const auto done = store.scenarios.save_draft(actor, s.id, json, kept);
  if (done && *done == DraftSave::kept) kept = std::move(json);
  return done;
}

Stored<EditorStart> keep_as_copy(Store& store, const Actor& actor, const EditorModel& model, const LocalText& title) {
  EditorStart start;
  start.draft = model.scenario();
  start.draft.id = ScenarioId::make();
  start.draft.key.clear();
  start.draft.version = 1;
  start.draft.title = title;
  const fs::path from = model.folder(), to = from.parent_path() / start.draft.id.text();
  start.folder = to.string();
  if (const std::string& volume = start.draft.specimen.volume; start.draft.specimen.generator.empty()) {
    if (const auto copied = copy_volume(from / volume, to / volume); !copied) return without_folder(to, copied.error());
  }
  start.kept = canonical_json(start.draft);
  const auto done = store.scenarios.save_draft(actor, start.draft.id, *start.kept, std::nullopt);
  if (!done) return without_folder(to, done.error());
  return start;
}

Stored<int> next_version(Store& store, const EditorModel& model) {
  const auto versions = store.scenarios.versions(model.scenario().id);
  if (!versions) return std::unexpected(versions.error());
  // The built-in exercise becomes the first version.
  if (versions->empty()) return model.published() ? model.published()->version + 1 : 1;
  return versions->back().number + 1;
}

Stored<Publication> publication_of(const EditorModel& model, const std::optional<std::string>& kept) {
  if (!model.publishable()) return fail(StorageError::bad_value, "scenario.json");
  return Publication{model.scenario(), model.folder(), kept};
}

Stored<Published> publish(Store& store, const Actor& actor, const Publication& what) {
  if (auto allowed = require(actor, Action::edit_scenarios); !allowed) return std::unexpected(allowed.error());
  if (const auto builtin = load_builtin(what.draft.key); builtin && builtin->id == what.draft.id) {
    auto first = store.scenarios.ensure(*builtin, canonical_json(*builtin), content_hash(*builtin).bytes);
    if (!first) return std::unexpected(first.error());
  }
  const auto versions = store.scenarios.versions(what.draft.id);
  if (!versions) return std::unexpected(versions.error());
  Scenario fresh = what.draft;
  fresh.version = versions->empty() ? 1 : versions->back().number + 1;
  std::map<std::string, std::vector<std::byte>> beside;
  std::map<std::string, Hash256> files;
  if (const std::string& volume = fresh.specimen.volume; fresh.specimen.generator.empty()) {
    auto bytes = bytes_of(what.folder / volume);
    if (!bytes) return std::unexpected(bytes.error());
    const auto kept = store.blobs.put(*bytes);
    if (!kept) return std::unexpected(kept.error());
    files[volume] = *kept;
    beside[volume] = std::move(*bytes);
  }
  auto version = store.scenarios.publish(actor, fresh, canonical_json(fresh), content_hash(fresh, beside).bytes, files, what.kept);
  if (!version) return std::unexpected(version.error());
  return Published{std::move(*version), std::move(fresh)};
}

}  // namespace cusp::ui
