/// A recorder that is killed at many moments: the file opens, is sound, and the session shows as interrupted.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// In a process of its own: records seconds until it is killed, and reports each stored one.
[[noreturn]] void record(const fs::path& file, int pipe_end) {
  const auto store = open(file);
  const Account student = must(store->accounts.find_number("20267314"));
  const SessionId id = must(store->sessions.start(student.actor(), new_session(student, keep(*store)))).id;
  for (std::uint64_t tick = 1;; tick += 12) {
    if (!store->traces.append(id, second_from(tick))) _exit(1);
    const char byte = 1;
    if (write(pipe_end, &byte, 1) != 1) _exit(2);
  }
}

TEST(Killing, at_any_moment_leaves_every_second_that_was_reported_as_stored) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  make_student(*open(file));
  const unsigned seed = 20261120;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  for (int attempt = 0; attempt < 20; ++attempt) {
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      close(pipe_ends[0]);
      record(file, pipe_ends[1]);
    }
    close(pipe_ends[1]);
    // Waits for progress, then for a part of the next second's work.
    const std::size_t wanted = 1 + random() % 5;
    std::size_t reported = 0;
    char byte = 0;
    while (reported < wanted && read(pipe_ends[0], &byte, 1) == 1) ++reported;
    ASSERT_EQ(reported, wanted);
    usleep(random() % 3000);
    kill(child, SIGKILL);
    while (read(pipe_ends[0], &byte, 1) == 1) ++reported;
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the recorder failed by itself, attempt " << attempt;
    close(pipe_ends[0]);

    const auto store = open(file);
    EXPECT_EQ(must(store->database().integrity_check()), "");
    const Account student = must(store->accounts.find_number("20267314"));
    const HistoryRow newest = must(store->history.list(student.actor())).at(0);
    EXPECT_EQ(newest.state, SessionState::interrupted) << attempt;
    const auto events = must(store->sessions.events(newest.session));
    EXPECT_EQ(events.back().reason, "process_gone");
    const auto chunks = must(store->traces.chunks(newest.session)).size();
    EXPECT_GE(chunks, reported) << attempt;  // nothing that was reported is lost
    EXPECT_LE(chunks, reported + 1) << attempt;  // and at most one was stored and not reported
    EXPECT_TRUE(must(verify_session(store->context(), newest.session)).intact()) << attempt;
    must(store->traces.save_final_volume(newest.session, volume_after(chunks * 12)));
    must(store->grades.save(newest.session, small_grade(), {}));
    EXPECT_EQ(must(store->sessions.state(newest.session)), SessionState::graded);
  }
}

}  // namespace
}  // namespace cusp::test
