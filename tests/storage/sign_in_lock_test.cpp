// Wrong tries of a secret: how many, what they lock and for how long, and what holds for a try that runs meanwhile.
#include <gtest/gtest.h>

#include "tests/storage/accounts.h"

namespace cusp::test {
namespace {

using SignInLockTest = AccountsTest;

TEST_F(SignInLockTest, five_wrong_tries_lock_for_half_a_minute_and_each_further_one_twice_as_long) {
  make_student(*store);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  const auto locked = accounts.sign_in("20267314", "battery staple");  // the right one, too early
  ASSERT_FALSE(locked);
  EXPECT_EQ(locked.error().code, StorageError::locked);
  EXPECT_EQ(locked.error().detail, std::to_string(kNow + 30'000'000));
  *now += 30'000'000;
  EXPECT_EQ(code_of(accounts.sign_in_with_pin("20267314", "000000")), StorageError::wrong_password);
  *now += 59'999'999;
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "battery staple")), StorageError::locked);
  *now += 1;
  EXPECT_TRUE(accounts.sign_in("20267314", "battery staple"));
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  EXPECT_TRUE(accounts.sign_in("20267314", "battery staple"));  // counting began anew
}

TEST_F(SignInLockTest, a_lock_of_a_clock_that_was_set_back_ends_and_hides_none_in_memory) {
  const Account student = make_student(*store);
  constexpr std::int64_t year = 365 * std::int64_t{86'400'000'000};
  *now += year;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  *now -= 60'000'000;
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "battery staple")), StorageError::locked);
  *now -= year;
  StoreOptions reading = quick(now);
  reading.database.access = DatabaseOptions::Access::read_only;
  const auto reader = open(folder / "a.db", reading);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(reader->accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  EXPECT_EQ(code_of(reader->accounts.sign_in("20267314", "battery staple")), StorageError::locked);
  EXPECT_EQ(code_of(reader->accounts.set_password(student.actor(), student.id, "battery staple", "new password")), StorageError::locked);
  EXPECT_TRUE(accounts.sign_in("20267314", "battery staple"));
}

TEST_F(SignInLockTest, what_another_process_does_while_a_secret_is_compared_holds_for_that_try) {
  const Actor admin = make_administrator(*store).actor();
  const Account student = make_student(*store);
  const auto other = other_process();
  const auto five_wrong_tries = [&] {
    for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(accounts.sign_in_with_pin("20267314", "000000")), StorageError::wrong_password);
  };
  for (const char* pin : {"314159", "271828"}) {
    meanwhile = five_wrong_tries;
    EXPECT_EQ(code_of(other->accounts.sign_in_with_pin("20267314", pin)), StorageError::locked) << pin;
    must(accounts.set_pin(admin, student.id, "314159"));  // ends the lock
  }
  meanwhile = [&] { must(accounts.set_pin(admin, student.id, "161803")); };
  EXPECT_EQ(code_of(other->accounts.sign_in_with_pin("20267314", "314159")), StorageError::wrong_password);
  meanwhile = [&] { must(accounts.disable(admin, student.id)); };
  EXPECT_EQ(code_of(other->accounts.sign_in_with_pin("20267314", "161803")), StorageError::disabled);
  const Account second = must(accounts.create(admin, {.number = "b", .name = "B", .role = Role::administrator, .password = "correct horse"}));
  meanwhile = [&] { must(accounts.set_role(admin, second.id, Role::student)); };
  EXPECT_EQ(must(other->accounts.sign_in("b", "correct horse")).role, Role::student);
}

TEST_F(SignInLockTest, the_longest_lock_holds_for_a_try_that_began_a_moment_before_it) {
  make_student(*store);
  const auto other = other_process();
  const auto wrong_try = [&] { EXPECT_EQ(code_of(accounts.sign_in_with_pin("20267314", "000000")), StorageError::wrong_password); };
  constexpr std::int64_t kLongest_us = 900'000'000, kToCompare_us = 100'000;
  for (const char* pin : {"314159", "271828"}) {
    for (int i = 0; i < 9; ++i, *now += kLongest_us) wrong_try();
    meanwhile = [&] {
      *now += kToCompare_us;
      wrong_try();  // the tenth: 15 minutes
    };
    EXPECT_EQ(code_of(other->accounts.sign_in_with_pin("20267314", pin)), StorageError::locked) << pin;
    *now += kLongest_us;
    must(accounts.sign_in_with_pin("20267314", "314159"));  // counting begins anew
  }
}

TEST_F(SignInLockTest, wrong_tries_at_records_that_are_read_only_lock_as_long_as_the_program_runs) {
  make_student(*store);
  StoreOptions reading = quick(now);
  reading.database.access = DatabaseOptions::Access::read_only;
  reading.tries = std::make_shared<UnwrittenTries>();
  const auto first = open(folder / "a.db", reading), second = open(folder / "a.db", reading);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of((i % 2 == 0 ? first : second)->accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  const auto refused = second->accounts.sign_in("20267314", "battery staple");
  EXPECT_EQ(code_of(refused), StorageError::locked);
  EXPECT_EQ(refused.error().detail, std::to_string(*now + 30'000'000));
  *now += 30'000'001;
  EXPECT_TRUE(second->accounts.sign_in("20267314", "battery staple"));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(code_of(first->accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
  EXPECT_TRUE(first->accounts.sign_in("20267314", "battery staple")) << "counting began anew";
}

TEST_F(SignInLockTest, a_wrong_old_password_counts_and_locks_as_at_sign_in) {
  const Account student = make_student(*store);
  const auto change = [&](const char* old) { return accounts.set_password(student.actor(), student.id, old, "new password"); };
  for (int i = 0; i < 9; ++i) EXPECT_EQ(code_of(change("")), StorageError::wrong_password) << "nothing was typed";
  for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(change("wrong")), StorageError::wrong_password);
  EXPECT_EQ(code_of(change("battery staple")), StorageError::locked);
  EXPECT_EQ(code_of(accounts.sign_in("20267314", "battery staple")), StorageError::locked);
  *now += 30'000'001;
  must(change("battery staple"));
  EXPECT_TRUE(accounts.sign_in("20267314", "new password"));
}

TEST_F(SignInLockTest, what_another_process_does_while_an_old_password_is_compared_holds_for_that_try) {
  const Actor admin = make_administrator(*store).actor();
  const Account student = make_student(*store);
  const auto other = other_process();
  const auto change = [&](const char* old) { return other->accounts.set_password(student.actor(), student.id, old, "new password"); };
  for (const char* old : {"battery staple", "wrong password"}) {
    meanwhile = [&] {
      for (int i = 0; i < 5; ++i) EXPECT_EQ(code_of(accounts.sign_in("20267314", "guess")), StorageError::wrong_password);
    };
    EXPECT_EQ(code_of(change(old)), StorageError::locked) << old;
    *now += 30'000'000;
    must(accounts.sign_in("20267314", "battery staple"));  // counting begins anew
  }
  meanwhile = [&] { must(accounts.set_password(admin, student.id, "", "given by the office")); };
  EXPECT_EQ(code_of(change("battery staple")), StorageError::wrong_password);
  must(accounts.sign_in("20267314", "given by the office"));
}

}  // namespace
}  // namespace cusp::test
