/// What the standard library cannot say about files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "storage/error.h"

namespace cusp::storage {

/// Whether the folder lies on NFS, SMB or another drive shared between machines. A path that cannot be asked: false.
bool on_network_drive(const std::filesystem::path& folder);

/// Whether this process may write the file, or make files in the folder.
bool can_write(const std::filesystem::path& path);

/// Writes a file that only its owner can read, on the disk before it returns, never half there. duplicate when the
/// file exists.
Stored<void> write_private_file(const std::filesystem::path& file, const std::string& content);
/// The same for a file that may be there: the old one or the whole new one. One writer at a time.
Stored<void> replace_private_file(const std::filesystem::path& file, const std::string& content);
/// nullopt when there is none.
Stored<std::optional<std::string>> read_private_file(const std::filesystem::path& file);

}  // namespace cusp::storage
