/// The moves of a restore: in place, damaged files go to a folder beside; then the copy's files take their names. A process may be killed
/// between any two of them; a note in the copy's folder names those that are due. Within storage only.
/// Thread: any.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "storage/base/error.h"

namespace cusp::storage {

/// A restore's folder beside the new database: a UUID follows.
inline constexpr std::string_view kRestoring = ".cusp-restore-";
/// After the database's name, before the time: the folder of what was damaged.
inline constexpr std::string_view kAside = "-damaged";

/// duplicate if a database, its log, index, journal, key or counter stands at the name.
Stored<void> nothing_beside(const std::filesystem::path& file);
/// All of these that exist, the database first: without it Store::open() looks for a note. After a failure all is where it was.
Stored<void> move_away(const std::filesystem::path& file, const std::filesystem::path& to);
/// The same, the database last: whoever opens it finds key and counter.
Stored<void> move_home(const std::filesystem::path& from, const std::filesystem::path& file);
/// Database, key and counter of the copy get their names, the database last. After a failure none has it.
Stored<void> name_restored(const std::filesystem::path& from, const std::filesystem::path& to);

/// Locked while the process lives that carries out the note.
std::filesystem::path lock_of_half_done(const std::filesystem::path& fresh);
/// Writes the note: `fresh` is to take the name `file` once what stands there is in `aside`; empty: nothing stands there. `process`:
/// ProcessMark::text().
Stored<void> note_half_done(const std::filesystem::path& fresh, const std::filesystem::path& file, const std::filesystem::path& aside,
                            const std::string& process);
/// After a failure that left no name taken, and before the copy's folder goes: a note that outlasts its copy gives the name back to what
/// is in `aside` once no database stands there.
void take_note_back(const std::filesystem::path& fresh);
/// Whether the folder's note is due: no database stands at the name, and `aside` holds it; without one, key or counter has its name.
bool is_half_done(const std::filesystem::path& folder, const std::filesystem::path& file);
/// Removes what restores of the name left that were cut off more than a day ago, and at once any second name of the database.
void remove_left_restores(const std::filesystem::path& file);
/// If a note is due, moves and names the rest. busy while its process lives. False: none was due, as where a database stands, or the copy
/// is gone and `aside` has its name back.
Stored<bool> finish_half_done(const std::filesystem::path& file);

}  // namespace cusp::storage
