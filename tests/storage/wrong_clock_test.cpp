/// Backups that a wrong clock has dated: their order, and which of them go.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "storage/backup/backup.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kOneDay_us = 86'400'000'000, kSecond_us = 1'000'000;
constexpr std::int64_t kEmptyBattery = kNow - 3000 * kOneDay_us;  // the date at which such a clock starts

class WrongClock : public testing::Test {
 protected:
  Backup daily_at(std::int64_t utc_us) {
    *now = utc_us;
    return must(make_backup(store->context(), std::nullopt, into));
  }
  std::vector<std::string> listed() {
    std::vector<std::string> out;
    for (const Backup& one : must(backups_in(into, store->context().station))) out.push_back(one.folder);
    return out;
  }
  void keep_six() { must(thin_backups(into, store->context().station, BackupKind::daily, 6, *now)); }
  const Folder folder;
  const std::filesystem::path into = folder / "backups";
  const std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
};

TEST_F(WrongClock, puts_no_older_backup_before_the_newest) {
  const std::string first = daily_at(kNow).folder, behind = daily_at(kEmptyBattery).folder;
  EXPECT_EQ(listed(), (std::vector{behind, first}));
  const std::string ahead = daily_at(kNow + 3000 * kOneDay_us).folder, right = daily_at(kNow + kOneDay_us).folder;
  EXPECT_EQ(listed(), (std::vector{right, ahead, behind, first}));
}

TEST_F(WrongClock, that_starts_at_the_same_date_each_time_pushes_half_of_those_from_before_out_and_no_more) {
  std::vector<std::string> good, behind;
  for (int day = 0; day < 6; ++day) good.push_back(daily_at(kNow + day * kOneDay_us).folder);
  for (int start = 0; start < 20; ++start) {
    behind.push_back(daily_at(kEmptyBattery + start * kSecond_us).folder);
    keep_six();
  }
  EXPECT_EQ(listed(), (std::vector{behind[19], behind[18], behind[17], good[5], good[4], good[3]}));
  const std::string right = daily_at(kNow + 30 * kOneDay_us).folder;
  keep_six();
  EXPECT_EQ(listed(), (std::vector{right, behind[19], behind[18], behind[17], good[5], good[4]})) << "what is newer stays longer, whatever its date";
}

TEST_F(WrongClock, does_not_make_old_what_is_made_after_a_restore) {
  const Backup early = daily_at(kNow);
  for (int i = 0; i < 5; ++i) must(store->audit.add({.action = "signed_in"}));
  const std::string late = daily_at(kNow + kOneDay_us).folder;
  must(restore_backup(early, folder / "b.db"));
  store = open(folder / "b.db", quick(now));
  const std::string since = daily_at(kNow + 2 * kOneDay_us).folder;
  EXPECT_EQ(listed(), (std::vector{since, late, early.folder.string()})) << "the log is shorter than that of the one before";
}

TEST_F(WrongClock, of_an_older_program_gives_the_order_where_no_other_is_known) {
  const Backup older = daily_at(kNow), newer = daily_at(kNow + kOneDay_us);
  for (const Backup& one : {older, newer}) {
    std::ofstream(one.folder / kBackupDescription) << R"({"cusp_backup": 1, "station": ")" << one.station.text() << R"(", "made_at": )" << one.made_utc_us
                                                   << R"(, "sessions": 0, "bytes": 4096, "kind": "daily"})";
  }
  EXPECT_EQ(listed(), (std::vector{newer.folder.string(), older.folder.string()}));
  const std::string behind = daily_at(kEmptyBattery).folder;
  EXPECT_EQ(listed(), (std::vector{behind, newer.folder.string(), older.folder.string()}));
}

}  // namespace
}  // namespace cusp::test
