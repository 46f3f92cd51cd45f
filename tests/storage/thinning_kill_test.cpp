/// A thinning that is killed at many moments: each recording is whole or thinned, and the next run thins the rest.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "tests/storage/old_attempts.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// In a process of its own: reports before each attempt.
[[noreturn]] void thin_until_killed(const fs::path& file, const Actor& admin, int pipe_end) {
  const auto store = open(file);
  const auto report = [&](std::size_t, std::size_t) {
    const char byte = 1;
    return write(pipe_end, &byte, 1) == 1;
  };
  _exit(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out}, report) ? 0 : 1);
}

struct ThinningKilled : OldAttempts {};

TEST_F(ThinningKilled, at_any_moment_leaves_each_recording_whole_or_thinned) {
  const unsigned seed = 20261123;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  constexpr int kAttempts = 40;
  for (int i = 0; i < kAttempts; ++i) attempt(100 + i);
  store.reset();
  int killed = 0;
  for (int round = 0; round < 12; ++round) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      close(pipe_ends[0]);
      thin_until_killed(folder / "a.db", admin, pipe_ends[1]);
    }
    close(pipe_ends[1]);
    const std::size_t wanted = 1 + random() % 3;
    std::size_t reported = 0;
    char byte = 0;
    while (reported < wanted && read(pipe_ends[0], &byte, 1) == 1) ++reported;
    usleep(random() % 3000);
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    close(pipe_ends[0]);
    killed += WIFSIGNALED(status) ? 1 : 0;

    store = open(folder / "a.db", quick(now));
    EXPECT_EQ(must(store->database().integrity_check()), "");
    EXPECT_EQ(findings(), "") << round;
    const std::int64_t thinned = count("thinned_traces");
    EXPECT_EQ(count("trace_chunks"), 3 * (kAttempts - thinned)) << "three seconds each";
    EXPECT_EQ(count("key_states"), kAttempts - thinned);
    store.reset();
  }
  EXPECT_GT(killed, 0);
  store = open(folder / "a.db", quick(now));
  thin();
  EXPECT_EQ(count("thinned_traces"), kAttempts);
  EXPECT_EQ(findings(), "");
}

}  // namespace
}  // namespace cusp::test
