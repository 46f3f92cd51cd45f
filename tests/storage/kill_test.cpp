/// A recorder that is killed at many moments: the file opens, is sound, and the session shows as interrupted.
#include <gtest/gtest.h>

#include <random>

#include "tests/storage/killed.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Records seconds until it is killed, and reports each stored one.
void record(const fs::path& file, const std::function<bool()>& step) {
  const auto store = open(file);
  const Account student = must(store->accounts.find_number("20267314"));
  const SessionId id = must(store->sessions.start(student.actor(), new_session(student, keep(*store)))).id;
  for (std::uint64_t tick = 1; store->traces.append(id, second_from(tick)) && step();) tick += 12;
}

TEST(Killing, at_any_moment_leaves_every_second_that_was_reported_as_stored) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  make_student(*open(file));
  const unsigned seed = 20261120;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  for (int attempt = 0; attempt < 20; ++attempt) {
    // Waits for progress, then for a part of the next second's work.
    const std::size_t wanted = 1 + random() % 5;
    const unsigned delay_us = random() % 3000;
    const Killed killed = kill_after(wanted, delay_us, [&](const std::function<bool()>& step) { record(file, step); });
    ASSERT_GE(killed.steps, wanted);
    ASSERT_TRUE(killed.by_signal) << "the recorder failed by itself, attempt " << attempt;

    const auto store = open(file);
    EXPECT_EQ(must(store->database().integrity_check()), "");
    const Account student = must(store->accounts.find_number("20267314"));
    const HistoryRow newest = must(store->history.list(student.actor())).at(0);
    EXPECT_EQ(newest.state, SessionState::interrupted) << attempt;
    const auto events = must(store->sessions.events(newest.session));
    EXPECT_EQ(events.back().reason, "process_gone");
    const auto chunks = must(store->traces.chunks(newest.session)).size();
    EXPECT_GE(chunks, killed.steps) << attempt;  // nothing that was reported is lost
    EXPECT_LE(chunks, killed.steps + 1) << attempt;  // and at most one was stored and not reported
    EXPECT_TRUE(must(verify_session(store->context(), newest.session)).intact()) << attempt;
    const FinalVolume volume = volume_after(chunks * 12);
    must(store->grades.save(newest.session, small_grade(), {}, std::nullopt, &volume));
    EXPECT_EQ(must(store->sessions.state(newest.session)), SessionState::graded);
  }
}

}  // namespace
}  // namespace cusp::test
