/// What the platform grants a thread that must not be late.
#pragma once

#include <cstdint>

namespace cusp {

struct RealtimeGrant {
  bool fifo = false;           // SCHED_FIFO was granted: other programs do not get in between
  bool memory_locked = false;  // pages stay in memory
};

/// The calling thread asks; a refusal is no failure, it is said. Not within a tick.
RealtimeGrant ask_for_realtime() noexcept;
/// Names the calling thread for debuggers; at most 15 letters.
void name_this_thread(const char* name) noexcept;
/// Processor time of the calling thread. No heap, no lock.
std::uint64_t thread_cpu_ns() noexcept;

}  // namespace cusp
