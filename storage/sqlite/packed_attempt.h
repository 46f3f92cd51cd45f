/// A graded attempt in 48 bytes, and the SQL aggregate that writes many of them into one BLOB:
///   pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, scripted, released)
/// gives one PackedAttempt a row, in ascending order of their bytes, so that the same rows give the same BLOB. NULL without a row.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "engine/base/ids.h"

struct sqlite3;

namespace cusp::storage {

struct PackedAttempt {
  std::int64_t started_utc_us = 0;
  Uuid student{};
  double score = 0;
  double pass_mark = 0;    // NaN = none
  std::uint64_t rest = 0;  // elapsed µs from bit 24 on, attempt number from bit 8 on, flags; greater numbers count as the greatest

  static constexpr std::uint64_t kPassed = 1, kScripted = 2, kReleased = 4;
  static constexpr std::uint64_t kMostElapsedUs = (std::uint64_t{1} << 40) - 1, kMostAttempt = 0xFFFF;
  std::uint64_t elapsed_us() const noexcept { return rest >> 24; }
  int attempt() const noexcept { return static_cast<int>(rest >> 8 & kMostAttempt); }
  bool has(std::uint64_t flag) const noexcept { return (rest & flag) != 0; }
};
// The BLOB holds these bytes as they stand.
static_assert(sizeof(PackedAttempt) == 48 && std::endian::native == std::endian::little);

/// Calls `each(const PackedAttempt&)` for every whole attempt in `bytes`.
template <class Each>
void unpack_attempts(std::span<const std::byte> bytes, Each&& each) {
  for (; bytes.size() >= sizeof(PackedAttempt); bytes = bytes.subspan(sizeof(PackedAttempt))) {
    PackedAttempt attempt;
    std::memcpy(&attempt, bytes.data(), sizeof attempt);
    each(attempt);
  }
}

/// Makes pack_attempts known to a connection. Without memory for it a statement that names it fails.
void add_pack_attempts(sqlite3* connection) noexcept;

}  // namespace cusp::storage
