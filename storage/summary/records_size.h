/// How much the records hold, as the station's page shows it.
#pragma once

#include <cstdint>

#include "storage/sqlite/database.h"

namespace cusp::storage {

struct RecordsSize {
  std::uint64_t sessions = 0;    // of any state and kind, other stations' included
  std::uint64_t bytes = 0;       // of the database, with what its log still holds
  std::uint64_t page_bytes = 0;  // of one page: make_backup() reports its progress in pages
};

/// Needs no right: it names nobody. Errors: those of reading, as io, corrupt, or bad_statement where the table of sessions is missing.
/// Thread: the connection's. Counts each session.
Stored<RecordsSize> records_size(Database& db);

}  // namespace cusp::storage
