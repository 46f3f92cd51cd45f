// Preloaded into the desktop by turns.py. Writes each turn of the main thread's event loop that took more than kNotedMs of that thread's
// own processor time to the file CUSP_TURNS, as "<moment s> <ms> <stack when it passed kNotedMs>". The loop sleeps in poll() once a turn;
// poll() with one descriptor is a library that waits for an answer in the middle of a turn.
#include <dlfcn.h>
#include <execinfo.h>
#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

constexpr double kNotedMs = 50.0;
constexpr int kFrames = 48;
constexpr int kPassed = 64;  // SIGRTMAX, which nobody else uses

std::FILE* g_out = nullptr;
timer_t g_timer{};
double g_since_ms = 0;
void* g_stack[kFrames];
int g_depth = 0;  // 0: the turn has not passed kNotedMs

double ms_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void passed(int) { g_depth = backtrace(g_stack, kFrames); }

void arm(double ms) {
  itimerspec when{};
  when.it_value.tv_nsec = static_cast<long>(1e6 * ms);
  timer_settime(g_timer, 0, &when, nullptr);
}

bool begin() {
  const char* path = std::getenv("CUSP_TURNS");
  g_out = path != nullptr ? std::fopen(path, "a") : nullptr;
  if (g_out == nullptr) return false;
  std::setvbuf(g_out, nullptr, _IOLBF, 0);
  backtrace(g_stack, kFrames);  // its first call loads a library, which a handler may not
  std::signal(kPassed, passed);
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = kPassed;
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
  return timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &g_timer) == 0;
}

void write_place(void* place) {
  Dl_info where{};
  const bool known = dladdr(place, &where) != 0 && where.dli_fname != nullptr;
  const auto base = known ? reinterpret_cast<std::uintptr_t>(where.dli_fbase) : 0;
  std::fprintf(g_out, " %s+%lx", known ? where.dli_fname : "?", static_cast<unsigned long>(reinterpret_cast<std::uintptr_t>(place) - base));
}

void end_turn() {
  arm(0);
  const double took = ms_of(CLOCK_THREAD_CPUTIME_ID) - g_since_ms;
  if (took > kNotedMs) {
    std::fprintf(g_out, "%.3f %.0f", 1e-3 * ms_of(CLOCK_MONOTONIC), took);
    for (int i = 0; i < g_depth; ++i) write_place(g_stack[i]);
    std::fprintf(g_out, "\n");
  }
  g_depth = 0;
}

}  // namespace

extern "C" int poll(pollfd* files, nfds_t count, int timeout_ms) {
  using Poll = int (*)(pollfd*, nfds_t, int);
  static const auto real = reinterpret_cast<Poll>(dlsym(RTLD_NEXT, "poll"));
  if (count <= 1 || getpid() != syscall(SYS_gettid)) return real(files, count, timeout_ms);
  static const bool noting = begin();
  if (!noting) return real(files, count, timeout_ms);
  end_turn();
  const int answer = real(files, count, timeout_ms);
  g_since_ms = ms_of(CLOCK_THREAD_CPUTIME_ID);
  arm(kNotedMs);
  return answer;
}
