// What the form of a person writes while another desk changes the same account.
#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "ui/admin/account_change.h"
#include "ui/text/failure_text.h"

namespace cusp::test {
namespace {

TEST_F(AdminPages, a_pin_for_a_student_who_is_staff_by_now_is_refused_for_that_reason) {
  Accounts& accounts = records.store().accounts;
  const Actor admin = records.administrator().actor();
  const Account lena = records.student("1", "Lena Brandt", "123456");
  ASSERT_TRUE(accounts.set_password(admin, lena.id, {}, "correct horse"));
  ASSERT_TRUE(accounts.set_role(admin, lena.id, Role::instructor));
  const auto done = write_change(accounts, admin, {lena, lena.number, lena.name, Role::student, "654321"});
  ASSERT_FALSE(done);
  EXPECT_EQ(describe_account(done.error(), QStringLiteral("1"), Secret::pin).what.toStdString(), "Only students have a PIN.");
  EXPECT_EQ(accounts.find(lena.id)->role, Role::instructor);
}

TEST_F(AdminPages, a_pin_for_staff_who_becomes_a_student_by_the_same_change_is_set) {
  Accounts& accounts = records.store().accounts;
  const Actor admin = records.administrator().actor();
  const Account berg = *accounts.create(admin, {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  ASSERT_TRUE(write_change(accounts, admin, {berg, berg.number, berg.name, Role::student, "654321"}));
  EXPECT_TRUE(accounts.sign_in_with_pin("berg", "654321"));
}

}  // namespace
}  // namespace cusp::test
