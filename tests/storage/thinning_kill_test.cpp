/// A thinning that is killed at many moments: each recording is whole or thinned, and the next run thins the rest.
#include <gtest/gtest.h>

#include <random>

#include "tests/storage/killed.h"
#include "tests/storage/old_attempts.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Reports before each attempt.
void thin_until_killed(const fs::path& file, const Actor& admin, const std::function<bool()>& step) {
  const auto store = open(file);
  must(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out}, [&](std::size_t, std::size_t) { return step(); }));
}

struct ThinningKilled : OldAttempts {};

TEST_F(ThinningKilled, at_any_moment_leaves_each_recording_whole_or_thinned) {
  const unsigned seed = 20261123;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  constexpr int kAttempts = 40;
  for (int i = 0; i < kAttempts; ++i) attempt(140 - i);
  store.reset();
  int killed = 0;
  for (int round = 0; round < 12; ++round) {
    const std::size_t wanted = 1 + random() % 3;
    const unsigned delay_us = random() % 3000;
    killed += kill_after(wanted, delay_us, [&](const std::function<bool()>& step) { thin_until_killed(folder / "a.db", admin, step); }).by_signal;

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
