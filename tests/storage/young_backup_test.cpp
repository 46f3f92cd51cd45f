/// When a daily backup is young enough, under each kind of clock.
#include <gtest/gtest.h>

#include "storage/backup/young_backup.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kAge_us = 86'400'000'000, kOneHour_us = 3'600'000'000, kOneSecond_us = 1'000'000;

class YoungBackup : public testing::Test {
 protected:
  Backup make_daily() { return must(make_backup(store->context(), std::nullopt, folder / "backups")); }
  bool is_there() { return must(young_daily_backup(store->context(), folder / "backups", kAge_us)).has_value(); }
  /// From then on the clock shows this; somebody signs in.
  void use_at(std::int64_t utc_us) {
    *now = utc_us;
    must(store->audit.add({.action = "signed_in"}));
  }
  const Folder folder;
  const std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  const std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
};

TEST_F(YoungBackup, is_one_of_less_than_a_day_ago) {
  EXPECT_FALSE(is_there());
  make_daily();
  use_at(kNow + kAge_us - 1);
  EXPECT_TRUE(is_there());
  *now = kNow + kAge_us;
  EXPECT_FALSE(is_there());
}

TEST_F(YoungBackup, is_none_that_an_administrator_made) {
  const Actor administrator = make_administrator(*store).actor();
  must(make_backup(store->context(), administrator, folder / "backups"));
  EXPECT_FALSE(is_there());
}

TEST_F(YoungBackup, is_none_that_has_gone_from_the_folder) {
  const Backup made = make_daily();
  std::filesystem::remove_all(made.folder);
  EXPECT_FALSE(is_there());
}

TEST_F(YoungBackup, is_none_whose_date_a_clock_that_was_ahead_gave) {
  *now = kNow + 400 * kAge_us;
  make_daily();
  *now = kNow;
  EXPECT_FALSE(is_there());
}

TEST_F(YoungBackup, is_one_also_after_the_clock_was_corrected_by_an_hour) {
  make_daily();
  use_at(kNow - kOneHour_us);
  EXPECT_TRUE(is_there());
}

TEST_F(YoungBackup, of_a_clock_that_starts_at_the_same_date_each_time_is_one_until_an_hour_was_used) {
  use_at(kNow);
  *now = kNow + 80 * kOneSecond_us;
  make_daily();
  use_at(kNow + 20 * kOneSecond_us);  // the second start, some seconds earlier by its clock
  EXPECT_TRUE(is_there()) << "each start would make one";
  use_at(kNow + 5 * kOneHour_us);
  use_at(kNow + 90 * kOneSecond_us);  // the third start
  EXPECT_FALSE(is_there()) << "it may be of another day, though the date is of a minute ago";
  make_daily();
  EXPECT_TRUE(is_there());
}

TEST_F(YoungBackup, under_a_clock_that_the_network_set_a_minute_after_the_start_is_as_young_as_what_came_before_the_start) {
  use_at(kNow);
  use_at(kNow - 3000 * kAge_us);  // the battery is empty
  make_daily();
  use_at(kNow - 3000 * kAge_us + kOneHour_us);
  use_at(kNow + 14 * kOneHour_us);
  EXPECT_TRUE(is_there()) << "each start would make two";
  use_at(kNow + 24 * kOneHour_us);
  EXPECT_FALSE(is_there()) << "it may have been made a day ago";
}

TEST_F(YoungBackup, is_none_after_two_months_without_use) {
  use_at(kNow);
  make_daily();
  use_at(kNow + 60 * kAge_us);
  EXPECT_FALSE(is_there());
}

}  // namespace
}  // namespace cusp::test
