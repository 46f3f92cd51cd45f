#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <iostream>

#include "ui/cli/terminal.h"

namespace cusp::ui {

namespace {
/// Bytes: one more than an acceptable password (storage/base/password.h), so that a longer one cut here matches none.
constexpr std::size_t kMostSecret = 1025;
}  // namespace

void hold_standard_streams() noexcept {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // It gets the lowest free number, this one; of the wrong way, so that each use fails with EBADF.
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

std::string read_secret(const std::string& prompt) {
  termios before{};
  const bool terminal = isatty(STDIN_FILENO) == 1 && tcgetattr(STDIN_FILENO, &before) == 0;
  if (terminal) {
    std::fputs(prompt.c_str(), stderr);
    termios silent = before;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  std::string line;
  // A device may send no line's end.
  for (char c = 0; line.size() < kMostSecret && std::cin.get(c) && c != '\n';) line += c;
  if (terminal) {
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &before);
    std::fputc('\n', stderr);
  }
  return line;
}

void show_progress(double share) {
  if (isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "\r%3d %%", static_cast<int>(100.0 * share));
}

void end_progress() {
  if (isatty(STDERR_FILENO) == 1) std::fputs("\r\033[K", stderr);
}

}  // namespace cusp::ui
