/// A graded attempt in 48 bytes, and the SQL aggregate that writes many of them into one BLOB:
///   pack_attempts(started_at, student, score, pass_mark, elapsed_us, attempt, passed, scripted, released, version_number, assessment)
/// gives one PackedAttempt a row, in ascending order of their bytes, so that the same rows give the same BLOB. NULL without a row.
/// The tenth and the fourteenth migration leave the last arguments out; the eighteenth writes their rows anew.
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
  std::uint64_t rest = 0;  // numbers from their bits on, below them flags; a number that is too great counts as the greatest

  static constexpr std::uint64_t kPassed = 1, kScripted = 2, kReleased = 4, kAssessment = 8;
  static constexpr int kAttemptBit = 4, kVersionBit = 16, kElapsedBit = 28;
  static constexpr std::uint64_t kMostAttempt = 0xFFF, kMostVersion = 0xFFF, kMostElapsedUs = (std::uint64_t{1} << 36) - 1;  // 19 h
  std::uint64_t elapsed_us() const noexcept { return rest >> kElapsedBit; }
  int attempt() const noexcept { return static_cast<int>(rest >> kAttemptBit & kMostAttempt); }
  int version_number() const noexcept { return static_cast<int>(rest >> kVersionBit & kMostVersion); }
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
