/// Whether the clock may be believed before something goes for good because of its age. Thread: the context's own.
#pragma once

#include <cstdint>
#include <optional>

#include "storage/records/context.h"

namespace cusp::storage {

/// `confirmed`: somebody has compared the clock with a calendar.
enum class ClockTrust : std::uint8_t { checked, confirmed };

/// Half a year: longer than the vacations between two terms. A clock that is wrong by less is not found.
inline constexpr std::int64_t kLongestPause_us = 183 * std::int64_t{86'400'000'000};

/// clock_ahead if the newest attempt and the newest account lie longer before now than kLongestPause_us. What is dated later than now
/// does not count, nor does a sign-in: the audit log dates it by the clock in question.
Stored<std::optional<StorageFailure>> clock_doubt(StorageContext& context);

}  // namespace cusp::storage
