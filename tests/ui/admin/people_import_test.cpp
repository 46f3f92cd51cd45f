#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/people_import.h"
#include "ui/admin/pin_slips.h"

#include <gtest/gtest.h>

#include <QDeadlineTimer>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

namespace cusp::test {
namespace {

using State = ListedStudent::State;

TEST(PinSlip, shows_number_and_pin_below_the_longest_names) {
  const auto drawn = [](const PinSlip& slip) {
    QImage image(307, 180, QImage::Format_RGB32);  // px, of a tenth of the sheet
    image.fill(Qt::white);
    {
      QPainter painter(&image);
      draw_slip(painter, QRectF(QPointF(), image.size()), slip, 1);
    }
    return image;
  };
  const QString longest = QStringLiteral("Maximiliana ").repeated(17).left(200);  // kMostName and kMostCohortName
  for (const PinSlip& slip : {PinSlip{QStringLiteral("Lena Brandt"), QStringLiteral("4711"), QStringLiteral("123456"), QStringLiteral("Year 3")},
                              PinSlip{longest, QString(63, u'W') + u'1', QStringLiteral("123456"), longest}}) {
    PinSlip other = slip;
    other.pin = QStringLiteral("123457");
    EXPECT_FALSE(drawn(slip) == drawn(other)) << "the PIN of " << slip.name.toStdString();
    other = slip;
    other.number.replace(other.number.size() - 1, 1, u'2');
    EXPECT_FALSE(drawn(slip) == drawn(other)) << "the number of " << slip.name.toStdString();
  }
}

struct Import : testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Ports ports = Ports::of_the_system();
  QString path = folder.filePath(QStringLiteral("list.csv"));
  QString slips = folder.filePath(QStringLiteral("slips.pdf"));
  void SetUp() override {
    records.administrator();
    ports.pick_file = [this](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
      then(wish.saving ? slips : path);
    };
  }
  void write(const QByteArray& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  static void make_accounts(PeopleImport& page) {
    page.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  }
  QByteArray written_slips() const {
    QFile file(slips);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  std::size_t students() { return records.store().accounts.list(records.administrator().actor())->size() - 1; }
};

TEST_F(Import, makes_accounts_with_pins_cohorts_and_slips) {
  records.student("1", "Known One");
  write("number,name,pin,cohort\n1,Known One,,Year 3\n2,New Two,222222,Year 3\n3,New Three,,Year 4\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  ASSERT_EQ(page.model().count(State::fresh), 2) << page.message().toStdString();
  const auto pin = [&page](int line) { return page.model().index(line, StudentListModel::kPin).data().toString().toStdString(); };
  EXPECT_EQ(pin(0), "") << "an account that stands keeps its own";
  make_accounts(page);
  EXPECT_TRUE(page.message().contains(QStringLiteral("2 accounts made."))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(slips)) << page.message().toStdString();
  EXPECT_EQ(pin(0), "");
  EXPECT_EQ(pin(1), "from the file");
  EXPECT_EQ(pin(2), "made here");
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("2", "222222"));
  EXPECT_TRUE(records.store().accounts.find_number("3"));
  const auto cohorts = records.store().cohorts.list();
  ASSERT_EQ(cohorts->size(), 2u);
  EXPECT_EQ((*cohorts)[0].name, "Year 3");
  EXPECT_EQ((*cohorts)[0].students, 2);
  EXPECT_TRUE(written_slips().startsWith("%PDF-"));
  EXPECT_EQ((QFile::permissions(slips) & (QFileDevice::ReadGroup | QFileDevice::ReadOther)).toInt(), 0) << "they sign in as each student";
}

TEST_F(Import, says_what_a_list_is_for_and_promises_no_pin_to_a_line_that_is_left_out) {
  write("number,name\n1,New One\n,Nobody\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  const QLabel* none = nullptr;
  for (const QLabel* label : page.findChildren<QLabel*>())
    if (label->text() == QStringLiteral("No list yet")) none = label;
  ASSERT_NE(none, nullptr);
  EXPECT_TRUE(none->isVisibleTo(&page));
  page.choose_file();
  EXPECT_FALSE(none->isVisibleTo(&page));
  EXPECT_EQ(page.model().index(0, StudentListModel::kPin).data().toString().toStdString(), "made here");
  EXPECT_EQ(page.model().index(1, StudentListModel::kPin).data().toString().toStdString(), "");
}

TEST_F(Import, names_the_line_whose_account_another_desk_has_erased_meanwhile) {
  const Account known = records.student("1", "Known One");
  write("number,name,cohort\n1,Known One,Year 3\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  ASSERT_EQ(page.model().count(State::known), 1) << page.message().toStdString();
  ASSERT_TRUE(records.store().accounts.erase(records.administrator().actor(), known.id));
  page.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("Stopped at line 2."))) << page.message().toStdString();
  page.choose_file();
  EXPECT_EQ(page.model().count(State::fresh), 1) << "the list is read anew";
}

TEST_F(Import, a_second_import_of_the_same_list_makes_nothing_new) {
  write("number,name\n2,New Two\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  page.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  page.choose_file();
  EXPECT_EQ(page.model().count(State::fresh), 0);
  EXPECT_EQ(page.model().count(State::known), 1);
}

TEST_F(Import, a_line_that_repeats_a_number_has_no_account_after_the_other_was_made) {
  write("number,name,cohort\n0072,Lena Brandt,\n0072,Zo\xC3\xAB \xC3\x9Cnal,Year 4\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  for (int press = 0; press < 2; ++press) {
    page.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
    EXPECT_EQ(page.model().students()[0].state, State::known);
    EXPECT_EQ(page.model().students()[1].state, State::bad);
  }
  EXPECT_EQ(page.model().index(1, StudentListModel::kState).data().toString(), QStringLiteral("number stands above too"));
  EXPECT_TRUE(records.store().cohorts.list()->empty()) << "the cohort of the line that was left out";
}

TEST_F(Import, makes_accounts_after_their_slips_and_without_a_turn_of_the_windows_event_loop) {
  write("number,name\n2,New Two\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  page.start();
  EXPECT_TRUE(QFile::exists(slips)) << "a program that is killed from here on has lost no PIN";
  const QDeadlineTimer limit(60'000);
  while (!records.store().accounts.find_number("2") && !limit.hasExpired()) QThread::msleep(1);
  EXPECT_TRUE(records.store().accounts.find_number("2"));
  EXPECT_TRUE(page.working()) << "the window has not heard of it";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
}

TEST_F(Import, reads_no_more_of_a_file_without_an_end_than_a_list_may_have) {
  path = QStringLiteral("/dev/zero");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("zero is too large for a list of students."))) << page.message().toStdString();
  EXPECT_TRUE(page.model().students().empty());
}

TEST_F(Import, stopped_anywhere_has_all_accounts_with_their_slips_or_none) {
  write("number,name\n2,Two\n3,Three\n4,Four\n5,Five\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  page.start();
  page.stop();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  const std::size_t made = students();
  EXPECT_TRUE(made == 0 || made == 4) << made;
  EXPECT_EQ(QFile::exists(slips), made == 4);
  EXPECT_EQ(page.message().contains(QStringLiteral("Stopped.")), made == 0) << page.message().toStdString();
  EXPECT_EQ(page.model().count(State::fresh), static_cast<int>(4 - made));
  make_accounts(page);
  EXPECT_EQ(students(), 4u);
  EXPECT_TRUE(QFile::exists(slips));
}

TEST_F(Import, writes_no_slips_over_those_of_another_list) {
  write("number,name\n2,Two\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  make_accounts(page);
  const QByteArray before = written_slips();
  write("number,name\n3,Three\n");
  page.choose_file();
  make_accounts(page);
  EXPECT_TRUE(page.message().contains(QStringLiteral("A file of this name is there already."))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(slips)) << page.message().toStdString();
  EXPECT_TRUE(written_slips() == before);
  EXPECT_EQ(students(), 1u);
  slips = folder.filePath(QStringLiteral("other slips.pdf"));
  make_accounts(page);
  EXPECT_EQ(students(), 2u);
}

TEST_F(Import, makes_no_account_whose_slip_cannot_be_written) {
  write("number,name\n2,Two\n");
  slips = folder.filePath(QStringLiteral("no such folder/slips.pdf"));
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  make_accounts(page);
  EXPECT_TRUE(page.message().contains(QStringLiteral("cannot be written"))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(QStringLiteral("No account was made."))) << page.message().toStdString();
  EXPECT_EQ(students(), 0u);
  EXPECT_EQ(page.model().count(State::fresh), 1) << "another place may be chosen";
}

TEST_F(Import, students_who_have_accounts_join_the_cohorts_of_the_list_without_slips) {
  for (const char* number : {"1", "2"}) records.student(number, "Known");
  write("number,name,cohort\n1,Known,Year 4\n2,Known,Year 4\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  QPushButton* make = nullptr;
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Make the accounts")) make = button;
  ASSERT_NE(make, nullptr);
  EXPECT_TRUE(make->isEnabled());
  make->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  const auto cohorts = records.store().cohorts.list();
  ASSERT_EQ(cohorts->size(), 1u);
  EXPECT_EQ(cohorts->front().students, 2);
  EXPECT_FALSE(make->isEnabled()) << "nothing is left to do";
  EXPECT_FALSE(QFile::exists(slips));
  page.choose_file();
  EXPECT_FALSE(make->isEnabled());
}

TEST_F(Import, a_line_that_fails_is_named_and_no_account_is_made) {
  write("number,name\n2,New Two\n3,New Three\n4,New Four\n");
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  records.student("3", "Somebody Else");  // meanwhile, at another station
  page.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, 60'000));
  EXPECT_TRUE(page.message().contains(QStringLiteral("Stopped at line 3."))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(QStringLiteral("No account was made."))) << page.message().toStdString();
  EXPECT_FALSE(QFile::exists(slips)) << "its PINs are of no account";
  for (const char* number : {"2", "4"}) EXPECT_FALSE(records.store().accounts.find_number(number)) << number;
}

TEST_F(Import, a_file_that_is_no_list_is_named_and_changes_nothing) {
  write(QByteArray("\x89PNG\r\n\x1a\n\0\0", 10));
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  EXPECT_TRUE(page.message().contains(QStringLiteral("list.csv is no list of students"))) << page.message().toStdString();
  path = folder.filePath(QStringLiteral("not-there.csv"));
  page.choose_file();
  EXPECT_TRUE(page.message().contains(QStringLiteral("cannot be read")));
  EXPECT_EQ(page.model().rowCount(), 0);
}

}  // namespace
}  // namespace cusp::test
