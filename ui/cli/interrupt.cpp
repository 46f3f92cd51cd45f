#include "ui/cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace cusp::ui {

namespace {

std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler stores it

void on_interrupt(int) { g_interrupted = true; }

}  // namespace

void catch_interrupt() noexcept {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
#ifdef SIGHUP
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as nohup sets it
#endif
}

bool interrupted() noexcept { return g_interrupted; }

}  // namespace cusp::ui
