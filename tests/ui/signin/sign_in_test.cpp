// Sign-in, as its users meet it.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/session/background_task.h"
#include "ui/signin/pin_field.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

using test::DeskRecords;

QPushButton* button(QWidget& page, const char* name) {
  for (QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == QLatin1String(name)) return b;
  }
  return nullptr;
}
QLineEdit* field(QWidget& page, const char* name) {
  for (QLineEdit* f : page.findChildren<QLineEdit*>()) {
    if (f->accessibleName() == QLatin1String(name)) return f;
  }
  return nullptr;
}

struct SignInTest : ::testing::Test {
  DeskRecords records;
  std::optional<Account> who;
  std::unique_ptr<SignIn> page;
  void open() {
    page = std::make_unique<SignIn>(records.store());
    QObject::connect(page.get(), &SignIn::signed_in, [this](const Account& a) { who = a; });
    page->resize(1280, 800);
    page->show();
  }
  /// The records have answered. They are asked on a thread of their own.
  void answered() { ASSERT_TRUE(QTest::qWaitFor([this] { return !page->waiting(); }, 60'000)); }
  void answer_key(QWidget* in, Qt::Key key) {
    QTest::keyClick(in, key);
    answered();
  }
  void answer_press(const char* name) {
    button(*page, name)->click();
    answered();
  }
};

TEST_F(SignInTest, the_language_has_the_chevron_of_every_menu) {
  open();
  QPushButton* language = nullptr;
  for (QPushButton* button : page->findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Language")) language = button;
  ASSERT_NE(language, nullptr);
  QString shown;
  for (const QLabel* label : language->findChildren<QLabel*>()) shown += label->text();
  EXPECT_EQ(shown.toStdString(), "English");
  EXPECT_EQ(language->text().toStdString(), "");  // sign, text and chevron are labels
}

TEST_F(SignInTest, the_reason_why_the_page_is_here_stays_over_a_change_of_the_tab) {
  records.administrator();
  open();
  const QString why = QStringLiteral("You were signed out.");
  page->show_note({why, {}});
  auto* tabs = page->findChild<QTabBar*>();
  tabs->setCurrentIndex(1);
  EXPECT_TRUE(page->message().contains(why)) << page->message().toStdString();
  button(*page, "Sign in")->click();
  EXPECT_TRUE(page->message().contains(QStringLiteral("The user name is missing."))) << page->message().toStdString();
  tabs->setCurrentIndex(0);
  EXPECT_TRUE(page->message().contains(why)) << page->message().toStdString();
}

TEST_F(SignInTest, a_student_signs_in_with_number_and_pin) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  QTest::keyClicks(field(*page, "Student number"), QStringLiteral("20267314"));
  auto* pin = page->findChild<PinField*>();
  QTest::keyClicks(pin, QStringLiteral("271828"));
  EXPECT_EQ(pin->text().toStdString(), "271828");
  QTest::mouseClick(button(*page, "Sign in"), Qt::LeftButton);
  answered();
  ASSERT_TRUE(who.has_value());
  EXPECT_EQ(who->name, "Lena Brandt");
}

TEST_F(SignInTest, a_wrong_pin_gets_one_sentence_and_nobody_is_signed_in) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  QTest::keyClicks(field(*page, "Student number"), QStringLiteral("20267314"));
  auto* pin = page->findChild<PinField*>();
  QTest::keyClicks(pin, QStringLiteral("111111"));
  answer_key(pin, Qt::Key_Return);
  EXPECT_FALSE(who.has_value());
  EXPECT_EQ(page->message().toStdString(), "Number and PIN do not match. Check both and try again.");
  EXPECT_TRUE(pin->text().isEmpty());
}

TEST_F(SignInTest, staff_sign_in_with_user_name_and_password) {
  records.administrator();
  open();
  page->set_typed_number(QStringLiteral("anna"), SignIn::Who::staff);
  QTest::keyClicks(field(*page, "Password"), QStringLiteral("wrong horse"));
  answer_key(field(*page, "Password"), Qt::Key_Return);
  EXPECT_EQ(page->message().toStdString(), "Number and password do not match. Check both and try again.");
  field(*page, "Password")->clear();
  QTest::keyClicks(field(*page, "Password"), QStringLiteral("correct horse"));
  answer_key(field(*page, "Password"), Qt::Key_Return);
  ASSERT_TRUE(who.has_value());
  EXPECT_EQ(who->role, Role::administrator);
}

TEST_F(SignInTest, five_wrong_tries_close_it_until_a_time_that_is_shown) {
  records.administrator();
  open();
  page->set_typed_number(QStringLiteral("anna"), SignIn::Who::staff);
  for (int i = 0; i < 6; ++i) {
    field(*page, "Password")->setText(QStringLiteral("wrong horse"));
    answer_key(field(*page, "Password"), Qt::Key_Return);
  }
  QString shown = page->message();
  for (const char16_t c : {u'\x2066', u'\x2069'}) shown.remove(QChar(c));
  EXPECT_TRUE(shown.startsWith(QStringLiteral("Too many wrong tries for anna. Signing in is open again at "))) << shown.toStdString();
  EXPECT_FALSE(who.has_value());
}

TEST_F(SignInTest, a_missing_pin_is_not_called_a_wrong_one) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  QTest::keyClicks(field(*page, "Student number"), QStringLiteral("20267314"));
  answer_press("Sign in");
  EXPECT_FALSE(who.has_value());
  EXPECT_EQ(page->message().toStdString(), "The PIN is missing. It has six digits.");
}

TEST_F(SignInTest, a_student_who_is_locked_out_reads_the_number_and_the_time) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  QTest::keyClicks(field(*page, "Student number"), QStringLiteral("20267314"));
  auto* pin = page->findChild<PinField*>();
  for (int i = 0; i < 6; ++i) {
    QTest::keyClicks(pin, QStringLiteral("111111"));
    answer_key(pin, Qt::Key_Return);
  }
  QString shown = page->message();
  for (const char16_t c : {u'\x2066', u'\x2069'}) shown.remove(QChar(c));
  EXPECT_TRUE(shown.startsWith(QStringLiteral("Too many wrong tries for 20267314. Signing in is open again at "))) << shown.toStdString();
  EXPECT_FALSE(shown.contains(QStringLiteral("cusp.db")));
  EXPECT_EQ(page->focusWidget(), pin);
  QTest::keyClicks(pin, QStringLiteral("271828"));
  EXPECT_EQ(pin->text().toStdString(), "271828") << "the right PIN is typed into empty boxes";
}

TEST_F(SignInTest, an_empty_number_or_half_a_pin_is_reported_before_the_records_are_asked) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  answer_press("Sign in");
  EXPECT_EQ(page->message().toStdString(), "The student number is missing.");
  field(*page, "Student number")->setText(QStringLiteral("20267314"));
  page->findChild<PinField*>()->setText(QStringLiteral("2"));
  answer_press("Sign in");
  EXPECT_EQ(page->message().toStdString(), "The PIN has six digits.");
  EXPECT_TRUE(page->findChild<PinField*>()->text().isEmpty());
  EXPECT_EQ(page->focusWidget(), page->findChild<PinField*>());
}

TEST_F(SignInTest, the_first_start_makes_the_administrator) {
  open();
  ASSERT_NE(field(*page, "Your name"), nullptr);
  field(*page, "Your name")->setText(QStringLiteral("Anna Weber"));
  field(*page, "User name")->setText(QStringLiteral("anna"));
  field(*page, "Password, at least 8 characters")->setText(QStringLiteral("correct horse"));
  field(*page, "Password again")->setText(QStringLiteral("correct hearse"));
  answer_press("Make the administrator");
  EXPECT_EQ(page->message().toStdString(), "The two passwords differ. Type them again.");
  field(*page, "Password, at least 8 characters")->setText(QStringLiteral("horse"));
  field(*page, "Password again")->setText(QStringLiteral("horse"));
  answer_press("Make the administrator");
  EXPECT_TRUE(page->message().startsWith(QStringLiteral("This password is too short.")));
  field(*page, "Password, at least 8 characters")->setText(QStringLiteral("correct horse"));
  field(*page, "Password again")->setText(QStringLiteral("correct horse"));
  QSignalSpy made(page.get(), &SignIn::administrator_made);
  answer_press("Make the administrator");
  EXPECT_EQ(made.count(), 1);
  ASSERT_TRUE(who.has_value());
  EXPECT_EQ(who->role, Role::administrator);
  EXPECT_TRUE(*records.store().accounts.has_administrator());
}

TEST_F(SignInTest, the_first_administrator_has_no_mark_that_nobody_sees_in_name_and_user_name) {
  open();
  field(*page, "Your name")->setText(QStringLiteral(" \u202EAnna\u202C\u0007\tWeber\u200B "));
  field(*page, "User name")->setText(QStringLiteral("\u200Eanna\u200B"));
  field(*page, "Password, at least 8 characters")->setText(QStringLiteral("correct horse"));
  field(*page, "Password again")->setText(QStringLiteral("correct horse"));
  answer_press("Make the administrator");
  ASSERT_TRUE(who.has_value());
  EXPECT_EQ(who->name, "Anna Weber");
  EXPECT_TRUE(records.store().accounts.sign_in("anna", "correct horse").has_value());
}

TEST_F(SignInTest, the_first_start_asks_for_a_name_where_it_has_marks_alone) {
  open();
  field(*page, "Your name")->setText(QStringLiteral("\u200B \u200E"));
  field(*page, "User name")->setText(QStringLiteral("anna"));
  button(*page, "Make the administrator")->click();
  EXPECT_EQ(page->message().toStdString(), "Name and user name are needed.");
}

TEST_F(SignInTest, a_refusal_of_the_first_start_stands_off_the_button_below_it) {
  open();
  button(*page, "Make the administrator")->click();
  QTest::qWait(0);
  int shown = 0;
  for (Band* band : page->findChildren<Band*>()) {
    if (!band->isVisible()) continue;
    ++shown;
    const int below = button(*page, "Make the administrator")->mapTo(page.get(), QPoint()).y();
    EXPECT_GE(below - band->mapTo(page.get(), QPoint(0, band->height())).y(), px(8));
  }
  EXPECT_EQ(shown, 1);
}

TEST_F(SignInTest, the_records_are_asked_once_however_often_the_button_is_pressed) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  field(*page, "Student number")->setText(QStringLiteral("20267314"));
  page->findChild<PinField*>()->setText(QStringLiteral("271828"));
  QSignalSpy entered(page.get(), &SignIn::signed_in);
  QPushButton* enter = button(*page, "Sign in");
  enter->setFocus();
  enter->click();
  EXPECT_TRUE(page->waiting());
  EXPECT_FALSE(who.has_value()) << "the window does not wait for the records";
  QTest::keyClick(enter, Qt::Key_Return);
  EXPECT_EQ(page->focusWidget(), enter) << "a second Enter must not press \"Try it\"";
  answered();
  EXPECT_EQ(entered.count(), 1);
}

TEST_F(SignInTest, who_tried_it_meanwhile_is_not_signed_in) {
  records.student("20267314", "Lena Brandt");
  open();
  field(*page, "Student number")->setText(QStringLiteral("20267314"));
  button(*page, "Sign in")->click();
  page->hide();  // as under another page
  answered();
  EXPECT_FALSE(who.has_value());
}

TEST_F(SignInTest, a_page_that_goes_meanwhile_gets_no_answer) {
  records.student("20267314", "Lena Brandt", "271828");
  open();
  field(*page, "Student number")->setText(QStringLiteral("20267314"));
  page->findChild<PinField*>()->setText(QStringLiteral("271828"));
  button(*page, "Sign in")->click();
  page.reset();
  wait_for_dropped_tasks();
  QCoreApplication::processEvents();
  EXPECT_FALSE(who.has_value());
}

TEST_F(SignInTest, try_it_takes_one_click_and_no_account) {
  open();
  QSignalSpy tried(page.get(), &SignIn::try_it);
  button(*page, "Try it")->click();
  EXPECT_EQ(tried.count(), 1);
}

TEST_F(SignInTest, the_tabs_change_between_student_and_staff_and_a_screen_reader_knows_them) {
  records.administrator();
  open();
  auto* tabs = page->findChild<QTabBar*>();
  ASSERT_NE(tabs, nullptr);
  EXPECT_EQ(page->who(), SignIn::Who::student);
  EXPECT_TRUE(field(*page, "Student number")->isVisible());
  tabs->setFocus();
  QTest::keyClick(tabs, Qt::Key_Right);
  EXPECT_EQ(page->who(), SignIn::Who::staff);
  EXPECT_TRUE(field(*page, "Password")->isVisible());
  EXPECT_FALSE(field(*page, "Student number")->isVisible());
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(tabs);
  ASSERT_NE(face, nullptr);
  EXPECT_EQ(face->role(), QAccessible::PageTabList);
  EXPECT_EQ(face->child(1)->text(QAccessible::Name).toStdString(), "Staff");
}

TEST(PinFieldTest, backspace_goes_back_and_a_pasted_pin_loses_its_spaces) {
  PinField pin;
  QSignalSpy completed(&pin, &PinField::completed);
  pin.show();
  QTest::keyClicks(&pin, QStringLiteral("12"));
  QTest::keyClick(&pin, Qt::Key_Backspace);
  EXPECT_EQ(pin.text().toStdString(), "1");
  EXPECT_EQ(completed.count(), 0);
  pin.clear();
  QGuiApplication::clipboard()->setText(QStringLiteral(" 271 828 "));
  QTest::keySequence(&pin, QKeySequence::Paste);
  EXPECT_EQ(pin.text().toStdString(), "271828");
  EXPECT_EQ(completed.count(), 1);
  QTest::keyClicks(&pin, QStringLiteral("x3"));
  EXPECT_EQ(pin.text().toStdString(), "271828");
}

TEST(PinFieldTest, a_screen_reader_hears_how_much_is_typed_and_not_what) {
  PinField pin;
  pin.setText(QStringLiteral("2718"));
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&pin);
  ASSERT_NE(face, nullptr);
  EXPECT_TRUE(face->state().passwordEdit);
  const QString shown = face->text(QAccessible::Value);
  EXPECT_EQ(shown.size(), 4);
  EXPECT_FALSE(shown.contains(u'2'));
}

TEST(PinFieldTest, the_box_of_the_next_digit_is_marked_and_a_refused_pin_is_shown_as_an_error) {
  PinField pin;
  pin.resize(pin.sizeHint());
  pin.setText(QStringLiteral("27"));
  const auto seen = [&](int box) { return pin.grab().toImage().pixelColor(box * px(56) + px(20), px(22)); };
  EXPECT_EQ(seen(1), tokens().text);     // a sign for the digit
  EXPECT_EQ(seen(2), tokens().surface);  // none yet
  const auto frame = [&] { return pin.grab().toImage().pixelColor(px(20), 0); };
  const QColor before = frame();
  pin.show_refused();
  EXPECT_NE(frame(), before);
  QTest::keyClicks(&pin, QStringLiteral("1"));
  EXPECT_EQ(frame(), before);
}

}  // namespace
}  // namespace cusp::test
