// Who is signed in, and is switched off or given another role at another desk.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/settings/settings.h"
#include "ui/signin/sign_in.h"

namespace cusp::test {
namespace {

constexpr int kSignedOutMs = 60'000;  // waits for progress, never decides

struct ChangedAccount : ::testing::Test {
  ChangedAccount() {
    desktop.start();
    desktop.show();
    desktop.sign_in(berg);
  }
  /// What the sign-in page says once nobody is signed in any more.
  std::string note_after_look() {
    EXPECT_TRUE(QTest::qWaitFor([&] { return !desktop.account(); }, kSignedOutMs));
    const auto* page = qobject_cast<SignIn*>(desktop.page());
    return page == nullptr ? std::string() : page->message().toStdString();
  }

  DeskRecords records;
  Account administrator = records.administrator();
  Account berg = *records.store().accounts.create(administrator.actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Desktop desktop{settings, Ports::of_the_system(), records.file()};
};

TEST_F(ChangedAccount, is_signed_out_when_its_role_was_changed) {
  ASSERT_TRUE(records.store().accounts.set_role(administrator.actor(), berg.id, Role::student));
  EXPECT_NE(note_after_look().find("your role was changed"), std::string::npos) << "an instructor’s pages show everybody’s results";
  desktop.sign_in(*records.store().accounts.find(berg.id));
  EXPECT_EQ(desktop.shell()->page_key().toStdString(), "start");
}

TEST_F(ChangedAccount, is_signed_out_when_it_was_switched_off) {
  ASSERT_TRUE(records.store().accounts.disable(administrator.actor(), berg.id));
  EXPECT_NE(note_after_look().find("your account is switched off"), std::string::npos);
}

TEST_F(ChangedAccount, is_signed_out_when_its_owner_gave_up_the_role) {
  const Account other = *records.store().accounts.create(administrator.actor(), {"otto", "Otto Kern", Role::administrator, "correct horse", ""});
  desktop.sign_in(other);
  ASSERT_TRUE(records.store().accounts.set_role(other.actor(), other.id, Role::student));
  EXPECT_NE(note_after_look().find("your role was changed"), std::string::npos);
}

}  // namespace
}  // namespace cusp::test
