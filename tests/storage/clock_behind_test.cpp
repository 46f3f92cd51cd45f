/// Whether a clock that shows an old date is found, and one that was ahead is forgiven in the end.
#include <gtest/gtest.h>

#include "storage/retention/clock_doubt.h"
#include "tests/storage/old_attempts.h"

namespace cusp::test {
namespace {

struct ClockBehind : OldAttempts {
  std::optional<std::int64_t> found() { return must(clock_behind(store->context())); }
  /// From then on the clock shows this; somebody signs in.
  void use_at(std::int64_t utc_us) {
    *now = utc_us;
    must(store->audit.add({.actor = admin.id, .action = "signed_in"}));
  }
};

TEST_F(ClockBehind, is_not_found_while_no_attempt_is_dated_later_than_a_day_after_now) {
  EXPECT_FALSE(found());
  attempt(0);
  EXPECT_FALSE(found());
  *now = kNow - kDay_us;
  EXPECT_FALSE(found());
}

TEST_F(ClockBehind, is_found_at_each_start_of_a_computer_that_begins_at_an_old_date) {
  attempt(0);
  for (int start = 0; start < 3; ++start) {
    use_at(kNow - 2000 * kDay_us);
    EXPECT_EQ(found(), kNow) << start;
    attempt(2000);
    use_at(kNow - 2000 * kDay_us + kDay_us / 3);
    EXPECT_EQ(found(), kNow) << start << ", after eight hours of use";
  }
}

TEST_F(ClockBehind, is_forgiven_once_the_station_was_used_for_two_weeks_after_a_clock_that_was_ahead) {
  attempt(-400);
  use_at(kNow);
  EXPECT_TRUE(found());
  use_at(kNow + kShortestUse_us - 1);
  EXPECT_TRUE(found());
  use_at(kNow + kShortestUse_us);
  EXPECT_FALSE(found());
}

}  // namespace
}  // namespace cusp::test
