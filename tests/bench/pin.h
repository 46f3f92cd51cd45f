/// What the operating system is asked for: one core, and how much memory is held.
#pragma once

#include <optional>

namespace cusp::bench {

/// Keeps this thread on the last core it may use, so that no measurement moves; that core, or nullopt where the system
/// refuses.
std::optional<int> pin_to_core();

/// Memory that this process holds in RAM, in MB (10^6 bytes), after what was freed has gone back; nullopt where the
/// system does not tell.
std::optional<double> resident_mb();

}  // namespace cusp::bench
