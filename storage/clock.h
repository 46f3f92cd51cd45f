/// Time as storage knows it: microseconds since 1970 in UTC. Injected, so that tests decide what time it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace cusp::storage {

using UtcClock = std::function<std::int64_t()>;

/// The system's clock. Any thread.
std::int64_t system_utc_us();

/// ISO 8601 to the second, "2026-11-20T09:14:03Z". For files and logs, not for people.
std::string iso_utc(std::int64_t utc_us);

}  // namespace cusp::storage
