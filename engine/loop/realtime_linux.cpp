#include "engine/loop/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <time.h>

#include <cstddef>

#include "engine/loop/rtkit.h"

namespace cusp::engine {

namespace {

class SystemWays final : public RealtimeWays {
 public:
  int own_limit() noexcept override {
    rlimit limit{};
    if (getrlimit(RLIMIT_RTPRIO, &limit) != 0) return 0;
    return limit.rlim_cur == RLIM_INFINITY ? kFifoPriority : static_cast<int>(limit.rlim_cur);
  }
  bool take_fifo(int priority) noexcept override {
    sched_param parameters{};
    parameters.sched_priority = priority;
    // A child process does not inherit the class.
    return sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0;
  }
  Service ask_service(int& priority) noexcept override {
    switch (ask_rtkit(priority)) {
      case RtkitAnswer::granted: return Service::granted;
      case RtkitAnswer::refused: return Service::refused;
      case RtkitAnswer::absent: return Service::absent;
    }
    return Service::absent;
  }
  bool lock_memory() noexcept override {
    // Present pages only: with future ones locked, a large specimen would fail under a low limit.
    return mlockall(MCL_CURRENT) == 0;
  }
  void tighten_timer() noexcept override { prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL); }
};

}  // namespace

RealtimeGrant ask_for_realtime() noexcept {
  SystemWays ways;
  return ask_by(ways);
}

[[gnu::noinline]] void prefault_stack() noexcept {
  constexpr std::size_t kBytes = 256 * 1024, kPage = 4096;
  volatile std::byte stack[kBytes];
  for (std::size_t at = 0; at < kBytes; at += kPage) stack[at] = std::byte{1};
  static_cast<void>(stack[0]);
}

void name_this_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

std::uint64_t thread_cpu_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<std::uint64_t>(t.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(t.tv_nsec);
}

}  // namespace cusp::engine
