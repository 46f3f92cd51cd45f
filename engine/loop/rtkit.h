/// The desktop's service that gives threads of ordinary users a real-time class (org.freedesktop.RealtimeKit1).
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class RtkitAnswer : std::uint8_t { granted, refused, absent };

/// Asks for the calling thread, over the system bus; waits at most a second for each of three answers. `priority` is
/// lowered to the service's most. Sets the limit that the service demands: a thread of a real-time class that runs
/// without ever waiting for longer than the service allows (0.2 s) is killed.
RtkitAnswer ask_rtkit(int& priority) noexcept;

}  // namespace cusp::engine
