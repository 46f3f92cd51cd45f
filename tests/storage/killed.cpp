#include "tests/storage/killed.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cusp::test {

Killed kill_after(std::size_t steps, unsigned delay_us, const std::function<void(const std::function<bool()>& step)>& work) {
  int pipe_ends[2];
  if (::pipe(pipe_ends) != 0) {
    ADD_FAILURE() << "no pipe";
    return {};
  }
  const pid_t child = ::fork();
  if (child < 0) {  // kill(-1) would end every process
    ADD_FAILURE() << "no process";
    return {};
  }
  char byte = 1;
  if (child == 0) {
    ::close(pipe_ends[0]);
    work([&] { return ::write(pipe_ends[1], &byte, 1) == 1; });
    ::_exit(0);
  }
  ::close(pipe_ends[1]);
  Killed out;
  while (out.steps < steps && ::read(pipe_ends[0], &byte, 1) == 1) ++out.steps;
  ::usleep(delay_us);
  ::kill(child, SIGKILL);
  while (::read(pipe_ends[0], &byte, 1) == 1) ++out.steps;
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  ::close(pipe_ends[0]);
  out.by_signal = WIFSIGNALED(status);
  return out;
}

}  // namespace cusp::test
