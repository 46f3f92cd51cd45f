/// A list of students is added whole, or nothing of it.
#include "storage/repositories/student_lines.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/storage/accounts.h"
#include "tests/storage/killed.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Of a year, whose numbers begin with `year`.
std::vector<StudentLine> students(const std::string& year, int count) {
  std::vector<StudentLine> out;
  for (int i = 100; i < 100 + count; ++i)
    out.push_back({.account = {.number = year + std::to_string(i), .name = "Lena Brandt", .pin = "314159"}, .cohort = "Year " + year});
  return out;
}

struct StudentLinesTest : AccountsTest {
  Actor admin = make_administrator(*store).actor();

  std::int64_t rows(const std::string& table) {
    return must(store->database().first("SELECT count(*) FROM " + table, [](Row row) { return row.integer(0); })).value_or(-1);
  }
};

TEST_F(StudentLinesTest, become_accounts_that_sign_in_and_join_one_cohort_whatever_the_case_of_its_name) {
  const Account known = make_student(*store, "1000", "Omar Haddad");
  std::vector<StudentLine> lines = students("1", 2);
  lines.push_back({.account = {.number = known.number, .name = known.name}, .cohort = "YEAR 1", .has_account = true});
  const StudentLinesEnd end = add_students(store->context(), admin, lines);
  ASSERT_FALSE(end.failure) << end.failure->where;
  for (const char* number : {"1100", "1101"}) EXPECT_TRUE(accounts.sign_in_with_pin(number, "314159")) << number;
  const auto cohorts = must(store->cohorts.list());
  ASSERT_EQ(cohorts.size(), 1u);
  EXPECT_EQ(cohorts[0].name, "Year 1");
  EXPECT_EQ(cohorts[0].students, 3);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(StudentLinesTest, of_which_one_has_a_number_that_is_taken_name_it_and_change_nothing) {
  make_student(*store, "1101", "Omar Haddad");
  const std::int64_t people = rows("people"), entries = rows("audit_log");
  const StudentLinesEnd end = add_students(store->context(), admin, students("1", 3));
  ASSERT_TRUE(end.failure);
  EXPECT_EQ(end.failure->code, StorageError::duplicate);
  EXPECT_EQ(end.failure->where, "1101");
  EXPECT_EQ(end.line, 1u);
  EXPECT_EQ(rows("people"), people);
  EXPECT_EQ(rows("cohorts"), 0);
  EXPECT_EQ(rows("audit_log"), entries);
}

TEST_F(StudentLinesTest, of_which_an_account_is_gone_or_a_pin_is_none_change_nothing) {
  std::vector<StudentLine> gone = students("1", 2), bad = gone;
  gone[1].has_account = true;
  bad[1].account.pin = "12345";
  const StudentLinesEnd missing = add_students(store->context(), admin, gone), weak = add_students(store->context(), admin, bad);
  ASSERT_TRUE(missing.failure && weak.failure);
  EXPECT_EQ(missing.failure->code, StorageError::not_found);
  EXPECT_EQ(weak.failure->code, StorageError::weak_password);
  EXPECT_EQ(missing.line, 1u);
  EXPECT_EQ(weak.line, 1u);
  EXPECT_EQ(rows("people"), 1);
}

TEST_F(StudentLinesTest, are_refused_to_who_may_not_manage_accounts) {
  const StudentLinesEnd end = add_students(store->context(), make_student(*store).actor(), students("1", 2));
  ASSERT_TRUE(end.failure);
  EXPECT_EQ(end.failure->code, StorageError::not_allowed);
  EXPECT_EQ(end.line, 2u) << "no single one";
}

TEST_F(StudentLinesTest, that_are_stopped_after_any_of_them_change_nothing) {
  for (std::size_t last : {0u, 1u, 3u}) {
    const StudentLinesEnd end = add_students(store->context(), admin, students("1", 3), [last](std::size_t done, std::size_t) { return done < last; });
    ASSERT_TRUE(end.failure) << last;
    EXPECT_EQ(end.failure->code, StorageError::stopped);
    EXPECT_EQ(rows("people"), 1);
  }
}

TEST_F(StudentLinesTest, of_a_program_that_is_killed_at_any_moment_are_all_there_or_none) {
  const unsigned seed = 20261130;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  constexpr int kLines = 30;
  const fs::path file = folder / "a.db";
  store.reset();
  int killed = 0;
  for (int round = 10; round < 22; ++round) {
    const std::size_t wanted = 1 + random() % (kLines + 1);
    const unsigned delay_us = random() % 6'000;
    const auto add = [&](const std::function<bool()>& step) {
      const auto own = open(file);
      add_students(own->context(), admin, students(std::to_string(round), kLines), [&](std::size_t, std::size_t) { return step(); });
    };
    killed += kill_after(wanted, delay_us, add).by_signal ? 1 : 0;
    store = open(file);
    const std::int64_t there = rows("people WHERE number LIKE '" + std::to_string(round) + "%'");
    EXPECT_TRUE(there == 0 || there == kLines) << there;
    EXPECT_EQ(rows("cohort_students s JOIN people p ON p.id = s.student WHERE p.number LIKE '" + std::to_string(round) + "%'"), there);
    EXPECT_TRUE(must(verify_store(store->context())).intact()) << round;
    store.reset();
  }
  EXPECT_GT(killed, 0);
}

}  // namespace
}  // namespace cusp::test
