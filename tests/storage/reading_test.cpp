/// Reading where nothing can be written: a full disk, a read-only folder, a log that a crash has left.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "storage/sqlite/log_replay.h"
#include "tests/storage/failing_vfs.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;
using Access = DatabaseOptions::Access;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const fs::path& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

/// A file whose last sessions stand in its log alone, as after a crash: no connection stands, no index lies beside it.
struct Crashed {
  explicit Crashed(const fs::path& at) : file{at} {
    const pid_t child = fork();
    if (child == 0) {
      const auto store = open(file);
      const Account student = make_student(*store);
      complete_session(*store, student, keep(*store));
      must(store->database().run("PRAGMA wal_checkpoint"));
      complete_session(*store, student, keep(*store));
      _exit(0);  // closes nothing
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    fs::remove(file.string() + "-shm");
    EXPECT_GT(fs::file_size(file.string() + "-wal"), 0u);
  }
  fs::path file;
};

/// Every row of every table.
std::string dump(Database& db) {
  std::string out;
  for (const std::string& table : must(db.all("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name",
                                              [](Row row) { return row.text(0); }))) {
    out += table + "\n";
    for (const Hash256& row : must(db.all("SELECT * FROM " + table, [](Row r) { return r.content_hash(); }))) {
      out += hex(row) + "\n";
    }
  }
  return out;
}

DatabaseOptions reading(const std::string& vfs = {}) {
  DatabaseOptions options;
  options.access = Access::read_only;
  options.vfs = vfs;
  return options;
}

class ReadingTest : public ::testing::Test {
 protected:
  void SetUp() override { failing_vfs(); }
  void TearDown() override { fail_from(Failing::nothing, 0); }
  Folder folder;
};

TEST_F(ReadingTest, a_full_disk_shows_everything_that_was_committed) {
  const Crashed left(folder / "a.db");
  const std::string file = content_of(left.file), log = content_of(left.file.string() + "-wal");
  fail_from(Failing::no_index, 0);
  StoreOptions options = quick();
  options.database = reading(failing_vfs());
  {
    const auto store = open(left.file, options);
    const Account student = must(store->accounts.find_number("20267314"));
    const auto rows = must(store->history.list(student.actor()));
    ASSERT_EQ(rows.size(), 2u);
    for (const HistoryRow& row : rows) EXPECT_TRUE(must(verify_session(store->context(), row.session)).intact());
    EXPECT_TRUE(must(store->grades.newest(rows[0].session)).has_value());
    EXPECT_EQ(must(store->database().integrity_check()), "");
    EXPECT_EQ(code_of(store->sessions.close(rows[0].session, "")), StorageError::read_only);
  }
  EXPECT_EQ(content_of(left.file), file);
  EXPECT_EQ(content_of(left.file.string() + "-wal"), log);
  // For writing, the cause is named, and nothing is lost.
  options.database.access = Access::existing;
  EXPECT_EQ(code_of(Store::open(left.file, options)), StorageError::disk_full);
  fail_from(Failing::nothing, 0);
  EXPECT_EQ(must(open(left.file)->history.list(must(open(left.file)->accounts.find_number("20267314")).actor())).size(),
            2u);
}

TEST_F(ReadingTest, while_another_writes_on_a_full_disk_its_log_is_read_in_place) {
  const auto writer = open(folder / "a.db");
  const Account student = make_student(*writer);
  fail_from(Failing::no_index, 0);
  StoreOptions options = quick();
  options.database = reading(failing_vfs());
  const auto reader = open(folder / "a.db", options);
  complete_session(*writer, student, keep(*writer));  // a copy in memory would not see it
  EXPECT_EQ(must(reader->history.list(student.actor())).size(), 1u);
}

TEST(LogReplay, reads_no_byte_beyond_a_log_that_is_cut_anywhere) {
  const Folder folder;
  const std::string log = content_of(Crashed(folder / "a.db").file.string() + "-wal");
  constexpr std::size_t kHeader = 32, kFrame = 24 + 8192;
  ASSERT_GT(log.size(), kHeader + 2 * kFrame);
  for (const std::size_t frames : {0, 1, 2})
    for (std::size_t over = 0; over < 40; ++over) {
      const std::size_t end = frames == 0 ? over : kHeader + frames * kFrame - over;
      // In memory of exactly its size.
      const std::vector<char> cut(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(end));
      for (const auto& [page, place] : read_log(std::as_bytes(std::span(cut))).places) EXPECT_LE(place + 8192, end) << page;
    }
}

TEST(LogReplay, leaves_out_pages_beyond_a_file_that_has_become_smaller) {
  const std::vector<std::byte> bytes(512, std::byte{7});
  std::vector<std::byte> image(512);
  lay_over({.page_size = 512, .pages = 1, .places = {{1, 0}, {2, 0}}}, bytes, image);
  EXPECT_EQ(image, bytes);
}

TEST_F(ReadingTest, a_log_that_was_torn_or_damaged_is_read_as_sqlite_reads_it) {
  const Crashed left(folder / "a.db");
  const std::string file = content_of(left.file), log = content_of(left.file.string() + "-wal");
  const unsigned seed = 20261121;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  std::set<std::string> seen;
  for (int i = 0; i < 60; ++i) {
    const fs::path place = folder / ("try" + std::to_string(i) + ".db");
    std::string torn = log.substr(0, i == 0 ? log.size() : random() % (log.size() + 1));
    if (i % 3 == 0 && i > 0 && !torn.empty()) torn[random() % torn.size()] ^= 4;
    write(place, file);
    write(place.string() + "-wal", torn);
    fail_from(Failing::no_index, 0);
    std::string here;
    {
      auto copy = must(Database::open(place, reading(failing_vfs())));
      EXPECT_EQ(must(copy.integrity_check()), "") << "seed " << seed << ", " << i;
      here = dump(copy);
    }
    fail_from(Failing::nothing, 0);
    auto in_place = must(Database::open(place, {.access = Access::existing}));
    EXPECT_EQ(here, dump(in_place)) << "seed " << seed << ", " << i;
    seen.insert(here);
  }
  EXPECT_GT(seen.size(), 3u);  // it did cut between different commits
}

TEST_F(ReadingTest, two_that_copy_at_once_wait_for_each_other) {
  const Crashed left(folder / "a.db");
  fail_from(Failing::no_index, 0);
  auto one = must(Database::open(left.file, reading(failing_vfs())));
  auto two = must(Database::open(left.file, reading(failing_vfs())));
  EXPECT_EQ(dump(one), dump(two));
}

TEST_F(ReadingTest, a_folder_that_nobody_can_write_shows_its_log_too) {
  const Crashed left(folder / "a.db");
  const fs::path path = left.file.parent_path();
  constexpr auto all_read = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
  constexpr auto all_enter = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
  for (const fs::path& file : {left.file, fs::path(left.file.string() + "-wal")}) fs::permissions(file, all_read);
  fs::permissions(path, all_read | all_enter);
  const bool root = geteuid() == 0;
  if (root) {
    ASSERT_EQ(seteuid(65534), 0);
  }
  std::size_t sessions = 0;
  {
    auto db = must(Database::open(left.file, reading()));
    sessions = must(db.all("SELECT id FROM sessions", [](Row row) { return row.uuid(0); })).size();
  }
  if (root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  fs::permissions(path, fs::perms::owner_all);
  EXPECT_EQ(sessions, 2u);
}

TEST_F(ReadingTest, a_log_beside_a_file_that_lost_every_byte_stays) {
  const Crashed left(folder / "a.db");
  const std::string log = content_of(left.file.string() + "-wal");
  fs::resize_file(left.file, 0);
  for (const Access access : {Access::create, Access::existing, Access::read_only}) {
    EXPECT_EQ(code_of(Database::open(left.file, {.access = access})), StorageError::corrupt);
  }
  EXPECT_EQ(content_of(left.file.string() + "-wal"), log);
}

TEST_F(ReadingTest, a_file_that_cannot_be_read_at_all_is_refused_and_not_taken_for_empty) {
  const Crashed left(folder / "a.db");
  for (int n = 1; n <= 30; ++n) {
    fail_from(Failing::any_call, n);
    auto db = Database::open(left.file, reading(failing_vfs()));
    fail_from(Failing::nothing, 0);
    if (!db) continue;
    EXPECT_EQ(must(db->all("SELECT id FROM sessions", [](Row row) { return row.uuid(0); })).size(), 2u) << n;
  }
}

}  // namespace
}  // namespace cusp::test
