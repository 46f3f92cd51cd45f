/// Students without an attempt for years: who is erased, and who waits for a release.
#include <gtest/gtest.h>

#include "storage/retention/departed.h"
#include "tests/storage/old_attempts.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

constexpr int kThreeYears = 1096;  // 3 x 365.25 days are 1,095.75

struct DepartedTest : OldAttempts {
  DepartedTest() : OldAttempts(3000) {}
  const Account lena = student;
  /// Entries of the log that lie less than half a year apart, from before the three years up to so many days ago.
  void log_until(int days_ago) {
    for (int at = kThreeYears + 4; at > days_ago; at -= 150) {
      *now = kNow - at * kDay_us;
      must(store->audit.add({.actor = admin.id, .action = "signed_in", .subject = admin.id.uuid, .detail = {}}));
    }
    *now = kNow;
  }
  /// After everything older: in use until today, so that the clock is believed, and lena is no departed student.
  void use_lately() {
    log_until(21);
    student = lena;
    attempt(21);
    attempt(0);
  }
  static std::vector<std::string> numbers(const std::vector<DepartedStudent>& students) {
    std::vector<std::string> out;
    for (const DepartedStudent& s : students) out.push_back(s.account.number);
    return out;
  }
  Account enrolled(const std::string& number, int days_ago) {
    *now = kNow - days_ago * kDay_us;
    const Account account = make_student(*store, number, "Student " + number);
    *now = kNow;
    return account;
  }
  using Numbers = std::vector<std::string>;
};

TEST_F(DepartedTest, are_students_whose_newest_attempt_is_older_than_the_school_says) {
  const Account gone = enrolled("gone", 3000), stays = enrolled("stays", 3000);
  student = stays;
  attempt(3000);
  enrolled("never", kThreeYears);
  student = gone;
  attempt(kThreeYears);
  enrolled("new", kThreeYears - 1);
  student = stays;
  attempt(kThreeYears - 1);
  use_lately();
  const DepartedStudents found = must(departed_students(store->context(), admin, 3));
  EXPECT_EQ(numbers(found.erasable), (Numbers{"gone", "never"})) << "20267314 is there, and the staff are no students";
  EXPECT_EQ(found.erasable[0].last_utc_us, kNow - kThreeYears * kDay_us);
  EXPECT_TRUE(found.waiting.empty());
  EXPECT_TRUE(store->accounts.find_number("gone")) << "a dry run erases nobody";
}

TEST_F(DepartedTest, are_erased_like_anybody_and_their_attempts_verify) {
  student = enrolled("gone", 3000);
  attempt(kThreeYears);
  use_lately();
  EXPECT_EQ(must(erase_departed(store->context(), admin, 3)).erasable.size(), 1u);
  EXPECT_EQ(code_of(store->accounts.find_number("gone")), StorageError::not_found);
  EXPECT_TRUE(must(departed_students(store->context(), admin, 3)).erasable.empty());
  EXPECT_EQ(findings(), "");
}

TEST_F(DepartedTest, who_worked_yesterday_under_a_clock_seven_years_back_stay) {
  const Account worked = enrolled("worked", 3000);
  student = enrolled("gone", 3000);
  attempt(8 * 365);
  use_lately();
  student = worked;
  attempt(7 * 365);
  EXPECT_EQ(numbers(must(departed_students(store->context(), admin, 3)).erasable), Numbers{"gone"});
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3)).erasable), Numbers{"gone"});
  EXPECT_TRUE(store->accounts.find_number("worked"));
}

TEST_F(DepartedTest, who_were_enrolled_yesterday_under_a_clock_seven_years_back_stay) {
  enrolled("gone", 8 * 365);
  use_lately();
  enrolled("new", 7 * 365);
  EXPECT_EQ(numbers(must(departed_students(store->context(), admin, 3)).erasable), Numbers{"gone"});
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3)).erasable), Numbers{"gone"});
  EXPECT_TRUE(store->accounts.find_number("new"));
}

TEST_F(DepartedTest, who_came_back_after_they_were_listed_stay) {
  const Account back = enrolled("back", 3000);
  enrolled("gone", 3000);
  use_lately();
  const auto other = open(folder / "a.db", quick(now));
  int asked = 0;
  // First for the list, then for the clock's doubt: by then the list is read.
  store->context().clock = [&] {
    if (++asked == 2) complete_session(*other, back, version);
    return *now;
  };
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3)).erasable), Numbers{"gone"});
  EXPECT_TRUE(store->accounts.find_number("back"));
  EXPECT_EQ(code_of(store->accounts.find_number("gone")), StorageError::not_found);
}

TEST_F(DepartedTest, whose_erasure_a_write_ends_are_reported_with_what_ended_it) {
  for (const char* number : {"a", "b", "c"}) enrolled(number, kThreeYears);
  use_lately();
  must(store->database().run("CREATE UNIQUE INDEX one_erased ON people (iif(name = '–', '', number))"));  // refuses the second
  const DepartedStudents erased = must(erase_departed(store->context(), admin, 3));
  EXPECT_EQ(erased.erasable.size(), 1u);
  EXPECT_TRUE(erased.failed);
  EXPECT_EQ(must(departed_students(store->context(), admin, 3)).erasable.size(), 2u);
  EXPECT_FALSE(erase_departed(store->context(), admin, 3)) << "nobody is erased";
}

TEST_F(DepartedTest, who_are_erased_when_the_watch_stops_are_named) {
  for (const char* number : {"a", "b", "c"}) enrolled(number, kThreeYears);
  use_lately();
  int asked = 0;
  const DepartedStudents erased = must(erase_departed(store->context(), admin, 3, ClockTrust::checked, [&] { return ++asked < 3; }));
  EXPECT_TRUE(erased.stopped);
  ASSERT_EQ(erased.erasable.size(), 2u);
  for (const DepartedStudent& one : erased.erasable) EXPECT_EQ(code_of(store->accounts.find_number(one.account.number)), StorageError::not_found);
  EXPECT_EQ(must(departed_students(store->context(), admin, 3)).erasable.size(), 1u);
}

TEST_F(DepartedTest, wait_while_an_assessment_of_theirs_is_not_released) {
  student = enrolled("sat", 3000);
  const SessionId sat = assessment(kThreeYears);
  use_lately();
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3)).waiting), Numbers{"sat"});
  EXPECT_TRUE(store->accounts.find_number("sat"));
  must(store->statements.release(instructor, sat));
  EXPECT_EQ(numbers(must(departed_students(store->context(), admin, 3)).erasable), Numbers{"sat"});
}

TEST_F(DepartedTest, stay_while_the_clock_is_far_ahead_of_every_record_until_it_is_confirmed) {
  enrolled("gone", 3000);
  use_lately();
  *now = kNow + kLongestPause_us;
  EXPECT_FALSE(must(departed_students(store->context(), admin, 3)).doubt) << "a long vacation";
  attempt(-300);
  *now = kNow + kLongestPause_us + 1;
  must(store->accounts.sign_in("admin", "correct horse"));
  const auto doubt = must(departed_students(store->context(), admin, 3)).doubt;
  ASSERT_TRUE(doubt) << "the sign-in and the attempt of another wrong clock tell nothing";
  EXPECT_EQ(doubt->code, StorageError::clock_ahead);
  EXPECT_EQ(doubt->detail, std::to_string(kNow) + ' ' + std::to_string(*now));
  EXPECT_EQ(code_of(erase_departed(store->context(), admin, 3)), StorageError::clock_ahead);
  EXPECT_TRUE(store->accounts.find_number("gone"));
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3, ClockTrust::confirmed)).erasable), Numbers{"gone"});
}

TEST_F(DepartedTest, stay_as_long_as_the_limit_after_the_first_attempt_under_a_clock_far_ahead) {
  enrolled("gone", 3000);
  use_lately();
  attempt(-1000);
  *now = kNow + 1001 * kDay_us;
  const auto doubt = must(departed_students(store->context(), admin, 3)).doubt;
  ASSERT_TRUE(doubt) << "the clock in question dated the one attempt";
  EXPECT_EQ(doubt->where, "pause");
  EXPECT_EQ(doubt->detail, std::to_string(kNow) + ' ' + std::to_string(*now) + ' ' + std::to_string(kNow + 1000 * kDay_us));
  EXPECT_EQ(code_of(erase_departed(store->context(), admin, 3)), StorageError::clock_ahead);
  EXPECT_TRUE(store->accounts.find_number("gone"));
  const int limit = 1000 + kThreeYears;
  for (int later = 1014; later <= limit; later += 150) attempt(-later);
  *now = kNow + (limit - 1) * kDay_us;
  EXPECT_TRUE(must(departed_students(store->context(), admin, 3)).doubt) << "the gap ended less than three years ago";
  *now = kNow + limit * kDay_us;
  EXPECT_FALSE(must(departed_students(store->context(), admin, 3)).doubt);
}

TEST_F(DepartedTest, stay_for_weeks_after_a_clock_that_stood_years_back_at_the_first_start) {
  enrolled("new", 3000);
  student = lena;
  attempt(21);
  attempt(0);
  const DepartedStudents found = must(departed_students(store->context(), admin, 3));
  EXPECT_EQ(numbers(found.erasable), Numbers{"new"});
  ASSERT_TRUE(found.doubt) << "made three weeks ago, for all that the log proves";
  EXPECT_EQ(found.doubt->where, "pause");
  EXPECT_EQ(found.doubt->detail, std::to_string(kNow - 3000 * kDay_us) + ' ' + std::to_string(kNow) + ' ' + std::to_string(kNow - 21 * kDay_us));
  EXPECT_EQ(code_of(erase_departed(store->context(), admin, 3)), StorageError::clock_ahead);
  EXPECT_TRUE(store->accounts.find_number("new"));
  EXPECT_EQ(numbers(must(erase_departed(store->context(), admin, 3, ClockTrust::confirmed)).erasable), Numbers{"new"});
}

/// An office that reads a station's file eight years ago, or yesterday: the station's attempt is dated seven years back.
struct DepartedElsewhere : TwoStations {
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow - 8 * 365 * kDay_us);
  std::unique_ptr<Store> school = open(folder / "school.db", quick(now)), other = open(folder / "other.db", quick(now));
  Actor head = make_administrator(*school, "head").actor();
  Account gone = make_student(*other, "gone", "Omar Haddad");

  /// Accounts that vouch for the school's clock, three weeks of it.
  void use_lately() {
    for (const int days_ago : {21, 0}) {
      *now = kNow - days_ago * kDay_us;
      must(school->accounts.create(head, {.number = "new " + std::to_string(days_ago), .name = "Lena Brandt"}));
    }
  }
  void read_attempts() {
    const std::filesystem::path file = next_file();
    must(give_out(other->context(), {UserId::make(), Role::administrator}, ExchangeKind::results, file));
    must(read_in(school->context(), head, file));
  }
  std::vector<std::string> erasable() {
    std::vector<std::string> out;
    for (const DepartedStudent& s : must(departed_students(school->context(), head, 3)).erasable) out.push_back(s.account.number);
    return out;
  }
};

TEST_F(DepartedElsewhere, are_gone_if_their_attempts_were_read_in_long_ago) {
  must(trust(school->context(), head, key_of_station(*other), KeyRole::station));
  complete_session(*other, gone, keep(*other));
  read_attempts();
  use_lately();
  EXPECT_EQ(erasable(), std::vector<std::string>{"gone"});
}

TEST_F(DepartedElsewhere, stay_if_an_attempt_of_a_clock_seven_years_back_was_read_in_after_younger_entries) {
  must(trust(school->context(), head, key_of_station(*other), KeyRole::station));
  complete_session(*other, gone, keep(*other));
  read_attempts();
  use_lately();
  *now = kNow - 7 * 365 * kDay_us;
  complete_session(*other, gone, keep(*other));
  *now = kNow;
  read_attempts();
  EXPECT_TRUE(erasable().empty());
}

TEST_F(DepartedElsewhere, stay_if_the_reading_of_such_an_attempt_is_the_first_young_entry) {
  must(trust(school->context(), head, key_of_station(*other), KeyRole::station));
  complete_session(*other, gone, keep(*other));
  read_attempts();
  complete_session(*other, gone, keep(*other));
  *now = kNow;
  read_attempts();
  EXPECT_TRUE(erasable().empty());
}

TEST_F(DepartedElsewhere, stay_at_an_office_whose_clock_stood_years_back_though_attempts_that_it_read_fill_the_years) {
  must(trust(school->context(), head, key_of_station(*other), KeyRole::station));
  must(school->accounts.create(head, {.number = "new", .name = "Ida Falk"}));
  for (int days_ago = 8 * 365 - 150; days_ago > 21; days_ago -= 150) {
    *now = kNow - days_ago * kDay_us;
    complete_session(*other, gone, keep(*other));
  }
  *now = kNow - 21 * kDay_us;
  read_attempts();
  use_lately();
  EXPECT_EQ(erasable(), std::vector<std::string>{"new"});
  EXPECT_EQ(code_of(erase_departed(school->context(), head, 3)), StorageError::clock_ahead);
  EXPECT_TRUE(school->accounts.find_number("new"));
}

TEST_F(DepartedTest, are_for_administrators_and_for_whole_years) {
  EXPECT_EQ(code_of(departed_students(store->context(), instructor, 3)), StorageError::not_allowed);
  EXPECT_EQ(code_of(erase_departed(store->context(), student.actor(), 3)), StorageError::not_allowed);
  EXPECT_EQ(code_of(departed_students(store->context(), admin, 0)), StorageError::bad_value);
  EXPECT_EQ(code_of(departed_students(store->context(), admin, kMostRetainedYears + 1)), StorageError::bad_value);
}

}  // namespace
}  // namespace cusp::test
