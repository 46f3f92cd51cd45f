// The dialog of one's own password: the records answer on a thread of their own.

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/whole_texts.h"
#include "ui/app/password_dialog.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

struct PasswordDialogTest : ::testing::Test {
  DeskRecords records;
  Account anna = records.administrator();
  QWidget window;
  QPointer<PasswordDialog> dialog = new PasswordDialog(records.store(), anna, &window);

  PasswordDialogTest() {
    window.show();
    dialog->open();
  }
  void type(const char* old, const char* fresh) {
    const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
    fields[0]->setText(QLatin1String(old));
    fields[1]->setText(QLatin1String(fresh));
    fields[2]->setText(QLatin1String(fresh));
    QTest::keyClick(fields[2], Qt::Key_Return);
  }
  bool answered() {
    return QTest::qWaitFor([this] { return !dialog || !dialog->waiting(); }, 60'000);
  }
  bool signs_in(const char* password) { return records.store().accounts.sign_in("anna", password).has_value(); }
};

TEST_F(PasswordDialogTest, a_new_password_takes_the_place_of_the_one_until_now) {
  type("correct horse", "battery staple");
  ASSERT_TRUE(answered());
  EXPECT_FALSE(dialog && dialog->isVisible());
  EXPECT_TRUE(signs_in("battery staple"));
}

TEST_F(PasswordDialogTest, a_wrong_one_until_now_is_named_and_changes_nothing) {
  type("wrong horse", "battery staple");
  ASSERT_TRUE(answered());
  ASSERT_TRUE(dialog && dialog->isVisible());
  EXPECT_TRUE(dialog->findChild<Band*>()->text().contains(QStringLiteral("Nothing was changed.")));
  EXPECT_TRUE(signs_in("correct horse"));
}

TEST_F(PasswordDialogTest, a_refusal_cuts_nothing_off_and_leads_to_the_field_to_type_anew) {
  const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
  const auto whole = [&](const char* refusal) {
    QTest::qWait(0);
    expect_nothing_clipped(*dialog, refusal);
    for (const QLineEdit* field : fields) EXPECT_GE(field->height(), field->sizeHint().height()) << refusal;
  };
  fields[1]->setText(QStringLiteral("battery staple"));
  QTest::keyClick(fields[2], Qt::Key_Return);
  whole("two that differ");
  EXPECT_EQ(dialog->focusWidget(), fields[1]);
  type("wrong horse", "battery staple");
  ASSERT_TRUE(answered());
  whole("a wrong one until now");
  EXPECT_EQ(dialog->focusWidget(), fields[0]);
}

TEST_F(PasswordDialogTest, escape_waits_for_the_answer_and_enter_asks_once) {
  type("correct horse", "battery staple");
  ASSERT_TRUE(dialog->waiting());
  EXPECT_TRUE(dialog->isVisible()) << "the window does not wait for the records";
  QTest::keyClick(dialog, Qt::Key_Escape);
  QTest::keyClick(dialog, Qt::Key_Return);
  EXPECT_TRUE(dialog->isVisible()) << "a change that runs cannot be taken back";
  ASSERT_TRUE(answered());
  EXPECT_FALSE(dialog && dialog->isVisible());
  EXPECT_TRUE(signs_in("battery staple"));
}

}  // namespace
}  // namespace cusp::test
