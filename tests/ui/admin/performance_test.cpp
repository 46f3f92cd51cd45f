// The performance page over real records.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <memory>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "tests/ui/looks.h"
#include "ui/admin/export_work.h"
#include "ui/admin/performance.h"
#include "ui/student/course.h"
#include "ui/text/names.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

void export_whole(Performance& page) {
  page.export_csv();
  EXPECT_TRUE(page.exporting()) << "the window goes on meanwhile";
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page.exporting(); }));
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

TEST_F(AdminPages, one_attempt_and_one_point_are_said_in_the_singular) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 60, 400);
  Performance page(records.store(), records.administrator().actor(), ports);
  QStringList said;
  for (const Chart* chart : page.findChildren<Chart*>()) {
    ASSERT_NE(chart->data().value_text, nullptr) << chart->data().title.toStdString();
    said += chart->data().value_text(1);
  }
  said.sort();
  EXPECT_EQ(said, (QStringList{QStringLiteral("1 attempt"), QStringLiteral("1 point")}));
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

TEST_F(AdminPages, a_median_time_has_its_unit_and_from_an_hour_on_its_hours) {
  const Account lena = records.student("1", "Lena Brandt");
  const auto median_time = [&] {
    const Performance page(records.store(), records.administrator().actor(), ports);
    for (const Card* card : page.findChildren<Card*>()) {
      if (card->accessibleName() != u"Median time") continue;
      QString all;
      for (const QLabel* label : card->findChildren<QLabel*>()) all += label->text();
      return all.remove(QChar(0x2066)).remove(QChar(0x2069)).toStdString();
    }
    return std::string();
  };
  records.attempt(lena, "channel-1", 78, 458);
  EXPECT_EQ(median_time(), "Median time7:38 min");
  records.attempt(lena, "channel-1", 78, 6'942);
  EXPECT_EQ(median_time(), "Median time1:01:40 h");  // of 458 s and 6,942 s
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
  export_whole(page);
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

TEST_F(AdminPages, performance_is_no_wider_for_a_cohort_whose_name_has_60_letters) {
  const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  const std::string name(60, 'W');
  ASSERT_TRUE(records.store().cohorts.create(berg.actor(), name));
  Performance page(records.store(), records.administrator().actor(), ports);
  ASSERT_GE(page.cohort()->findText(QString::fromStdString(name)), 0);
  page.resize(kPageAtHalfOfFullHd);
  page.show();
  QTest::qWait(0);
  const auto* area = page.findChild<QScrollArea*>();
  EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width());
}

TEST_F(AdminPages, csv_holds_what_the_filters_leave) {
  const Account lena = records.student("1", "Lena Brandt"), noah = records.student("2", "Noah Adler");
  records.attempt(lena, "channel-1", 78, 100);
  records.attempt(noah, "channel-1", 90, 100);
  const QTemporaryDir folder;
  file = folder.filePath(QStringLiteral("out.csv"));
  Performance page(records.store(), records.administrator().actor(), ports);
  page.search()->setText(QStringLiteral("Lena"));
  export_whole(page);
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray bytes = written.readAll();
  EXPECT_EQ(bytes.count("\r\n"), 2);  // head and one attempt
  EXPECT_TRUE(bytes.startsWith("\xEF\xBB\xBFsession,")) << "a spreadsheet reads it as UTF-8";
  EXPECT_TRUE(bytes.contains(",finished_utc,cohort,opens_utc,due_utc\r\n"));
  EXPECT_TRUE(bytes.contains("Lena Brandt"));
  EXPECT_FALSE(bytes.contains("Noah Adler"));
}

TEST_F(AdminPages, a_file_that_cannot_be_written_is_named_with_the_reason_and_nothing_is_left) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 78, 100);
  const QTemporaryDir folder;
  file = folder.filePath(QStringLiteral("gone/out.csv"));
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  export_whole(page);
  const auto* band = page.findChild<Band*>();
  EXPECT_TRUE(band->text().contains(QStringLiteral("The file was not written."))) << band->text().toStdString();
  EXPECT_TRUE(band->text().contains(file)) << band->text().toStdString();
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(AdminPages, an_export_that_a_full_disk_cuts_off_at_its_end_is_not_logged) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 78, 100);
  file = QStringLiteral("/dev/full");
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  export_whole(page);
  EXPECT_TRUE(page.findChild<Band*>()->text().contains(QStringLiteral("The file was not written."))) << page.findChild<Band*>()->text().toStdString();
  const auto newest = records.store().audit.list(records.administrator().actor(), 1);
  EXPECT_NE(newest->at(0).action, "history_exported");
}

TEST_F(AdminPages, a_cancelled_export_leaves_the_file_that_was_there_and_no_other) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 78, 100);
  const QTemporaryDir folder;
  file = folder.filePath(QStringLiteral("out.csv"));
  QFile before(file);
  ASSERT_TRUE(before.open(QIODevice::WriteOnly));
  before.write("before");
  before.close();
  const auto progress = std::make_shared<WorkProgress>();
  progress->stop = true;
  std::atomic<bool> stopped{false};
  const BackgroundTask task = export_in_background(records_of(records.store()), records.administrator().actor(), {file.toStdString(), {}, {}}, progress,
                                                   [&](const Stored<std::optional<std::size_t>>& rows) { stopped = rows && !*rows; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return task.over(); }));
  EXPECT_TRUE(stopped);
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{QStringLiteral("out.csv")});
  ASSERT_TRUE(before.open(QIODevice::ReadOnly));
  EXPECT_EQ(before.readAll(), "before");
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
  page.kind()->setCurrentIndex(page.kind()->findText(QStringLiteral("Assessments")));
  EXPECT_EQ(rows(), 0) << "all of them practised";
  page.kind()->setCurrentIndex(page.kind()->findText(QStringLiteral("Practice")));
  EXPECT_EQ(rows(), 3);
  page.kind()->setCurrentIndex(0);
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

TEST_F(AdminPages, attempts_of_scripted_operators_count_only_where_they_are_chosen) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 100);
  const auto texts = [](const QWidget& page) {
    QStringList out;
    for (const QLabel* label : page.findChildren<QLabel*>())
      if (!label->isHidden()) out += label->text();
    return out.join(u'|');
  };
  const QString left_out = QStringLiteral("Attempts of scripted operators are left out.");
  {
    Performance page(records.store(), records.administrator().actor(), ports);
    page.show();
    EXPECT_FALSE(texts(page).contains(left_out)) << "there are none";
  }
  records.scripted_attempt(lena, "channel-1", 100, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  const auto rows = [&] { return page.attempts().rowCount(); };
  EXPECT_EQ(rows(), 1);
  EXPECT_TRUE(texts(page).contains(left_out)) << texts(page).toStdString();
  EXPECT_TRUE(texts(page).contains(QStringLiteral("Median score|60|"))) << texts(page).toStdString();
  page.who()->setCurrentIndex(page.who()->findText(QStringLiteral("Students")));
  EXPECT_EQ(rows(), 1);
  page.who()->setCurrentIndex(page.who()->findText(QStringLiteral("Scripted")));
  ASSERT_EQ(rows(), 1);
  EXPECT_EQ(page.attempts().row(0).operator_name, "expert");
  EXPECT_FALSE(texts(page).contains(left_out));
  page.who()->setCurrentIndex(0);
  page.device()->setCurrentIndex(page.device()->findText(QStringLiteral("Scripted operator")));
  ASSERT_EQ(rows(), 1);
  EXPECT_EQ(page.attempts().row(0).operator_name, "expert");
}

TEST_F(AdminPages, read_again_performance_offers_new_devices_cohorts_and_exercises_and_keeps_what_is_chosen) {
  const Actor reader = records.administrator().actor();
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "paper-block", 60, 100);
  ASSERT_TRUE(records.store().cohorts.create(reader, "Year 4"));
  Performance page(records.store(), reader, ports);
  page.show();
  page.exercise()->setCurrentIndex(1);
  page.version()->setCurrentIndex(1);
  page.device()->setCurrentIndex(1);
  page.cohort()->setCurrentIndex(1);
  const HistoryFilter chosen = page.filter();
  ASSERT_TRUE(chosen.scenario && chosen.version_number && chosen.device_class && chosen.cohort);
  records.attempt(lena, "channel-1", 60, 100, "falcon");
  ASSERT_TRUE(records.store().cohorts.create(reader, "Year 3"));
  ASSERT_TRUE(page.read_again());
  EXPECT_EQ(page.exercise()->count(), 3);
  EXPECT_EQ(page.cohort()->count(), 3);
  EXPECT_GE(page.device()->findText(QStringLiteral("Falcon")), 0);
  EXPECT_EQ(page.filter().scenario, chosen.scenario);
  EXPECT_EQ(page.filter().version_number, chosen.version_number);
  EXPECT_EQ(page.filter().device_class, chosen.device_class);
  EXPECT_EQ(page.filter().cohort, chosen.cohort);
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
