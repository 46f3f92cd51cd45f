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

/// So long a use after a pause vouches for the clock: one that is wrong does not stay unnoticed for two weeks.
inline constexpr std::int64_t kShortestUse_us = 14 * std::int64_t{86'400'000'000};

/// clock_ahead if the newest attempt and the newest account lie longer before now than kLongestPause_us; or (where = pause) if those of
/// the last kShortestUse_us follow all others after such a pause: the clock in question may have dated them; or if the log has such a gap
/// that ended less than `age_us` ago: a clock that stood back until then made what it dated old. `detail` holds the newest date, then
/// now; of a pause the newest date before it, now, and the first date after it. What is dated later than now does not count. A sign-in
/// counts in the log alone. `age_us`: what is older goes. Scans the log.
Stored<std::optional<StorageFailure>> clock_doubt(StorageContext& context, std::int64_t age_us);

/// The date of this station's newest attempt, if it lies more than a day after now: a computer that starts at an old date would put each
/// attempt before those of the years between, and close what is assigned. nullopt also if the log shows kShortestUse_us of use since: then
/// the attempt had its date of a clock that was ahead. Reads the log back to the attempt.
Stored<std::optional<std::int64_t>> clock_behind(StorageContext& context);

}  // namespace cusp::storage
