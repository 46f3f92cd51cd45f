/// The editor's records: opens an exercise, saves and discards its draft, publishes. No widget, no text. Thread: GUI.
#pragma once

#include <filesystem>
#include <vector>

#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/modules.h"
#include "ui/student/exercises.h"

namespace cusp::ui {

/// Folder of a draft's volume, one for each exercise, beside the database.
std::filesystem::path drafts_folder(const std::filesystem::path& database, ScenarioId scenario);

/// Opens the actor's draft, or the published version without one, with the number of the next version; a withdrawn
/// version keeps its number. Its volume gets another name where a draft has one of that name. An unreadable draft, perhaps of a
/// newer program, stays in the records: keep_draft() then answers as if another window had changed it. `cache`: folder for the
/// volumes of published versions.
Stored<EditorStart> open_for_editing(Store& store, const Actor& actor, const Exercise& exercise,
                                     const std::filesystem::path& database, const std::filesystem::path& cache);
/// Opens a draft of an exercise that was never published. `json`: the draft in the records.
EditorStart open_draft(const Scenario& draft, const std::string& json, const std::filesystem::path& database);

/// Opens an exercise that was made just now and is grown, not read from a volume. Its draft is not in the records yet.
EditorStart open_new(const Scenario& exercise, const std::filesystem::path& database);

/// Makes a new exercise, with a new id, from another one. Copies its volume beside the draft.
Stored<EditorStart> copy_exercise(Store& store, const Exercise& pattern, const LocalText& title,
                                  const std::filesystem::path& database, const std::filesystem::path& cache);

/// Saves the draft, or discards it if it equals the published version; one that is withdrawn by now stands in no list without a draft.
/// `kept`, in and out: the JSON that this window read or wrote last. If another window has changed the draft, nothing is written.
Stored<DraftSave> keep_draft(Store& store, const Actor& actor, const EditorModel& model, std::optional<std::string>& kept);

/// Saves the draft as a new exercise with a new id, and copies its volume.
Stored<EditorStart> keep_as_copy(Store& store, const Actor& actor, const EditorModel& model, const LocalText& title);

/// Number of the next version.
Stored<int> next_version(Store& store, const EditorModel& model);

/// What publish() writes, apart from the model, which stays with the window.
struct Publication {
  Scenario draft;
  std::filesystem::path folder;      // of its volume
  std::optional<std::string> kept;  // the draft's JSON as keep_draft() has it
};
struct Published {
  ScenarioVersion version;
  Scenario scenario;  // with the version's number
};
/// bad_value if a check fails or nothing changed.
Stored<Publication> publication_of(const EditorModel& model, const std::optional<std::string>& kept);

/// Publishes draft and volume as the next version. A built-in exercise that was never played here first gets its own version with its
/// own number. A draft of another window stays. A volume takes seconds: not on the window's thread.
Stored<Published> publish(Store& store, const Actor& actor, const Publication& what);

}  // namespace cusp::ui
