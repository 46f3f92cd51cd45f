/// The rollback counter: a small signed file beside the station's key that says how far the audit log had got. Rows put
/// back together with their old heads, or a whole old file, are sound in themselves; the counter has seen more.
///
/// It lags behind the log where a write of it failed, and never leads: it is written after the commit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "storage/context.h"

namespace cusp::storage {

struct RollbackCounter {
  Uuid station{};
  Hash256 key{};              // name of the key that signed
  std::uint64_t entries = 0;  // of the audit log when it was written
  Hash256 link{};             // of the last of them; zeros when there was none
  Signature signature{};
};

/// "station.db.key" has "station.db.key-counter".
std::filesystem::path counter_file_of(const std::filesystem::path& key_file);

/// nullopt when there is none; corrupt when it holds no counter.
Stored<std::optional<RollbackCounter>> read_counter(const std::filesystem::path& file);
/// Replaces the file: the old one or the whole new one. Hold the database's write lock.
Stored<void> write_counter(const std::filesystem::path& file, const StationKey& key, const Uuid& station,
                           std::uint64_t entries, const Hash256& link);

enum class CounterState : std::uint8_t {
  good,         // the log holds what the counter saw, and perhaps more
  missing,      // no file
  broken,       // no counter, of another station, or its signature does not hold
  rolled_back,  // the log lacks what the counter saw, or has other entries in its place
};
struct CounterCheck {
  CounterState state = CounterState::good;
  std::uint64_t counted = 0;  // entries that the counter saw
  std::uint64_t entries = 0;  // entries that the log has
  Hash256 link{};             // of the log's last one
};

/// Holds the counter against the log. Fails where the file is there and cannot be read.
Stored<CounterCheck> check_counter(StorageContext& context);

}  // namespace cusp::storage
