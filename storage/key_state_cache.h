/// Key states of sessions as files in a folder beside the database, never in it: "station.db.states". A cache: replay
/// rebuilds what is missing, and a caller compares a state's hash with the chained one before it believes it.
/// Beside the database, because there it is as local as the database itself (a network drive is refused), while a user's
/// cache folder may lie in a home that several stations share.
/// Thread: the store's. Several stores and processes may use one folder. No failure here is a failure of the session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "storage/context.h"
#include "storage/repositories/traces.h"

namespace cusp::storage {

class KeyStateCache {
 public:
  /// Room for the states of about seven ten-minute sessions (0.6 MB each 5 s).
  static constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;
  /// What rebuilt states leave free on the disk: the records come first.
  static constexpr std::uint64_t kLeaveFree = std::uint64_t{256} << 20;

  explicit KeyStateCache(StorageContext& context) : c_{context} {}

  /// Of the session that runs: this one and the newest before it stay, older ones go.
  Stored<void> keep_live(SessionId session, const KeyState& state);
  /// Of a replay. Makes room for itself: first go the oldest that a replay left, then the oldest of all.
  Stored<void> keep_rebuilt(SessionId session, const KeyState& state);
  /// The session is graded: its states are worth no more than rebuilt ones.
  void release(SessionId session);
  /// Removes all that a replay can rebuild of graded sessions: the disk is full.
  void make_room();

  /// Ticks of the states that are there, rising. They may still turn out damaged.
  std::vector<std::uint64_t> ticks(SessionId session) const;
  /// nullopt: none, or damaged, or of another session or station; what cannot be used is removed.
  std::optional<KeyState> read(SessionId session, std::uint64_t tick);
  /// Removes a state that proved to be another than the chained one.
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
