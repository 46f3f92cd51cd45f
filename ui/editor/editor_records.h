/// Between the editor and what is kept: opening an exercise for editing, its draft, publishing. No widget, no words.
#pragma once

#include <filesystem>

#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/modules.h"
#include "ui/student/exercises.h"

namespace cusp::ui {

/// Where an exercise's own volume lies while it is a draft: a folder for each exercise, beside the database.
std::filesystem::path drafts_folder(const std::filesystem::path& database, ScenarioId scenario);

/// The actor's draft of it where there is one, else what is published; what would be published next has the next number.
/// A draft that does not read is left aside. `cache`: where volumes of published versions are unpacked.
Stored<EditorStart> open_for_editing(Store& store, const Actor& actor, const Exercise& exercise,
                                     const std::filesystem::path& database, const std::filesystem::path& cache);
/// A draft of an exercise that was never published. `json`: as the records hold it.
EditorStart open_draft(const Scenario& draft, const std::string& json, const std::filesystem::path& database);

/// A new exercise that begins as a copy of another one; an identity of its own. A volume is copied beside the draft.
Stored<EditorStart> copy_exercise(Store& store, const Exercise& pattern, const LocalText& title,
                                  const std::filesystem::path& database, const std::filesystem::path& cache);

/// Keeps the draft; takes it away when it equals what is published. `kept`: the draft's JSON as this window has read or
/// written it last, and from now on. Where another window has changed it, nothing is written.
Stored<DraftSave> keep_draft(Store& store, const Actor& actor, const EditorModel& model, std::optional<std::string>& kept);

/// The draft as it stands, kept as a new exercise with an identity of its own; a volume is copied with it.
Stored<EditorStart> keep_as_copy(Store& store, const Actor& actor, const EditorModel& model, const LocalText& title);

/// The number that publishing would give now.
Stored<int> next_version(Store& store, const EditorModel& model);

/// Publishes the draft as the next version, its volume with it. bad_value when a check fails or nothing was changed.
/// A built-in exercise that was never played here gets its own version first, so that its number stays its own. `draft`:
/// as `kept` of keep_draft; another window's draft stays.
Stored<ScenarioVersion> publish(Store& store, const Actor& actor, EditorModel& model, std::optional<std::string>& draft);

}  // namespace cusp::ui
