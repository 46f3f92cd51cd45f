/// Time in microseconds since 1970, UTC. StoreOptions injects the clock, so that tests set the time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace cusp::storage {

using UtcClock = std::function<std::int64_t()>;

/// The system's clock. Any thread.
std::int64_t system_utc_us();

/// ISO 8601 to the second, "2026-11-20T09:14:03Z". For files and logs, not for the screen.
std::string iso_utc(std::int64_t utc_us);

}  // namespace cusp::storage
