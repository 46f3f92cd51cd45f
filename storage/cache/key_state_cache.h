/// Key states of sessions, as files in the folder "station.db.states" beside the database. A cache: replay rebuilds what is
/// missing, and a caller compares a state's hash with the chained one before it uses the state.
/// The folder lies beside the database, because a user's cache folder may lie in a home that several stations share.
/// Thread: the store's. Several stores and processes may use one folder. A failure here does not fail the session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "storage/records/context.h"
#include "storage/repositories/traces.h"

namespace cusp::storage {

class KeyStateCache {
 public:
  /// Space for the states of about seven ten-minute sessions (0.6 MB each 5 s).
  static constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;
  /// keep_rebuilt() writes nothing if less is free on the disk: the records need it.
  static constexpr std::uint64_t kLeaveFree = std::uint64_t{256} << 20;

  explicit KeyStateCache(StorageContext& context) : c_{context} {}

  /// For the running session: keeps this state and the one before it, and removes older ones.
  Stored<void> keep_live(SessionId session, const KeyState& state);
  /// For a replay. Above the limit it removes the oldest rebuilt states, then the oldest of all. disk_full, detail
  /// "reserve", if less than kLeaveFree is free.
  Stored<void> keep_rebuilt(SessionId session, const KeyState& state);
  /// For a graded session: its states count as rebuilt ones.
  void release(SessionId session);
  /// Removes all rebuilt states, to free space on a full disk.
  void make_room();

  /// Ticks of the files that exist, rising. A file may still be damaged.
  std::vector<std::uint64_t> ticks(SessionId session) const;
  /// nullopt: missing, damaged, or of another session or station. Removes a file that it cannot use.
  std::optional<KeyState> read(SessionId session, std::uint64_t tick);
  /// Removes a state whose hash differs from the chained one.
  void drop(SessionId session, std::uint64_t tick);

  std::filesystem::path folder() const;
  void limit(std::uint64_t most_bytes) { most_bytes_ = most_bytes; }

 private:
  Stored<void> write(SessionId session, const KeyState& state, const char* ending);
  void trim(const std::filesystem::path& fresh) const;
  Hash256 seal(const std::vector<std::byte>& body) const;
  std::optional<KeyState> unsealed(std::vector<std::byte> body, SessionId session, std::uint64_t tick) const;

  StorageContext& c_;
  std::uint64_t most_bytes_ = kMostBytes;
};

}  // namespace cusp::storage
