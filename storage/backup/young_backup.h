/// Whether the station has a daily backup that is young enough. Thread: the context's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "storage/backup/backup.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// The station's daily backup in the folder that is younger than `age_us`; nullopt: none is, or the folder cannot be read. The log has to
/// show it, too: if the clock was set back by more than an hour since, as where it starts at the same date each time, the age is unknown, and
/// the backup counts as old. If it was months behind and has been set since, as by the network after a start, the backup is younger than the
/// entry before it. Reads the log back to its entry, or as far as `age_us`, or half a day of what is older than a month.
Stored<std::optional<Backup>> young_daily_backup(StorageContext& context, const std::filesystem::path& into, std::int64_t age_us);

}  // namespace cusp::storage
