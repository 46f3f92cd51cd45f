/// What the platform grants a thread that must not be late: first the system's own first-in first-out class, where this
/// user may have it; else the desktop's service for such threads (rtkit); else nothing, and that is said.
#pragma once

#include <cstdint>

namespace cusp::engine {

enum class RealtimeLevel : std::uint8_t {
  normal,  // other programs get in between: ticks come late on a busy machine
  rtkit,   // round robin, given by the service
  fifo,    // SCHED_FIFO
};

/// Why it is not more. Codes: ui has the words.
enum class RealtimeRefusal : std::uint8_t {
  none,
  not_asked,      // in tests and in virtual time
  not_permitted,  // no right of its own, and the service said no
  no_service,     // no right of its own, and no service to ask
};

struct RealtimeGrant {
  RealtimeLevel level = RealtimeLevel::normal;
  RealtimeRefusal refusal = RealtimeRefusal::not_asked;
  int priority = 0;            // of the real-time class; 0: none
  bool memory_locked = false;  // pages stay in memory
  bool realtime() const noexcept { return level != RealtimeLevel::normal; }
  friend bool operator==(const RealtimeGrant&, const RealtimeGrant&) = default;
};

/// The ways to ask, in the order they are tried: the system's, or a test's.
class RealtimeWays {
 public:
  virtual ~RealtimeWays() = default;
  /// The most that this user may have by himself, 0 for nothing; and taking it, for the calling thread.
  virtual int own_limit() noexcept = 0;
  virtual bool take_fifo(int priority) noexcept = 0;
  enum class Service : std::uint8_t { granted, refused, absent };
  /// For the calling thread; no more than `priority`, which it lowers to what was granted.
  virtual Service ask_service(int& priority) noexcept = 0;
  virtual bool lock_memory() noexcept = 0;
  /// Sleeps end when they should, not up to 50 us later.
  virtual void sharpen_sleep() noexcept = 0;
};

inline constexpr int kFifoPriority = 50;   // above every ordinary program, below the kernel's own interrupt threads' default
inline constexpr int kServicePriority = 15;  // Debian's rtkit gives up to 20

RealtimeGrant ask_by(RealtimeWays& ways) noexcept;

/// The calling thread asks the system; a refusal is no failure, it is said. Not within a tick: a service may take a
/// second to answer. A thread that got a class from the service is killed if it runs 0.2 s without ever waiting.
RealtimeGrant ask_for_realtime() noexcept;
/// Touches the next 256 KiB of the calling thread's stack, so that no tick waits for a page.
void prefault_stack() noexcept;
/// Names the calling thread for debuggers; at most 15 letters.
void name_this_thread(const char* name) noexcept;
/// Processor time of the calling thread. No heap, no lock.
std::uint64_t thread_cpu_ns() noexcept;

}  // namespace cusp::engine
