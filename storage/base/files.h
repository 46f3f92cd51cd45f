/// Questions and operations on files that the standard library lacks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "storage/base/error.h"
#include "storage/base/hash.h"

namespace cusp::storage {

/// Whether the folder lies on NFS, SMB or another drive that machines share. False if the system gives no answer.
bool on_network_drive(const std::filesystem::path& folder);

/// Whether this process may write the file, or create files in the folder.
bool can_write(const std::filesystem::path& path);

/// The absolute path that `file` leads to once links are followed, also if nothing is there yet. `file` if the system gives no
/// answer.
std::filesystem::path behind_links(const std::filesystem::path& file);

/// The cause that an errno names: disk_full, quota_exceeded, file_too_large, out_of_memory, read_only, not_found,
/// duplicate, else io.
StorageError error_from_errno(int error) noexcept;

/// What the standard library reports about `where`.
StorageFailure failure_from(const std::error_code& error, const std::filesystem::path& where);

/// Makes an empty file that only its owner can read, without opening it: a close() drops SQLite's locks. duplicate if it exists.
Stored<void> make_private_file(const std::filesystem::path& file);
/// Makes a folder that only its owner can enter, and syncs the one that it lies in. duplicate if the name is taken.
Stored<void> make_private_folder(const std::filesystem::path& folder);

/// Renames `from` to `to`, in one file system, and syncs the folder. duplicate if `to` exists; `from` then stays. A process that is killed
/// leaves `to` whole or not there. On a drive with neither links nor RENAME_NOREPLACE (old FUSE drivers), a file that another program
/// than Cusp creates in that very moment is replaced.
Stored<void> rename_new(const std::filesystem::path& from, const std::filesystem::path& to);

/// Writes a file that only its owner can read; synced when it returns, never half written. duplicate if the file exists.
Stored<void> write_private_file(const std::filesystem::path& file, const std::string& content);
/// Removes what a write_private_file() of `file` left whose process was killed: of the names "station.db.key.a1B2c3", with six letters or
/// digits, each second name of `file`, and each empty file. Another whole file stays, for people copy keys under such names. Touches regular
/// files of this process's user alone, and none that a process is writing. Failures are ignored.
void remove_left_writes(const std::filesystem::path& file);
/// Writes a new file for the readers whom the umask admits; synced when it returns. duplicate if the file exists. A failure may leave a part.
Stored<void> write_new_file(const std::filesystem::path& file, std::string_view content);
/// Like write_private_file() for a file that may exist: readers see the old content or the whole new one. One writer at a time.
Stored<void> replace_private_file(const std::filesystem::path& file, const std::string& content);
/// nullopt if the file does not exist. A pipe or a device fails at once.
Stored<std::optional<std::string>> read_private_file(const std::filesystem::path& file);
/// blake2b_256 of a file of any size, read in blocks. A pipe or a device fails at once.
Stored<Hash256> hash_of_file(const std::filesystem::path& file);

}  // namespace cusp::storage
