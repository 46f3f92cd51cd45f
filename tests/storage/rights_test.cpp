#include "storage/base/rights.h"
#include "tests/modules.h"
#include "tests/source_dir.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace cusp::test {
namespace {

TEST(Rights, a_student_sees_only_what_is_the_students_own) {
  const Actor student{UserId::make(), Role::student};
  EXPECT_TRUE(require_reading(student, student.id));
  const auto other = require_reading(student, UserId::make());
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, StorageError::not_allowed);
  EXPECT_EQ(other.error().where, "see_all_results");
}

TEST(Rights, who_teaches_edits_scenarios_and_who_administers_manages_accounts) {
  EXPECT_TRUE(may(Role::instructor, Action::edit_scenarios));
  EXPECT_FALSE(may(Role::administrator, Action::edit_scenarios));
  EXPECT_TRUE(may(Role::administrator, Action::manage_accounts));
  EXPECT_FALSE(may(Role::instructor, Action::manage_accounts));
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto action = static_cast<Action>(i);
    const bool everybodys = action == Action::drill || action == Action::see_own_results;
    EXPECT_EQ(may(Role::student, action), everybodys) << key_of(action);
  }
}

TEST(Rights, the_readme_shows_the_same_table) {
  std::ifstream in(source_dir() / "storage/README.md");
  std::ostringstream page;
  page << in.rdbuf();
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto action = static_cast<Action>(i);
    std::string line = "| `" + std::string(key_of(action)) + "` |";
    for (const Role role : {Role::student, Role::instructor, Role::administrator}) {
      line += may(role, action) ? " yes |" : " |";
    }
    EXPECT_NE(page.str().find(line), std::string::npos) << line;
  }
}

TEST(Rights, roles_have_keys_that_read_back) {
  for (const Role role : {Role::student, Role::instructor, Role::administrator})
    EXPECT_EQ(role_from_key(key_of(role)), role);
  EXPECT_FALSE(role_from_key("dean"));
}

}  // namespace
}  // namespace cusp::test
