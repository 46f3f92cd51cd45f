/// Time in microseconds since 1970, UTC. StoreOptions injects the clock, so that tests set the time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace cusp::storage {

using UtcClock = std::function<std::int64_t()>;

/// The system's clock. Any thread.
std::int64_t system_utc_us();

/// ISO 8601 to the second, "2026-11-20T09:14:03Z". For files and logs, not for the screen.
std::string iso_utc(std::int64_t utc_us);

/// From begin_utc_us up to, without, end_utc_us.
struct UtcSpan {
  std::int64_t begin_utc_us = 0, end_utc_us = 0;
};
/// The day or second that "2026-11-20" or "2026-11-20T09:14:03Z" names. nullopt: other text, or no day of the calendar.
std::optional<UtcSpan> utc_span_of(std::string_view iso);

}  // namespace cusp::storage
