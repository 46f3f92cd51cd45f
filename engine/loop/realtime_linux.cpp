#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include "engine/loop/realtime.h"

namespace cusp {

RealtimeGrant ask_for_realtime() noexcept {
  RealtimeGrant grant;
  sched_param parameters{};
  parameters.sched_priority = 50;  // above every ordinary program, below the kernel's own interrupt threads' default
  grant.fifo = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
  // Only pages that are there already: locking future ones would let a large specimen fail under a low limit.
  if (grant.fifo) grant.memory_locked = mlockall(MCL_CURRENT) == 0;
  return grant;
}

void name_this_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

std::uint64_t thread_cpu_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<std::uint64_t>(t.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(t.tv_nsec);
}

}  // namespace cusp
