#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <iostream>

#include "ui/cli/terminal.h"

namespace cusp::ui {

namespace {
/// Bytes: one more than an acceptable password (storage/base/password.h), so that a longer one cut here matches none.
constexpr std::size_t kMostSecret = 1025;

constexpr std::array kEnding = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

termios g_shown{};  // of the terminal that shows what is typed; a signal handler reads it

/// Calls what POSIX allows in a handler. The signal then acts as without one.
void show_and_end(int signal) {
  tcsetattr(STDIN_FILENO, TCSAFLUSH, &g_shown);
  raise(signal);
}

/// While it stands the terminal does not show what is typed. It shows it again at the end, a signal's too. One at a time.
class SilentInput {
 public:
  SilentInput() : terminal_(isatty(STDIN_FILENO) == 1 && tcgetattr(STDIN_FILENO, &g_shown) == 0) {
    if (!terminal_) return;
    struct sigaction ending = {};
    ending.sa_handler = show_and_end;
    ending.sa_flags = static_cast<int>(SA_RESETHAND);
    for (std::size_t i = 0; i < kEnding.size(); ++i) {
      sigaction(kEnding[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) sigaction(kEnding[i], &ending, nullptr);
    }
    termios silent = g_shown;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  ~SilentInput() {
    if (!terminal_) return;
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &g_shown);
    for (std::size_t i = 0; i < kEnding.size(); ++i) sigaction(kEnding[i], &before_[i], nullptr);
  }
  SilentInput(const SilentInput&) = delete;
  SilentInput& operator=(const SilentInput&) = delete;
  bool terminal() const noexcept { return terminal_; }

 private:
  bool terminal_;
  std::array<struct sigaction, kEnding.size()> before_{};
};

}  // namespace

void hold_standard_streams() noexcept {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // It gets the lowest free number, this one; of the wrong way, so that each use fails with EBADF.
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

std::string read_secret(const std::string& prompt) {
  const SilentInput silent;
  if (silent.terminal()) std::fputs(prompt.c_str(), stderr);
  std::string line;
  // A device may send no line's end.
  for (char c = 0; line.size() < kMostSecret && std::cin.get(c) && c != '\n';) line += c;
  if (silent.terminal()) std::fputc('\n', stderr);
  return line;
}

void show_progress(double share) {
  if (isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "\r%3d %%", static_cast<int>(100.0 * share));
}

void end_progress() {
  if (isatty(STDERR_FILENO) == 1) std::fputs("\r\033[K", stderr);
}

}  // namespace cusp::ui
