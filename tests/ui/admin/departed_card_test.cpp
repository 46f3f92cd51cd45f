// Students who left: shown for as many years as the school says, erased after a question.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QPlainTextEdit>
#include <QTest>

#include "storage/exchange/trust.h"
#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "ui/admin/departed_card.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

constexpr int kPatience_ms = 60'000;
/// September 2001; kMorning is of November 2026: from 2015 to 2040 the first alone is 14 years old.
constexpr std::int64_t kLongAgo = 1'000'000'000'000'000;

class Departed : public testing::Test {
 protected:
  Departed() {
    admin = records.administrator();
    records.student("4712", "Omar Haddad");
    const NewAccount ida{.number = "4709", .name = "Ida Falk", .role = Role::instructor, .password = "correct horse"};
    tutor = records.store().accounts.create(admin.actor(), ida).value();
    records.use_until(kMorning - 21 * std::int64_t{86'400'000'000});  // use of the years vouches for the clock
    records.student("4710", "Sana Ito");
    records.now_us = kMorning;
    records.student("4711", "Lena Brandt");
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked = question;
      then(answer);
    };
  }
  DepartedCard& looked(PeoplePage& page) {
    DepartedCard& card = page.departed();
    card.choose_years(14);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !card.found().isEmpty(); }, kPatience_ms));
    return card;
  }
  bool there(const char* number) { return records.store().accounts.find_number(number).has_value(); }

  DeskRecords records{kLongAgo};  // the order of the log counts as the dates do
  Account admin, tutor;
  Ports ports;
  bool answer = true;
  std::optional<Question> asked;
};

TEST_F(Departed, AreNamedAndStayUntilTheQuestionIsAnswered) {
  answer = false;
  PeoplePage page(records.store(), admin.actor(), ports);
  EXPECT_TRUE(page.departed().found().isEmpty()) << "without years nobody is meant";
  DepartedCard& card = looked(page);
  EXPECT_TRUE(card.found().contains(QStringLiteral("Omar Haddad"))) << card.found().toStdString();
  EXPECT_FALSE(card.found().contains(QStringLiteral("Lena Brandt")));
  card.erase();
  ASSERT_TRUE(asked);
  EXPECT_TRUE(asked->erases);
  EXPECT_TRUE(there("4712"));
}

TEST_F(Departed, AreAllNamedBeforeTheyAreErased) {
  DeskRecords many{kLongAgo};
  const Account keeper = many.administrator();
  for (const char* number : {"1", "2", "3", "4", "5"}) many.student(number, std::string("Student ") + number);
  many.use_until(kMorning - 21 * std::int64_t{86'400'000'000});
  many.student("6", "Sana Ito");
  many.now_us = kMorning;
  PeoplePage page(many.store(), keeper.actor(), ports);
  page.show();
  const auto* list = looked(page).findChild<QPlainTextEdit*>();
  ASSERT_NE(list, nullptr);
  EXPECT_TRUE(list->isVisible());
  for (const char* number : {"1", "2", "3", "4", "5"})
    EXPECT_TRUE(list->toPlainText().contains(QStringLiteral("Student %1, %1 (").arg(QLatin1String(number)))) << list->toPlainText().toStdString();
  EXPECT_FALSE(list->toPlainText().contains(QStringLiteral("Sana Ito")));
}

TEST_F(Departed, OfAStationThatKnowsAnOfficeAreToBeErasedThere) {
  DeskRecords office;
  const auto signed_key = own_key(office.store().context(), office.administrator().actor());
  ASSERT_TRUE(signed_key);
  const auto key = public_key_from(*signed_key);
  ASSERT_TRUE(key);
  answer = false;
  PeoplePage alone(records.store(), admin.actor(), ports);
  looked(alone).erase();
  ASSERT_TRUE(asked);
  EXPECT_FALSE(asked->more.contains(QStringLiteral("station"))) << asked->more.toStdString();
  ASSERT_TRUE(trust(records.store().context(), admin.actor(), *key, KeyRole::station));
  PeoplePage at_office(records.store(), admin.actor(), ports);
  looked(at_office).erase();
  EXPECT_TRUE(asked->more.contains(QStringLiteral("read the newest ones first"))) << asked->more.toStdString();
  ASSERT_TRUE(trust(records.store().context(), admin.actor(), *key, KeyRole::office));
  PeoplePage at_station(records.store(), admin.actor(), ports);
  looked(at_station).erase();
  EXPECT_TRUE(asked->more.contains(QStringLiteral("Erase at the office instead"))) << asked->more.toStdString();
}

TEST_F(Departed, AreErasedAndLeaveTheList) {
  PeoplePage page(records.store(), admin.actor(), ports);
  DepartedCard& card = looked(page);
  card.erase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working(); }, kPatience_ms));
  EXPECT_FALSE(there("4712"));
  EXPECT_TRUE(there("4711"));
  EXPECT_TRUE(page.message().contains(QStringLiteral("erased"))) << page.message().toStdString();
}

TEST_F(Departed, AreNotErasedTogetherWithOneWhomTheQuestionDidNotName) {
  ports.ask = [this](QWidget*, const Question&, const std::function<void(bool)>& then) {
    EXPECT_TRUE(records.store().accounts.set_role(admin.actor(), tutor.id, Role::student));  // as another window may do
    then(true);
  };
  PeoplePage page(records.store(), admin.actor(), ports);
  DepartedCard& card = looked(page);
  card.erase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working() && !card.found().isEmpty(); }, kPatience_ms));
  EXPECT_TRUE(there("4709"));
  EXPECT_TRUE(there("4712"));
  EXPECT_TRUE(page.message().contains(QStringLiteral("Nobody was erased."))) << page.message().toStdString();
  EXPECT_TRUE(card.found().contains(QStringLiteral("Ida Falk"))) << card.found().toStdString();
  ports.ask = [](QWidget*, const Question&, const std::function<void(bool)>& then) { then(true); };
  card.erase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working(); }, kPatience_ms));
  EXPECT_FALSE(there("4709"));
  EXPECT_FALSE(there("4712"));
}

TEST_F(Departed, AreErasedUnderAClockInDoubtAfterTheQuestionHasNamedIt) {
  PeoplePage page(records.store(), admin.actor(), ports);
  looked(page).erase();
  ASSERT_TRUE(asked);
  EXPECT_FALSE(asked->more.contains(QStringLiteral("clock"))) << asked->more.toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.departed().working(); }, kPatience_ms));
  records.student("4713", "Ida Falk");
  // The next 14 years after 2026 make the others old.
  records.now_us += 15 * std::int64_t{31'557'600'000'000};
  PeoplePage later(records.store(), admin.actor(), ports);
  looked(later).erase();
  EXPECT_TRUE(asked->more.contains(QStringLiteral("clock says"))) << asked->more.toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !later.departed().working(); }, kPatience_ms));
  EXPECT_FALSE(there("4713"));
}

TEST_F(Departed, LeaveWhatIsTypedAboutANewPerson) {
  PeoplePage page(records.store(), admin.actor(), ports);
  DepartedCard& card = looked(page);
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("Ida Falk"));
  card.erase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working(); }, kPatience_ms));
  EXPECT_FALSE(there("4712"));
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Ida Falk"));
}

TEST_F(Departed, LeaveWhatIsTypedAboutSomebodyWhomASearchHides) {
  PeoplePage page(records.store(), admin.actor(), ports);
  DepartedCard& card = looked(page);
  page.table()->choose_row(page.model()->row_of(records.store().accounts.find_number("4711")->id));
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  field(page, "Find somebody")->setText(QStringLiteral("nobody"));
  card.erase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card.working(); }, kPatience_ms));
  EXPECT_FALSE(there("4712"));
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Lena Weber"));
}

TEST_F(Departed, StandsInEachLook) {
  in_each_look([&](const QString& name) {
    PeoplePage shown(records.store(), admin.actor(), ports);
    shown.resize(px(1040), px(740));
    shown.show();
    looked(shown);
    QApplication::processEvents();
    expect_buttons_fit(shown, name);
    leave_picture(shown, QStringLiteral("people-") + name);
  });
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

}  // namespace
}  // namespace cusp::test
