/// Accounts of the office that change after a station has read them: number, name, and erasure.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "storage/repositories/possible_doubles.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct ExchangePeopleTest : TwoStations {
  Account lena = make_student(*office, "1001", "Lena Brandt"), omar = make_student(*office, "1002", "Omar Haddad");

  void SetUp() override { must(trust(station->context(), keeper, key_of_station(*office), KeyRole::office)); }
  ReadIn carry_over() {
    const fs::path file = next_file();
    must(give_out(office->context(), chief, ExchangeKind::office, file));
    return must(read_in(station->context(), keeper, file));
  }
  Account without_secret(const std::string& number) { return must(office->accounts.create(chief, {.number = number, .name = "Ada Novak"})); }
  Account at_station(const Account& account) { return must(station->accounts.find(account.id)); }
  void expect_whole() { EXPECT_TRUE(must(verify_store(station->context())).intact()); }
};

TEST_F(ExchangePeopleTest, that_two_stations_made_for_one_number_are_named_as_possible_doubles_with_the_other_station) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  const Account own = must(station->accounts.create(keeper, {.number = "1001", .name = "L. Brandt"}));
  attempt(own);
  EXPECT_TRUE(must(possible_doubles(office->context(), chief)).empty());
  at_office(results());
  const auto doubles = must(possible_doubles(office->context(), chief));
  ASSERT_EQ(doubles.size(), 1u);
  EXPECT_EQ(doubles[0].account.id, lena.id);
  EXPECT_EQ(doubles[0].other.id, own.id);
  EXPECT_EQ(doubles[0].other.name, "L. Brandt");
  EXPECT_EQ(doubles[0].stations, std::vector<Uuid>{station->context().station});
  EXPECT_EQ(code_of(possible_doubles(office->context(), lena.actor())), StorageError::not_allowed);
  must(office->accounts.rename(chief, own.id, "1001 b", own.name));
  EXPECT_TRUE(must(possible_doubles(office->context(), chief)).empty()) << "somebody knows that these are two people";
}

TEST_F(ExchangePeopleTest, that_two_stations_made_for_one_name_under_two_numbers_are_named_as_possible_doubles) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  const Account namesake = must(office->accounts.create(chief, {.number = "1003", .name = omar.name}));
  const CohortId year = must(office->cohorts.create(chief, "Year 2")).id;
  for (const Account& one : {omar, namesake}) must(office->cohorts.add(chief, year, one.id));
  const Account own = must(station->accounts.create(keeper, {.number = "10O1", .name = "lena brandt"}));
  attempt(own);
  at_office(results());
  const auto doubles = must(possible_doubles(office->context(), chief));
  ASSERT_EQ(doubles.size(), 1u) << "two of one name in one cohort are two people";
  EXPECT_EQ(doubles[0].account.id, lena.id);
  EXPECT_EQ(doubles[0].other.id, own.id);
  EXPECT_EQ(doubles[0].stations, std::vector<Uuid>{station->context().station});
  must(office->accounts.rename(chief, lena.id, lena.number, "Lena Brandt (1)"));
  EXPECT_TRUE(must(possible_doubles(office->context(), chief)).empty());
}

TEST_F(ExchangePeopleTest, whom_the_station_made_under_the_same_number_and_name_gives_the_number_to_the_office_and_keeps_the_attempts) {
  const Account own = must(station->accounts.create(keeper, {.number = "1001", .name = "BRANDT, Lena", .pin = "271828"}));
  const SessionId session = attempt(own);
  EXPECT_EQ(carry_over().gave_way, std::vector<std::string>{"1001"});
  EXPECT_EQ(must(station->accounts.sign_in_with_pin("1001", "314159")).id, lena.id);
  EXPECT_TRUE(at_station(own).number.starts_with("1001 ")) << at_station(own).number;
  EXPECT_EQ(must(station->history.list(own.actor())).size(), 1u);
  EXPECT_TRUE(must(verify_session(station->context(), session)).intact());
  const auto doubles = must(possible_doubles(station->context(), keeper));
  ASSERT_EQ(doubles.size(), 1u);
  EXPECT_EQ(doubles[0].account.id, lena.id);
  EXPECT_EQ(doubles[0].other.id, own.id);
  EXPECT_TRUE(carry_over().gave_way.empty());
  expect_whole();
}

TEST_F(ExchangePeopleTest, staff_of_the_same_number_and_name_give_way_to_nobody) {
  must(office->accounts.create(chief, {.number = "berg", .name = "Dr Berg", .role = Role::instructor, .password = "correct horse"}));
  must(station->accounts.create(keeper, {.number = "berg", .name = "Dr Berg", .role = Role::instructor, .password = "battery staple"}));
  const fs::path file = next_file();
  must(give_out(office->context(), chief, ExchangeKind::office, file));
  EXPECT_EQ(code_of(read_in(station->context(), keeper, file)), StorageError::duplicate) << "rights would change hands";
}

TEST_F(ExchangePeopleTest, who_was_erased_is_nobodys_possible_double) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  const Account own = must(station->accounts.create(keeper, {.number = "77", .name = "Lena Brandt"}));
  attempt(own);
  at_office(results());
  must(office->accounts.erase(chief, lena.id));
  must(office->accounts.erase(chief, own.id));
  EXPECT_TRUE(must(possible_doubles(office->context(), chief)).empty());
}

TEST_F(ExchangePeopleTest, two_whose_numbers_were_exchanged_change_them_at_the_station_too) {
  carry_over();
  must(office->accounts.rename(chief, lena.id, "between", lena.name));
  must(office->accounts.rename(chief, omar.id, "1001", omar.name));
  must(office->accounts.rename(chief, lena.id, "1002", lena.name));
  const ReadIn read = carry_over();
  EXPECT_EQ(at_station(lena).number, "1002");
  EXPECT_EQ(at_station(omar).number, "1001");
  EXPECT_EQ(read.counts.accounts, 2u);
  EXPECT_TRUE(read.conflicts.empty());
  expect_whole();
}

TEST_F(ExchangePeopleTest, the_number_of_one_who_was_erased_goes_to_another) {
  carry_over();
  must(office->accounts.erase(chief, omar.id));
  must(office->accounts.rename(chief, lena.id, "1002", lena.name));
  carry_over();
  EXPECT_EQ(at_station(lena).number, "1002");
  EXPECT_EQ(at_station(omar).name, "–");
  expect_whole();
}

TEST_F(ExchangePeopleTest, who_has_no_secret_is_renamed_too) {
  const Account ada = without_secret("1003");
  carry_over();
  must(office->accounts.rename(chief, ada.id, "1004", "Ada Berg"));
  const ReadIn read = carry_over();
  EXPECT_EQ(at_station(ada).number, "1004");
  EXPECT_EQ(at_station(ada).name, "Ada Berg");
  EXPECT_TRUE(read.conflicts.empty());
  EXPECT_EQ(carry_over().counts.accounts, 0u);
  expect_whole();
}

TEST_F(ExchangePeopleTest, who_has_no_secret_keeps_the_name_that_the_station_gave) {
  const Account ada = without_secret("1003");
  carry_over();
  must(station->accounts.rename(keeper, ada.id, "1003", "Ada Berg"));
  EXPECT_TRUE(carry_over().conflicts.empty());
  EXPECT_EQ(at_station(ada).name, "Ada Berg");
  must(office->accounts.disable(chief, ada.id));
  EXPECT_EQ(carry_over().conflicts, std::vector<std::string>{"1003"});
  EXPECT_EQ(at_station(ada).name, "Ada Novak");
}

TEST_F(ExchangePeopleTest, who_has_no_secret_and_was_switched_off_is_erased_too) {
  const Account ada = without_secret("1003");
  must(office->accounts.disable(chief, ada.id));
  carry_over();
  must(office->accounts.erase(chief, ada.id));
  carry_over();
  EXPECT_EQ(at_station(ada).name, "–");
  EXPECT_EQ(at_station(ada).number, "erased " + ada.id.text());
  expect_whole();
}

TEST_F(ExchangePeopleTest, a_cohort_whose_name_another_one_has_here_arrives_under_a_name_of_its_own) {
  const CohortId theirs = must(office->cohorts.create(chief, "Year 2")).id;
  must(office->cohorts.add(chief, theirs, lena.id));
  must(station->cohorts.create(keeper, "year 2"));
  for (int i = 0; i < 2; ++i) carry_over();
  ASSERT_EQ(must(station->cohorts.list()).size(), 2u);
  EXPECT_EQ(must(station->cohorts.students(theirs)), std::vector<UserId>{lena.id});
  expect_whole();
}

TEST_F(ExchangePeopleTest, who_is_erased_leaves_the_cohorts_that_the_station_made_itself) {
  carry_over();
  const CohortId own = must(station->cohorts.create(keeper, "Evening")).id;
  must(station->cohorts.add(keeper, own, lena.id));
  must(office->accounts.erase(chief, lena.id));
  carry_over();
  EXPECT_TRUE(must(station->cohorts.students(own)).empty());
  expect_whole();
}

TEST_F(ExchangePeopleTest, who_is_erased_at_a_station_is_erased_at_an_office_that_knows_the_name_alone) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  carry_over();
  const Account nora = make_student(*station, "3001", "Nora Lind");
  complete_session(*station, at_station(lena), keep(*station));
  const SessionId session = complete_session(*station, nora, keep(*station));
  must(read_in(office->context(), chief, results()));
  must(office->statements.comment(make_instructor(*office).actor(), session, "Nora, well done."));
  ASSERT_EQ(must(office->accounts.find(nora.id)).name, "Nora Lind");
  must(station->accounts.erase(keeper, nora.id));
  must(station->accounts.erase(keeper, lena.id));
  must(read_in(office->context(), chief, results()));
  EXPECT_EQ(must(office->accounts.find(nora.id)).name, "–");
  EXPECT_EQ(must(office->statements.of(chief, session)).front().text, "");
  EXPECT_EQ(must(office->accounts.find(lena.id)).name, "Lena Brandt") << "the office made this account";
  EXPECT_TRUE(must(verify_store(office->context())).intact());
}

TEST_F(ExchangePeopleTest, no_byte_of_the_name_stays_in_the_log_of_a_station_that_is_open) {
  carry_over();
  must(station->accounts.sign_in_with_pin("1001", "314159"));
  must(office->accounts.erase(chief, lena.id));
  carry_over();
  for (const char* part : {"station.db", "station.db-wal"}) {
    std::ifstream in(folder / part, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(bytes.find("Lena Brandt"), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace cusp::test
