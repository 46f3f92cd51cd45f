/// The rollback counter: a small signed file beside the station's key with the audit log's length and last link. Old rows
/// restored with their old heads, or a whole old file, verify on their own; the counter shows that the log was longer.
///
/// The counter is written after the commit: it lags behind the log if a write failed, and never leads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "storage/records/context.h"

namespace cusp::storage {

struct RollbackCounter {
  Uuid station{};
  Hash256 key{};    // id of the key that signed
  ChainHead log{};  // of the audit log when the counter was written; link: zeros for an empty log
  Signature signature{};
};

/// "station.db.key" has "station.db.key-counter".
std::filesystem::path counter_file_of(const std::filesystem::path& key_file);

/// nullopt if there is no file; corrupt if the file holds no counter.
Stored<std::optional<RollbackCounter>> read_counter(const std::filesystem::path& file);
/// Replaces the file whole. Pre: the caller holds the database's write lock.
Stored<void> write_counter(const std::filesystem::path& file, const StationKey& key, const Uuid& station,
                           const ChainHead& log);

enum class CounterState : std::uint8_t {
  good,         // the log holds what the counter saw, and perhaps more
  missing,      // no file
  broken,       // not a counter, of another station, or its signature does not hold
  rolled_back,  // the log lacks entries that the counter saw, or has others in their place
};
struct CounterCheck {
  CounterState state = CounterState::good;
  std::uint64_t counted = 0;  // entries that the counter saw
  ChainHead log{};            // of the log now
};

/// Compares the counter with the log. Fails if the file exists and cannot be read.
Stored<CounterCheck> check_counter(StorageContext& context);

}  // namespace cusp::storage
