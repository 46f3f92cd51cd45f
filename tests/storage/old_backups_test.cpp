/// Old backups that cannot be removed, and those that must not be.
#include <gtest/gtest.h>

#include "storage/backup/backup.h"
#include "tests/storage/school.h"
#include "tests/unremovable.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

/// One a day.
class OldBackups : public testing::Test {
 protected:
  Backup make() {
    *now += kDay_us;
    return must(make_backup(store->context(), administrator, folder / "backups"));
  }
  const Folder folder;
  const std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  const std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  const Actor administrator = make_administrator(*store).actor();
};

TEST_F(OldBackups, that_cannot_be_removed_are_named_and_keep_no_other_from_going) {
  const Backup oldest = make(), stays = make();
  make();
  const Unremovable held(stays.folder);
  if (!held.holds()) GTEST_SKIP() << "root may remove every file here";
  const auto thinned = thin_backups(folder / "backups", store->context().station, 1, *now);
  ASSERT_FALSE(thinned);
  EXPECT_EQ(thinned.error().where, stays.folder.string());
  EXPECT_FALSE(thinned.error().detail.empty()) << "the cause, as the system names it";
  EXPECT_FALSE(std::filesystem::exists(oldest.folder));
}

TEST_F(OldBackups, that_a_link_leads_to_stay_whole_and_take_no_place_of_another) {
  const Backup elsewhere = make(), oldest = make(), newest = make();
  std::filesystem::rename(elsewhere.folder, folder / "elsewhere");
  std::filesystem::create_directory_symlink(folder / "elsewhere", elsewhere.folder);
  must(thin_backups(folder / "backups", store->context().station, 1, *now));
  EXPECT_EQ(must(read_backup(folder / "elsewhere")).made_utc_us, elsewhere.made_utc_us);
  EXPECT_TRUE(std::filesystem::is_symlink(elsewhere.folder));
  EXPECT_FALSE(std::filesystem::exists(oldest.folder));
  EXPECT_TRUE(std::filesystem::exists(newest.folder));
}

}  // namespace
}  // namespace cusp::test
