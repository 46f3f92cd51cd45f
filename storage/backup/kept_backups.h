/// What lies in a folder of backups: each one's description, their order, and what was cut off. Within storage only; backup.h is what others
/// call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <vector>

#include "storage/backup/backup.h"

namespace cusp::storage {

inline constexpr const char* kBackupDatabase = "station.db";
inline constexpr const char* kBackupKey = "station.db.key";

/// The last file of a backup.
Stored<void> write_description(const Backup& backup);
/// Backup::order of the next one in `into`: the length of the log, or more where a restore has made that shorter.
std::uint64_t next_order(StorageContext& context, const std::filesystem::path& into);
/// The description goes first: a program that is killed here leaves an unfinished folder, and no backup that lacks its key.
std::error_code remove_copy(const std::filesystem::path& folder);
/// Of any station. Each holds a secret key, and room that the next backup needs.
std::vector<std::filesystem::path> abandoned_in(const std::filesystem::path& into);

}  // namespace cusp::storage
