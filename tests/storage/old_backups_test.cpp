/// Old backups that cannot be removed, and those that must not be.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>

#include "storage/backup/backup.h"
#include "tests/storage/school.h"
#include "tests/unremovable.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

/// One a day.
class OldBackups : public testing::Test {
 protected:
  Backup make() { return made_by(administrator); }
  Backup make_daily() { return made_by(std::nullopt); }
  void keep_one(BackupKind kind) { must(thin_backups(folder / "backups", store->context().station, kind, 1, *now)); }
  static bool is_there(const Backup& backup) { return std::filesystem::exists(backup.folder); }
  const Folder folder;
  const std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  const std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  const Actor administrator = make_administrator(*store).actor();

 private:
  Backup made_by(const std::optional<Actor>& actor) {
    *now += kDay_us;
    return must(make_backup(store->context(), actor, folder / "backups"));
  }
};

TEST_F(OldBackups, that_cannot_be_removed_are_named_and_keep_no_other_from_going) {
  const Backup oldest = make(), stays = make();
  make();
  const Unremovable held(stays.folder);
  if (!held.holds()) GTEST_SKIP() << "root may remove every file here";
  const auto thinned = thin_backups(folder / "backups", store->context().station, BackupKind::manual, 1, *now);
  ASSERT_FALSE(thinned);
  EXPECT_EQ(thinned.error().where, stays.folder.string());
  EXPECT_FALSE(thinned.error().detail.empty()) << "the cause, as the system names it";
  EXPECT_FALSE(std::filesystem::exists(oldest.folder));
}

TEST_F(OldBackups, that_the_program_made_daily_stay_however_many_somebody_makes) {
  const Backup daily = make_daily(), oldest = make(), newest = make();
  EXPECT_EQ(daily.kind, BackupKind::daily);
  EXPECT_EQ(newest.kind, BackupKind::manual);
  keep_one(BackupKind::manual);
  EXPECT_TRUE(is_there(daily)) << "the oldest of all, and the only one of its kind";
  EXPECT_FALSE(is_there(oldest));
  EXPECT_TRUE(is_there(newest));
}

TEST_F(OldBackups, that_somebody_made_stay_however_many_the_program_makes_daily) {
  const Backup manual = make(), oldest = make_daily(), newest = make_daily();
  keep_one(BackupKind::daily);
  EXPECT_TRUE(is_there(manual));
  EXPECT_FALSE(is_there(oldest));
  EXPECT_TRUE(is_there(newest));
}

TEST_F(OldBackups, whose_description_names_no_kind_count_as_daily_ones) {
  const Backup older = make(), manual = make();
  std::ofstream(older.folder / kBackupDescription) << R"({"cusp_backup": 1, "station": ")" << older.station.text()
                                                   << R"(", "made_at": )" << older.made_utc_us << R"(, "sessions": 0, "bytes": 4096})";
  EXPECT_EQ(must(read_backup(older.folder)).kind, BackupKind::daily);
  EXPECT_EQ(must(read_backup(manual.folder)).kind, BackupKind::manual);
  make();
  keep_one(BackupKind::manual);
  EXPECT_TRUE(is_there(older));
  EXPECT_FALSE(is_there(manual));
  make_daily();
  keep_one(BackupKind::daily);
  EXPECT_FALSE(is_there(older));
}

TEST_F(OldBackups, that_were_cut_off_a_day_ago_make_room_for_the_next_one_before_that_is_whole) {
  const Backup cut_off = make(), whole = make();
  std::filesystem::remove(cut_off.folder / kBackupDescription);
  const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(48);
  for (const auto& file : std::filesystem::directory_iterator(cut_off.folder)) std::filesystem::last_write_time(file.path(), long_ago);
  std::filesystem::last_write_time(cut_off.folder, long_ago);
  const auto stopped = make_backup(store->context(), administrator, folder / "backups", [](std::size_t, std::size_t) { return false; });
  EXPECT_EQ(code_of(stopped), StorageError::stopped) << "as on a full disk: nobody thins then";
  EXPECT_FALSE(is_there(cut_off));
  EXPECT_TRUE(is_there(whole));
}

TEST_F(OldBackups, in_a_folder_that_the_system_cannot_reach_are_not_reported_as_none) {
  make();
  const std::filesystem::path loop = folder / "loop";
  std::filesystem::create_symlink("loop", loop);  // nobody reaches it, root neither
  EXPECT_EQ(code_of(backups_in(loop, std::nullopt)), StorageError::io);
  EXPECT_TRUE(must(backups_in(folder / "nowhere", std::nullopt)).empty());
}

TEST_F(OldBackups, that_a_link_leads_to_stay_whole_and_take_no_place_of_another) {
  const Backup elsewhere = make(), oldest = make(), newest = make();
  std::filesystem::rename(elsewhere.folder, folder / "elsewhere");
  std::filesystem::create_directory_symlink(folder / "elsewhere", elsewhere.folder);
  must(thin_backups(folder / "backups", store->context().station, BackupKind::manual, 1, *now));
  EXPECT_EQ(must(read_backup(folder / "elsewhere")).made_utc_us, elsewhere.made_utc_us);
  EXPECT_TRUE(std::filesystem::is_symlink(elsewhere.folder));
  EXPECT_FALSE(std::filesystem::exists(oldest.folder));
  EXPECT_TRUE(std::filesystem::exists(newest.folder));
}

}  // namespace
}  // namespace cusp::test
