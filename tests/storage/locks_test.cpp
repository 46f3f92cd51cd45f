/// Several connections and programs on one file: nobody drops another's locks, deletes a log in use, or is turned away.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <barrier>
#include <fstream>
#include <functional>
#include <thread>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;
using Access = DatabaseOptions::Access;

/// Locks that this process holds on the file. Read by descriptor: the kernel does not list /proc/locks at one moment, so
/// another program's locks make it name one twice or not at all.
int locks_held(const fs::path& file) {
  int held = 0;
  for (const auto& descriptor : fs::directory_iterator("/proc/self/fd")) {
    std::error_code gone;  // the iterator's own
    if (fs::read_symlink(descriptor, gone) != fs::canonical(file)) continue;
    std::ifstream about("/proc/self/fdinfo" / descriptor.path().filename());
    for (std::string line; std::getline(about, line);) held += line.starts_with("lock:");
  }
  return held;
}

/// A program of its own that waits for begin() and then does `work`. Made before any connection stands: SQLite's must not
/// cross a fork.
class Program {
 public:
  explicit Program(const std::function<bool()>& work) {
    if (pipe(ends_) != 0) std::abort();
    child_ = fork();
    if (child_ != 0) return;
    char byte = 0;
    close(ends_[1]);
    _exit(read(ends_[0], &byte, 1) == 1 && work() ? 0 : 1);
  }
  void begin() { EXPECT_EQ(write(ends_[1], "g", 1), 1); }
  bool succeeded() {
    int status = 0;
    waitpid(child_, &status, 0);
    close(ends_[0]);
    close(ends_[1]);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  int ends_[2] = {};
  pid_t child_ = -1;
};

TEST(Locks, another_opening_in_this_process_leaves_the_locks_of_the_first) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  const auto store = open(file);
  make_student(*store);
  const int held = locks_held(file);
  ASSERT_GT(held, 0);
  {
    const auto second = open(file);
    EXPECT_GE(locks_held(file), held);
  }
  EXPECT_EQ(locks_held(file), held);
  {
    StoreOptions reading = quick();
    reading.database.access = Access::read_only;
    const auto reader = open(file, reading);
  }
  EXPECT_EQ(locks_held(file), held);
  EXPECT_EQ(code_of(Database::open(file, {.migrations = {}})), StorageError::newer_schema);  // refused
  EXPECT_EQ(locks_held(file), held);
}

TEST(Locks, another_program_that_opens_and_closes_leaves_the_log_of_this_one) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  Program other([&] { return Store::open(file, quick()).has_value(); });
  const auto store = open(file);
  const Account student = make_student(*store);
  open(file).reset();
  struct stat before {
  }, after{};
  ASSERT_EQ(stat((file.string() + "-wal").c_str(), &before), 0);
  other.begin();
  ASSERT_TRUE(other.succeeded());
  ASSERT_EQ(stat((file.string() + "-wal").c_str(), &after), 0) << "the log was deleted";
  EXPECT_EQ(before.st_ino, after.st_ino);
  const SessionId session = complete_session(*store, student, keep(*store));
  Program reader([&] {
    const auto again = Store::open(file, quick());
    const auto proof = verify_session((*again)->context(), session);
    return proof.has_value() && proof->intact();
  });
  reader.begin();
  EXPECT_TRUE(reader.succeeded()) << "what was committed here is not seen there";
}

TEST(Locks, programs_that_start_together_on_a_new_file_all_open_it) {
  const Folder folder;
  for (int round = 0; round < 10; ++round) {
    const fs::path file = folder / (std::to_string(round) + ".db");
    std::vector<Program> programs;
    const auto open_it = [&] {
      const auto store = Store::open(file, quick());
      if (!store)
        std::fprintf(stderr, "code %d: %s %s\n", static_cast<int>(store.error().code), store.error().where.c_str(), store.error().detail.c_str());
      return store.has_value();
    };
    for (int i = 0; i < 4; ++i) programs.emplace_back(open_it);
    for (Program& program : programs) program.begin();
    for (Program& program : programs) EXPECT_TRUE(program.succeeded()) << round;
    const auto store = open(file);
    EXPECT_EQ(must(store->database().integrity_check()), "");
    EXPECT_TRUE(must(verify_audit_log(store->context())).intact());
  }
}

/// As SQLite's own journal comes and goes beside a file that another program is making.
TEST(Locks, a_journal_that_goes_while_the_place_is_checked_turns_nobody_away) {
  const Folder folder;
  const fs::path file = folder / "a.db", journal = file.string() + "-journal";
  open(file).reset();
  std::atomic<bool> stop{false};
  std::thread other([&] {
    while (!stop) {
      std::ofstream{journal};
      fs::remove(journal);
    }
  });
  int refused = 0;
  DatabaseOptions options;
  options.access = Access::read_only;
  for (int i = 0; i < 2000; ++i) refused += !Database::open(file, options);
  stop = true;
  other.join();
  EXPECT_EQ(refused, 0);
}

TEST(Locks, closing_while_another_reads_leaves_it_its_log) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  auto writer = open(file);
  const Account student = make_student(*writer);
  StoreOptions options = quick();
  options.database.access = Access::read_only;
  const auto reader = open(file, options);
  EXPECT_EQ(must(reader->accounts.find(student.id)).number, student.number);
  complete_session(*writer, student, keep(*writer));
  writer.reset();
  EXPECT_EQ(must(reader->history.list(student.actor())).size(), 1u);
  const auto again = open(file);
  complete_session(*again, student, keep(*again));
  EXPECT_EQ(must(reader->history.list(student.actor())).size(), 2u);
}

TEST(Verify, FindsNothingWhileAnotherProgramRecords) {
  const Folder folder;
  const fs::path file = folder / "a.db";
  { open(file); }  // so that both find it made
  Program recorder([&] {
    const auto store = open(file);
    const Account student = make_student(*store);
    const SessionId session = must(store->sessions.start(student.actor(), new_session(student, keep(*store)))).id;
    for (std::uint64_t tick = 1; tick < 12 * 400; tick += 12) must(store->traces.append(session, second_from(tick)));
    must(store->sessions.finish(session, volume_after(12 * 400), "student"));
    return !::testing::Test::HasFailure();
  });
  const auto store = open(file);
  recorder.begin();
  // Until the other has finished: verify at each of its moments.
  for (bool finished = false; !finished;) {
    const auto verified = must(verify_store(store->context()));
    EXPECT_TRUE(verified.findings.empty()) << key_of(verified.findings.front().code) << ' ' << verified.findings.front().table;
    if (HasFailure()) break;
    finished = must(store->database().first("SELECT 1 FROM final_volumes", [](Row) { return true; })).has_value();
  }
  EXPECT_TRUE(recorder.succeeded());
}

TEST(Locks, what_many_make_at_once_is_made_once) {
  for (int round = 0; round < 10; ++round) {
    const Folder folder;
    const fs::path file = folder / "a.db";
    { open(file); }  // so that all find it made
    constexpr int kMany = 4;
    std::barrier ready(kMany);
    std::vector<std::pair<UserId, VersionId>> found(kMany);
    {
      std::vector<std::jthread> threads;
      for (auto& mine : found) {
        threads.emplace_back([&] {
          const auto store = open(file);
          ready.arrive_and_wait();
          mine.first = must(store->accounts.demo_student()).id;
          ready.arrive_and_wait();
          mine.second = keep(*store).id;
        });
      }
    }
    EXPECT_THAT(found, ::testing::Each(found.front())) << "round " << round;
    const auto store = open(file);
    EXPECT_EQ(must(store->database().first("SELECT count(*) FROM people", [](Row row) { return row.integer(0); })), 1);
    EXPECT_EQ(must(store->scenarios.versions(small_scenario().id)).size(), 1u);
    EXPECT_TRUE(must(verify_store(store->context())).findings.empty());
  }
}

}  // namespace
}  // namespace cusp::test
