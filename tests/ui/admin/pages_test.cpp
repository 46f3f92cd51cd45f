// The administrator's pages over real records.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "ui/admin/criteria_card.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/admin/performance.h"
#include "ui/student/course.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

using test::DeskRecords;

void press(QWidget& page, const char* name) {
  for (QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == QLatin1String(name)) return b->click();
  }
  FAIL() << "no button " << name;
}
QLineEdit* field(QWidget& page, const char* name) {
  for (QLineEdit* f : page.findChildren<QLineEdit*>()) {
    if (f->accessibleName() == QLatin1String(name)) return f;
  }
  return nullptr;
}

std::string plain_text(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}
QStringList texts_of(const QComboBox& box) {
  QStringList out;
  for (int i = 0; i < box.count(); ++i) out += box.itemText(i);
  return out;
}

struct AdminPages : ::testing::Test {
  DeskRecords records;
  Ports ports = Ports::of_the_system();
  std::vector<QString> asked;
  bool answer = true;
  QString file;
  void SetUp() override {
    records.administrator();
    ports.ask = [this](QWidget*, const Question& q, std::function<void(bool)> then) {
      asked.push_back(q.what);
      then(answer);
    };
    ports.pick_file = [this](QWidget*, const FileWish&, std::function<void(const QString&)> then) { then(file); };
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC); };
  }
};

/// Presses, and waits for the records: they are asked on a thread of their own.
void save(PeoplePage& page, const char* name) {
  press(page, name);
  ASSERT_TRUE(QTest::qWaitFor([&page] { return !page.waiting(); }, 60'000));
}

TEST_F(AdminPages, a_student_is_added_and_signs_in_with_the_pin) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("Lena Brandt"));
  field(page, "Number or user name")->setText(QStringLiteral("20267314"));
  field(page, "PIN, six digits")->setText(QStringLiteral("271828"));
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Lena Brandt is added.");
  press(page, "Add");  // a double click presses it twice
  EXPECT_EQ(page.message().toStdString(), "Lena Brandt is added.");
  EXPECT_EQ(page.model()->rowCount(), 2);
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("20267314", "271828").has_value());
}

TEST_F(AdminPages, the_same_number_twice_and_a_short_pin_are_refused_with_a_message) {
  records.student("20267314", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Name and number are needed.");
  field(page, "Name")->setText(QStringLiteral("Another"));
  field(page, "Number or user name")->setText(QStringLiteral("20267314"));
  save(page, "Add");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("The number \u206620267314\u2069 is taken."))) << page.message().toStdString();
  field(page, "Number or user name")->setText(QStringLiteral("20267315"));
  field(page, "PIN, six digits")->setText(QStringLiteral("12"));
  save(page, "Add");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("A PIN has exactly six digits."))) << page.message().toStdString();
  EXPECT_EQ(page.model()->rowCount(), 2);
}

TEST_F(AdminPages, switching_an_account_off_asks_first_and_keeps_the_results) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 100);
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  answer = false;
  press(page, "Switch account off");
  EXPECT_FALSE(records.store().accounts.find(lena.id)->disabled);
  answer = true;
  press(page, "Switch account off");
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[0].toStdString(), "Switch off the account of Lena Brandt?");
  EXPECT_TRUE(records.store().accounts.find(lena.id)->disabled);
  EXPECT_EQ(records.store().history.list(records.administrator().actor())->size(), 1u);
  press(page, "Switch account on");  // gives back: nothing to ask
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_FALSE(records.store().accounts.find(lena.id)->disabled);
}

TEST_F(AdminPages, people_are_found_by_role_and_by_cohort) {
  const Account lena = records.student("1", "Lena Brandt");
  records.student("2", "Noah Adler");
  const auto cohort = records.store().cohorts.create(records.administrator().actor(), "Year 2");
  ASSERT_TRUE(cohort && records.store().cohorts.add(records.administrator().actor(), cohort->id, lena.id));
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  EXPECT_EQ(page.model()->rowCount(), 3);
  for (QComboBox* box : page.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Shown roles")) box->setCurrentIndex(1);
  EXPECT_EQ(page.model()->rowCount(), 2) << "the students";
  page.model()->narrow(QStringLiteral("year 2"));
  ASSERT_EQ(page.model()->rowCount(), 1);
  EXPECT_EQ(page.model()->account(0).id, lena.id);
  EXPECT_EQ(page.model()->index(0, PeopleModel::kCohort).data().toString(), QStringLiteral("Year 2"));
}

TEST_F(AdminPages, each_row_of_the_learning_table_says_what_it_is) {
  for (const char* number : {"1", "2", "3"}) records.attempt(records.student(number, std::string("Student ") + number), "channel-1", 60, 400);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  int named = 0;
  for (const Chart* chart : page.findChildren<Chart*>()) {
    if (chart->data().title != QStringLiteral("Learning")) continue;
    ASSERT_EQ(chart->data().series.size(), 3);
    for (const ChartSeries& s : chart->data().series)
      for (const ChartPoint& p : s.points) named += p.label.contains(QStringLiteral("half")) || p.label.contains(QStringLiteral("Median"));
  }
  EXPECT_EQ(named, 3);
}

TEST_F(AdminPages, looking_for_somebody_keeps_what_is_typed_about_a_new_person) {
  records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("Omar Said"));
  field(page, "Find somebody")->setText(QStringLiteral("Lena"));
  EXPECT_EQ(page.model()->rowCount(), 1);
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Omar Said"));
  field(page, "Number or user name")->setText(QStringLiteral("2"));
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Omar Said is added.");
  EXPECT_TRUE(records.store().accounts.find_number("2"));
}

TEST_F(AdminPages, nothing_is_saved_of_a_person_that_nobody_changed) {
  const Account lena = records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  QPushButton* save_button = nullptr;
  for (QPushButton* one : page.findChildren<QPushButton*>())
    if (one->accessibleName() == QStringLiteral("Save changes")) save_button = one;
  ASSERT_NE(save_button, nullptr);
  EXPECT_FALSE(save_button->isEnabled());
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  EXPECT_TRUE(save_button->isEnabled());
  save(page, "Save changes");
  EXPECT_EQ(records.store().accounts.find(lena.id)->name, "Lena Weber");
  EXPECT_FALSE(save_button->isEnabled()) << "it is saved";
}

TEST_F(AdminPages, the_last_administrator_stays_one) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(0);
  for (QComboBox* box : page.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Role")) box->setCurrentIndex(0);
  save(page, "Save changes");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("This is the last administrator."))) << page.message().toStdString();
  EXPECT_EQ(records.store().accounts.find(records.administrator().id)->role, Role::administrator);
}

TEST_F(AdminPages, performance_shows_everybody_and_filters) {
  const Account lena = records.student("1", "Lena Brandt"), noah = records.student("2", "Noah Adler");
  records.attempt(lena, "channel-1", 78, 100);
  records.attempt(lena, "paper-block", 40, 100);
  records.attempt(noah, "channel-1", 90, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.resize(1080, 752);
  page.show();
  EXPECT_EQ(page.attempts().rowCount(), 3);
  page.result()->setCurrentIndex(1);
  EXPECT_EQ(page.attempts().rowCount(), 2);  // passed
  page.result()->setCurrentIndex(2);
  EXPECT_EQ(page.attempts().rowCount(), 1);
  page.result()->setCurrentIndex(0);
  page.search()->setText(QStringLiteral("adler"));
  ASSERT_EQ(page.attempts().rowCount(), 1);
  EXPECT_EQ(page.attempts().row(0).student_name, "Noah Adler");
  page.search()->setText(QStringLiteral("nobody"));
  EXPECT_EQ(page.attempts().rowCount(), 0);
  page.search()->clear();
  page.exercise()->setCurrentIndex(1);
  EXPECT_LT(page.attempts().rowCount(), 3);
  page.exercise()->setCurrentIndex(0);
  page.period()->setCurrentIndex(1);  // last day: all of this morning
  EXPECT_EQ(page.attempts().rowCount(), 3);
}

TEST_F(AdminPages, a_row_opens_the_report_of_that_attempt_also_when_sorted) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 100);
  const SessionId worst = records.attempt(lena, "channel-1", 20, 100);
  records.attempt(lena, "channel-1", 90, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->sortByColumn(AttemptsModel::kScore, Qt::AscendingOrder);
  page.table()->choose_row(0);
  std::optional<SessionId> wanted;
  QObject::connect(&page, &Performance::report_wanted, [&](const SessionId& id) { wanted = id; });
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted, worst);
}

TEST_F(AdminPages, performance_fetches_as_one_scrolls_and_all_for_another_order) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId worst = records.attempt(lena, "channel-1", 20, 1);
  for (int i = 0; i < kAttemptsAtOnce + 20; ++i) records.attempt(lena, "channel-1", 50 + i % 40, 1);
  ports.now = [this] { return QDateTime::fromMSecsSinceEpoch(records.now_us / 1000, Qt::UTC); };
  Performance page(records.store(), records.administrator().actor(), ports);
  page.resize(1080, 752);
  page.show();
  EXPECT_EQ(page.attempts().rowCount(), kAttemptsAtOnce);
  page.table()->scrollToBottom();
  EXPECT_TRUE(QTest::qWaitFor([&] { return page.attempts().rowCount() == kAttemptsAtOnce + 21; }));
  page.read();
  EXPECT_EQ(page.attempts().rowCount(), kAttemptsAtOnce);
  page.table()->sortByColumn(AttemptsModel::kScore, Qt::AscendingOrder);
  EXPECT_EQ(page.attempts().rowCount(), kAttemptsAtOnce + 21);
  page.table()->choose_row(0);
  std::optional<SessionId> wanted;
  QObject::connect(&page, &Performance::report_wanted, [&](const SessionId& id) { wanted = id; });
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted, worst);
}

TEST_F(AdminPages, a_message_about_other_filters_goes_when_they_change) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 78, 100);
  const QTemporaryDir folder;
  file = folder.filePath(QStringLiteral("out.csv"));
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.export_csv();
  const auto* band = page.findChild<Band*>();
  ASSERT_TRUE(band->isVisible());
  page.result()->setCurrentIndex(2);
  EXPECT_FALSE(band->isVisible()) << band->text().toStdString();
}

TEST_F(AdminPages, performance_fits_half_of_full_hd_in_german) {
  install_language(*qApp, QStringLiteral("de"));
  records.attempt(records.student("1", "Lena Brandt"), "class-2-46-mo", 78, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.resize(kPageAtHalfOfFullHd);
  page.show();
  QTest::qWait(0);
  const auto* area = page.findChild<QScrollArea*>();
  EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(AdminPages, csv_holds_what_the_filters_leave) {
  const Account lena = records.student("1", "Lena Brandt"), noah = records.student("2", "Noah Adler");
  records.attempt(lena, "channel-1", 78, 100);
  records.attempt(noah, "channel-1", 90, 100);
  const QTemporaryDir folder;
  file = folder.filePath(QStringLiteral("out.csv"));
  Performance page(records.store(), records.administrator().actor(), ports);
  page.search()->setText(QStringLiteral("Lena"));
  page.export_csv();
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray bytes = written.readAll();
  EXPECT_EQ(bytes.count("\r\n"), 2);  // head and one attempt
  EXPECT_TRUE(bytes.contains(",finished_utc,cohort,opens_utc,due_utc\r\n"));
  EXPECT_TRUE(bytes.contains("Lena Brandt"));
  EXPECT_FALSE(bytes.contains("Noah Adler"));
}

TEST_F(AdminPages, performance_narrows_to_a_cohort_a_version_and_students_or_staff) {
  const Account lena = records.student("1", "Lena Brandt"), omar = records.student("2", "Omar Haddad");
  records.attempt(lena, "channel-1", 60, 100);
  records.attempt(omar, "channel-1", 70, 100);
  records.attempt(records.administrator(), "paper-block", 80, 100);
  const CohortId cohort = records.store().cohorts.create(records.administrator().actor(), "Year 3")->id;
  ASSERT_TRUE(records.store().cohorts.add(records.administrator().actor(), cohort, lena.id));
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  const auto rows = [&] { return page.attempts().rowCount(); };
  EXPECT_EQ(rows(), 3);
  page.who()->setCurrentIndex(1);
  EXPECT_EQ(rows(), 2);
  page.who()->setCurrentIndex(2);
  EXPECT_EQ(rows(), 1);
  page.who()->setCurrentIndex(0);
  EXPECT_EQ(texts_of(*page.cohort()), (QStringList{QStringLiteral("All cohorts"), QStringLiteral("Year 3")}));
  page.cohort()->setCurrentIndex(1);
  EXPECT_EQ(rows(), 1);
  page.cohort()->setCurrentIndex(0);
  EXPECT_FALSE(page.version()->isVisible()) << "versions are of an exercise";
  page.exercise()->setCurrentIndex(page.exercise()->findText(QString::fromStdString(load_builtin("channel-1")->title.at("en"))));
  EXPECT_EQ(rows(), 2);
  EXPECT_EQ(texts_of(*page.version()), (QStringList{QStringLiteral("All versions"), QStringLiteral("Version 3")}));
  page.version()->setCurrentIndex(1);
  EXPECT_EQ(rows(), 2);
  EXPECT_EQ(page.filter().version_number, 3);
  page.exercise()->setCurrentIndex(0);
  EXPECT_FALSE(page.filter().version_number);
}

TEST_F(AdminPages, performance_shows_an_exercise_by_criterion_the_hardest_first) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 60, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  EXPECT_FALSE(page.criteria()->isVisible());
  page.exercise()->setCurrentIndex(1);
  ASSERT_TRUE(page.criteria()->isVisible());
  const CriterionFiguresModel& model = page.criteria()->model();
  const auto at = [&](int row, int column) { return plain_text(model.index(row, column).data().toString()); };
  ASSERT_EQ(model.rowCount(), 2);  // of sample_grade(): one with 4 of 10 points, one with all
  EXPECT_EQ(at(0, CriterionFiguresModel::kShare), "40 %");
  EXPECT_EQ(at(0, CriterionFiguresModel::kFull), "0 %");
  EXPECT_EQ(at(1, CriterionFiguresModel::kShare), "100 %");
  EXPECT_EQ(at(1, CriterionFiguresModel::kAttempts), "1");
}

TEST_F(AdminPages, performance_names_a_criterion_of_one_of_several_targets_by_the_target_s_title) {
  Grade grade = sample_grade(60);
  for (CriterionGrade& c : grade.criteria) c.id += "@mesial";
  records.graded_attempt(records.student("1", "Lena Brandt"), "class-1-16", grade, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.exercise()->setCurrentIndex(1);
  const CriterionFiguresModel& model = page.criteria()->model();
  ASSERT_GT(model.rowCount(), 0);
  const QString title = target_title("mesial", &load_builtin("class-1-16")->target);
  EXPECT_EQ(title, QStringLiteral("mesial cavity"));
  for (int row = 0; row < model.rowCount(); ++row)
    EXPECT_TRUE(model.index(row, CriterionFiguresModel::kName).data().toString().contains(title));
}

TEST_F(AdminPages, exercises_stand_by_name_and_staff_are_no_students) {
  for (const char* key : {"paper-block", "class-2-46-mo", "channel-1", "class-1-36"}) records.attempt(records.administrator(), key, 80, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  const QStringList shown = texts_of(*page.exercise()).mid(1);
  QStringList sorted = shown;
  std::ranges::sort(sorted, stands_before, [](const QString& text) { return text.toStdString(); });
  EXPECT_EQ(shown.size(), 4);
  EXPECT_EQ(shown, sorted) << shown.join(u'|').toStdString();
  QStringList texts;
  for (const QLabel* label : page.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("1 person"))) << texts.join(u'|').toStdString();
}

TEST_F(AdminPages, one_student_with_many_attempts_does_not_squeeze_the_medians) {
  std::vector<Account> students;
  for (const char* number : {"1", "2", "3"}) records.attempt(students.emplace_back(records.student(number, std::string("Student ") + number)), "channel-1", 60, 10);
  for (int i = 0; i < 20; ++i) records.attempt(students[0], "channel-1", 70, 10);
  Performance page(records.store(), records.administrator().actor(), ports);
  for (const Chart* chart : page.findChildren<Chart*>())
    if (chart->data().title == QStringLiteral("Learning")) { EXPECT_EQ(chart->data().x.most, 4); }
}

}  // namespace
}  // namespace cusp::test
