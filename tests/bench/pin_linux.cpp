#include <malloc.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <fstream>

#include "tests/bench/pin.h"

namespace cusp::bench {

std::optional<int> pin_to_core() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return std::nullopt;
  int core = -1;
  for (int i = 0; i < CPU_SETSIZE; ++i)
    if (CPU_ISSET(i, &allowed)) core = i;
  if (core < 0) return std::nullopt;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(core, &one);
  if (sched_setaffinity(0, sizeof one, &one) != 0) return std::nullopt;
  return core;
}

double core_time_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::optional<double> resident_mb() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  if (!(file >> pages >> resident)) return std::nullopt;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

}  // namespace cusp::bench
