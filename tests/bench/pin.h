/// What the operating system is asked for: one core, the time had on it, and the memory held.
#pragma once

#include <optional>

namespace cusp::bench {

/// Keeps this thread on the last core it may use, so that no measurement moves; that core, or nullopt where the system
/// refuses.
std::optional<int> pin_to_core();

/// Time that this thread has had on a core, in seconds: other programs' share of it is not counted. Costs about 0.2 us.
double core_time_s();

/// Memory that this process holds in RAM, in MB (10^6 bytes), after what was freed has gone back; nullopt where the
/// system does not tell.
std::optional<double> resident_mb();

}  // namespace cusp::bench
