/// An exercise of the library as one file, and such a file as a draft of the actor's. No widget, no text. Thread: the store's.
#pragma once

#include <filesystem>

#include "scenarios/library/exercise_file.h"
#include "storage/store.h"
#include "ui/editor/editor_model.h"
#include "ui/instructor/library_model.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The published version of a row; its draft if it has none. Reads the volume from the records or from beside the draft.
Stored<ExerciseFile> file_of(Store& store, const LibraryRow& row, const std::filesystem::path& database);

/// What the station has of the exercise in a file, by its id.
enum class Standing : std::uint8_t {
  unknown,    // nothing
  same,       // the published version, or the actor's draft, with the same values and volume
  different,  // another content
};
/// `row`: the library's row of that id; nullptr without one.
Stored<Standing> standing_of(Store& store, const ExerciseFile& file, const LibraryRow* row, const std::filesystem::path& database);

enum class KeepId : std::uint8_t { no, yes };

/// Saves the exercise as a draft that was never published, and its volume beside it. KeepId::yes only if the id is unknown here;
/// else the title is that of a copy. Leaves the volume of another's draft: one of the same name gets a number.
Stored<EditorStart> take_in(Store& store, const Actor& actor, const ExerciseFile& file, KeepId keep,
                            const std::filesystem::path& database);

}  // namespace cusp::ui
