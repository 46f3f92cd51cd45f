/// Real-time class of a thread. ask_for_realtime() tries the system's SCHED_FIFO, then the desktop's service for such
/// threads (rtkit). RealtimeGrant reports the result.
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class RealtimeLevel : std::uint8_t {
  normal,  // other programs interrupt it: ticks are late on a busy machine
  rtkit,   // round robin, from the service
  fifo,    // SCHED_FIFO
};

/// Why a grant is not higher. ui translates the codes.
enum class RealtimeRefusal : std::uint8_t {
  none,
  not_asked,      // in tests and in virtual time
  not_permitted,  // the user has no right, and the service refused
  no_service,     // the user has no right, and there is no service
};

struct RealtimeGrant {
  RealtimeLevel level = RealtimeLevel::normal;
  RealtimeRefusal refusal = RealtimeRefusal::not_asked;
  int priority = 0;            // of the real-time class; 0: none
  bool memory_locked = false;  // pages stay in memory
  bool realtime() const noexcept { return level != RealtimeLevel::normal; }
  friend bool operator==(const RealtimeGrant&, const RealtimeGrant&) = default;
};

/// Requests to the platform, in the order in which ask_by() tries them: the system's, or a test's. All are for the
/// calling thread.
class RealtimeWays {
 public:
  virtual ~RealtimeWays() = default;
  /// Highest priority that this user may take; 0: none.
  virtual int own_limit() noexcept = 0;
  virtual bool take_fifo(int priority) noexcept = 0;
  enum class Service : std::uint8_t { granted, refused, absent };
  /// Asks for `priority`, and lowers it to the granted one.
  virtual Service ask_service(int& priority) noexcept = 0;
  virtual bool lock_memory() noexcept = 0;
  /// Reduces the timer slack, so that a sleep ends on time and not up to 50 us later.
  virtual void tighten_timer() noexcept = 0;
};

inline constexpr int kFifoPriority = 50;     // above every ordinary program, not above the kernel's interrupt threads
inline constexpr int kServicePriority = 15;  // Debian's rtkit gives up to 20

RealtimeGrant ask_by(RealtimeWays& ways) noexcept;

/// The calling thread asks the system. A refusal is no failure: the grant reports it. Not within a tick: a service may
/// take a second to answer. The kernel kills a thread with the service's class that runs for 0.2 s without waiting.
RealtimeGrant ask_for_realtime() noexcept;
/// Writes to the next 256 KiB of the calling thread's stack, so that no tick waits for a page.
void prefault_stack() noexcept;
/// Names the calling thread for debuggers; at most 15 letters.
void name_this_thread(const char* name) noexcept;
/// Processor time of the calling thread. No heap, no lock.
std::uint64_t thread_cpu_ns() noexcept;

}  // namespace cusp::engine
