/// The desktop's service that grants ordinary users' threads a real-time class (org.freedesktop.RealtimeKit1).
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class RtkitAnswer : std::uint8_t { granted, refused, absent };

/// Asks for the calling thread, over the system bus. Waits at most a second for each of three answers. Lowers
/// `priority` to the service's highest. Sets the limit that the service demands: the kernel kills a real-time thread
/// that runs for longer than that (0.2 s) without waiting.
RtkitAnswer ask_rtkit(int& priority) noexcept;

}  // namespace cusp::engine
