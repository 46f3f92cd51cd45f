/// A backup that reports how far it is, and one that somebody stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "storage/backup/backup.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Records of several megabytes: SQLite writes a copy out as it grows above 2 MB.
struct StoppedBackup : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Actor administrator = make_administrator(*store).actor();

  void SetUp() override {
    must(store->database().run(
        "INSERT INTO blobs WITH RECURSIVE numbers (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM numbers WHERE n < 6000) "
        "SELECT randomblob(32), randomblob(2000) FROM numbers"));
  }
  fs::path into() { return folder / "backups"; }
  std::set<std::string> files_there() {
    std::set<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(into())) out.insert(entry.path().string());
    return out;
  }
  std::int64_t entries() {
    return must(store->database().first("SELECT count(*) FROM audit_log", [](Row row) { return row.integer(0); })).value_or(-1);
  }
};

TEST_F(StoppedBackup, that_nobody_stops_reports_its_pages_and_ends_at_all_of_them) {
  std::vector<std::size_t> done;
  std::set<std::size_t> all;
  const Backup backup = must(make_backup(store->context(), administrator, into(), [&](std::size_t pages, std::size_t of) {
    done.push_back(pages);
    all.insert(of);
    return true;
  }));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_GT(backup.bytes, 12'000'000u);
  EXPECT_GT(*all.begin(), 12'000'000u / 65536u) << "no page is larger";
  EXPECT_EQ(done.front(), 0u);
  EXPECT_EQ(done.back(), *all.begin());
  EXPECT_TRUE(std::ranges::is_sorted(done));
  EXPECT_TRUE(std::ranges::any_of(done, [&](std::size_t pages) { return pages > 0 && pages < done.back(); })) << "between its begin and its end";
}

TEST_F(StoppedBackup, leaves_the_folder_and_the_log_as_they_were) {
  must(make_backup(store->context(), administrator, into()));
  const auto before = files_there();
  const auto logged = entries();
  const std::function<bool(std::size_t, std::size_t)> moments[] = {
      [](std::size_t done, std::size_t) { return done == 0; },
      [](std::size_t done, std::size_t all) { return done > 0 && done < all; },
      [](std::size_t done, std::size_t all) { return done == all; },
  };
  for (const auto& is_moment : moments) {
    bool met = false;
    const auto stopped = make_backup(store->context(), administrator, into(), [&](std::size_t done, std::size_t all) {
      met = met || is_moment(done, all);
      return !met;
    });
    EXPECT_TRUE(met);
    ASSERT_EQ(code_of(stopped), StorageError::stopped);
    EXPECT_EQ(stopped.error().where, into().string());
    EXPECT_EQ(files_there(), before);
    EXPECT_EQ(entries(), logged) << "the log names no backup that is not there";
  }
  EXPECT_EQ(must(backups_in(into(), store->context().station)).size(), 1u);
  must(make_backup(store->context(), administrator, into()));
}

TEST_F(StoppedBackup, takes_away_the_folder_that_was_made_for_it) {
  const auto stopped = make_backup(store->context(), administrator, into(), [](std::size_t, std::size_t) { return false; });
  EXPECT_EQ(code_of(stopped), StorageError::stopped);
  EXPECT_FALSE(fs::exists(into()));
}

}  // namespace
}  // namespace cusp::test
