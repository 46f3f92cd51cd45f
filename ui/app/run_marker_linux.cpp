#include <sys/socket.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "ui/app/run_marker.h"

namespace cusp::ui {
namespace {

// Read in a signal handler, where nothing may be allocated.
std::array<char, 4096> g_file{};
std::array<int, 2> g_wire{-1, -1};
volatile std::sig_atomic_t g_signalled = 0;

void remove_file() {
  if (g_file[0] != 0) unlink(g_file.data());
}

void on_signal(int) {
  g_signalled = 1;
  remove_file();
  const char byte = 1;
  [[maybe_unused]] const ssize_t wrote = write(g_wire[0], &byte, 1);
}

}  // namespace

bool ended_by_signal() noexcept { return g_signalled != 0; }

void remove_at_any_end(const char* file) {
  if (file != nullptr && std::strlen(file) < g_file.size()) std::strcpy(g_file.data(), file);
  if (g_wire[0] >= 0) return;
  std::atexit(remove_file);  // Qt calls exit() when the display goes with the session
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, g_wire.data()) != 0) return;
  auto* notifier = new QSocketNotifier(g_wire[1], QSocketNotifier::Read, QCoreApplication::instance());
  QObject::connect(notifier, &QSocketNotifier::activated, notifier, [notifier] {
    notifier->setEnabled(false);
    QCoreApplication::quit();  // closes the windows: an editor keeps its draft
  });
  for (const int signal : {SIGTERM, SIGHUP, SIGINT}) std::signal(signal, on_signal);
}

}  // namespace cusp::ui
