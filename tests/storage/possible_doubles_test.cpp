/// Two accounts of one name: when they are named as perhaps of one person.
#include "storage/repositories/possible_doubles.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/storage/accounts.h"

namespace cusp::test {
namespace {

struct PossibleDoublesTest : AccountsTest {
  Actor admin = make_administrator(*store).actor();
  Account lena = make_student(*store, "4711", "Lena Brandt");

  Account student(const std::string& number, const std::string& name) { return make_student(*store, number, name); }
  std::vector<PossibleDouble> found() { return must(possible_doubles(store->context(), admin)); }
};

TEST_F(PossibleDoublesTest, are_two_students_of_one_name_whatever_its_case_blanks_and_order) {
  for (const char* name : {"Lena Brandt", "LENA  brandt", "Brandt, Lena"}) {
    const Account other = student("4712", name);
    const auto doubles = found();
    ASSERT_EQ(doubles.size(), 1u) << name;
    EXPECT_EQ((std::set{doubles[0].account.number, doubles[0].other.number}), (std::set<std::string>{"4711", "4712"}));
    EXPECT_TRUE(doubles[0].by_name_alone);
    EXPECT_TRUE(doubles[0].stations.empty());
    must(accounts.erase(admin, other.id));
    EXPECT_TRUE(found().empty()) << "nobody has the name now";
  }
}

TEST_F(PossibleDoublesTest, are_no_three_students_of_a_common_name) {
  student("4712", lena.name);
  student("4713", lena.name);
  EXPECT_TRUE(found().empty());
}

TEST_F(PossibleDoublesTest, are_no_two_students_of_one_cohort) {
  const Account other = student("4712", lena.name);
  const CohortId first = must(store->cohorts.create(admin, "Year 1")).id, second = must(store->cohorts.create(admin, "Year 2")).id;
  must(store->cohorts.add(admin, first, lena.id));
  must(store->cohorts.add(admin, second, other.id));
  EXPECT_EQ(found().size(), 1u) << "who came back has another number";
  must(store->cohorts.add(admin, second, lena.id));
  EXPECT_TRUE(found().empty());
}

TEST_F(PossibleDoublesTest, are_none_where_one_account_is_switched_off_or_has_another_name_or_role) {
  const Account other = student("4712", lena.name);
  must(accounts.disable(admin, other.id));
  EXPECT_TRUE(found().empty());
  must(accounts.enable(admin, other.id));
  EXPECT_EQ(found().size(), 1u);
  must(accounts.rename(admin, other.id, other.number, "Lena Brandt (2)"));
  EXPECT_TRUE(found().empty());
  must(accounts.create(admin, {.number = "berg", .name = lena.name, .role = Role::instructor, .password = "correct horse"}));
  EXPECT_TRUE(found().empty());
}

TEST(AgreeingName, tells_apart_what_is_another_name) {
  EXPECT_EQ(agreeing_name("\u00C9mile Zola"), agreeing_name("Zola, \u00E9mile"));
  EXPECT_NE(agreeing_name("Ali Hassan"), agreeing_name("Hassan Ali")) << "each may be a first name";
  EXPECT_NE(agreeing_name("Anna Lena"), agreeing_name("Annalena"));
}

}  // namespace
}  // namespace cusp::test
