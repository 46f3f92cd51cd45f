/// Requests to the operating system: one core, thread CPU time, resident memory.
#pragma once

#include <optional>

namespace cusp::bench {

/// Pins this thread to the last core that it may use. Returns the core; nullopt if the system refuses.
std::optional<int> pin_to_core();

/// CPU time of this thread, seconds. A call costs about 0.2 us.
double core_time_s();

/// Resident memory of this process after malloc_trim, MB (10^6 bytes); nullopt if /proc is not readable.
std::optional<double> resident_mb();

}  // namespace cusp::bench
