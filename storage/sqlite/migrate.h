/// Schema versions: numbered SQL files of storage/sqlite/migrations, embedded at build time. Each runs in one
/// transaction that also sets user_version. A landed migration is never edited.
#pragma once

#include <span>
#include <string_view>

#include "storage/base/error.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Brings the file up to `migrations.size()`. newer_schema if it is past that. If a migration fails, the file stays at the
/// version before it.
Stored<void> migrate(Database& database, std::span<const std::string_view> migrations = built_in_migrations());

}  // namespace cusp::storage
