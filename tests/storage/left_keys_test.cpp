/// What a process leaves that is killed while it writes the station's key.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "storage/base/files.h"
#include "tests/refused_calls.h"
#include "tests/storage/killed.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct LeftKeys : testing::Test {
  void start() { id = open(folder / "a.db")->context().key->id(); }
  fs::path beside(const std::string& ending) const { return folder / ("a.db.key" + ending); }
  std::size_t keys() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(beside("").parent_path()))
      count += entry.path().filename().string().starts_with("a.db.key") && !entry.path().string().ends_with("-counter") ? 1u : 0u;
    return count;
  }
  const Folder folder;
  Hash256 id{};
};

TEST_F(LeftKeys, of_a_process_that_was_killed_before_its_last_call_go_at_the_next_start) {
  start();
  const Hash256 before = id;
  const std::string secret = *must(read_private_file(beside("")));
  fs::remove(beside(""));
  const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
    std::vector<RefusedCall> calls = {{SYS_unlinkat, kKills}};
#ifdef SYS_unlink
    calls.push_back({SYS_unlink, kKills});
#endif
    refuse_calls(calls);
    static_cast<void>(write_private_file(beside(""), secret));
    static_cast<void>(step());
  });
  if (!killed.by_signal || killed.steps > 0) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_EQ(keys(), 2u) << "two names of one file";
  start();
  EXPECT_EQ(keys(), 1u);
  EXPECT_EQ(id, before);
}

TEST_F(LeftKeys, that_are_empty_go_at_the_next_start) {
  start();
  std::ofstream(beside(".a1B2c3"));
  start();
  EXPECT_FALSE(fs::exists(beside(".a1B2c3")));
}

TEST_F(LeftKeys, that_a_process_still_writes_stay) {
  start();
  const int writes = ::open(beside(".a1B2c3").c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  ASSERT_GE(writes, 0);
  ASSERT_EQ(::flock(writes, LOCK_EX | LOCK_NB), 0);
  start();
  EXPECT_TRUE(fs::exists(beside(".a1B2c3")));
  ::close(writes);
  start();
  EXPECT_FALSE(fs::exists(beside(".a1B2c3")));
}

TEST_F(LeftKeys, are_no_copies_links_and_folders_of_similar_names) {
  start();
  const Hash256 before = id;
  fs::copy_file(beside(""), beside(".backup"));  // an administrator's, of six letters
  for (const char* other : {".a1B2c", ".a1B2c34", ".a1B2c-", "-a1B2c3"}) fs::create_hard_link(beside(""), beside(other));
  fs::create_symlink("a.db.key", beside(".d4E5f6"));
  fs::create_directory(beside(".folder"));
  const std::size_t all = keys();
  start();
  EXPECT_EQ(keys(), all);
  EXPECT_EQ(id, before);
}

TEST_F(LeftKeys, are_not_where_the_key_is_a_link_to_a_file_of_such_a_name) {
  start();
  const Hash256 before = id;
  fs::rename(beside(""), beside(".backup"));
  fs::create_symlink("a.db.key.backup", beside(""));
  start();
  EXPECT_TRUE(fs::exists(beside(".backup")));
  EXPECT_EQ(id, before);
}

}  // namespace
}  // namespace cusp::test
