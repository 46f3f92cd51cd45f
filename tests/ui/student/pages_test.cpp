// The student's pages over real records.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/ui/desk_records.h"
#include "ui/student/briefing.h"
#include "ui/student/exercises_page.h"
#include "ui/student/own_history.h"
#include "ui/student/start_page.h"
#include "ui/widgets/table.h"

namespace cusp {
namespace {

using test::DeskRecords;

/// Every text that a page shows.
QString texts(QWidget& page) {
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  return all;
}

struct Pages : ::testing::Test {
  DeskRecords records;
  QTemporaryDir cache;
  PictureShelf pictures{cache.path().toStdString()};
  QDateTime now{QDate(2026, 11, 20), QTime(10, 0)};
};

TEST_F(Pages, closing_gives_up_the_picture_that_is_being_drawn) {
  const QTemporaryDir folder;
  {
    PictureShelf shelf(folder.path().toStdString());
    Exercise jaw;
    jaw.scenario = *load_builtin("class-1-36-jaw");
    EXPECT_TRUE(shelf.picture(jaw, {}, PictureShelf::Use::card, false).isNull());
  }
  EXPECT_TRUE(QDir(folder.path()).isEmpty()) << "it was drawn to its end";
}

TEST_F(Pages, the_start_page_of_a_new_student_says_what_is_not_there_yet_and_offers_the_first_exercise) {
  const Account lena = records.student("1", "Lena Brandt");
  StartPage page(records.store(), lena, pictures, now);
  page.resize(1080, 752);
  page.show();
  EXPECT_TRUE(texts(page).contains(QStringLiteral("No result yet")));
  EXPECT_TRUE(texts(page).contains(QStringLiteral("Fri 20 Nov")));
  std::optional<Exercise> started;
  QObject::connect(&page, &StartPage::start_wanted, [&](const Exercise& e) { started = e; });
  page.start_button()->click();
  ASSERT_TRUE(started.has_value());
  EXPECT_EQ(started->scenario.key, builtin_scenarios()[0]);
}

TEST_F(Pages, the_start_page_shows_the_last_result_and_how_to_do_better) {
  const Account lena = records.student("1", "Lena Brandt");
  records.go(lena, "channel-1", 74, 500);
  records.go(lena, "channel-1", 78, 426);
  StartPage page(records.store(), lena, pictures, now);
  const QString all = texts(page);
  EXPECT_TRUE(all.contains(QStringLiteral("78")));
  EXPECT_TRUE(all.contains(QStringLiteral("4 more than\nyour best before")));
  EXPECT_TRUE(all.contains(QStringLiteral("Stop pushing before the wanted depth")));  // depth_most, too_deep
  EXPECT_TRUE(all.contains(QStringLiteral("Mouse and keys only, 2 goes.")));
}

TEST_F(Pages, the_list_opens_the_briefing_with_enter) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor());
  page.show();
  std::optional<Exercise> wanted;
  QObject::connect(&page, &ExercisesPage::briefing_wanted, [&](const Exercise& e) { wanted = e; });
  page.table()->choose_row(1);
  QTest::keyClick(page.table(), Qt::Key_Return);
  ASSERT_TRUE(wanted.has_value());
  EXPECT_EQ(wanted->scenario.key, builtin_scenarios()[1]);
}

TEST_F(Pages, a_word_finds_its_exercises_and_enter_opens_the_first) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor());
  page.show();
  std::optional<Exercise> wanted;
  QObject::connect(&page, &ExercisesPage::briefing_wanted, [&](const Exercise& e) { wanted = e; });
  const int all = page.table()->model()->rowCount();
  page.search()->setText(QStringLiteral("class i"));
  EXPECT_EQ(page.table()->model()->rowCount(), 3);  // dry, with turbine and water, and in a jaw
  QTest::keyClick(page.search(), Qt::Key_Return);
  ASSERT_TRUE(wanted.has_value());
  EXPECT_EQ(wanted->scenario.key, "class-1-36");
  page.search()->setText(QStringLiteral("no such thing"));
  EXPECT_EQ(page.table()->model()->rowCount(), 0);
  wanted.reset();
  QTest::keyClick(page.search(), Qt::Key_Return);
  EXPECT_FALSE(wanted.has_value());
  for (QPushButton* button : page.findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("Show all exercises")) button->click();
  }
  EXPECT_EQ(page.table()->model()->rowCount(), all);
}

TEST_F(Pages, a_sorted_list_opens_the_exercise_that_it_shows) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor());
  page.show();
  std::optional<Exercise> wanted;
  QObject::connect(&page, &ExercisesPage::briefing_wanted, [&](const Exercise& e) { wanted = e; });
  page.table()->sortByColumn(CourseModel::kExercise, Qt::AscendingOrder);
  page.table()->choose_row(0);
  QTest::keyClick(page.table(), Qt::Key_Return);
  ASSERT_TRUE(wanted.has_value());
  EXPECT_EQ(wanted->scenario.key, "circle-1");  // "Circle, level 1" is the first of the alphabet
  page.table()->sortByColumn(-1, Qt::AscendingOrder);
  page.table()->choose_row(0);
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted->scenario.key, builtin_scenarios()[0]);  // the order of the course again
}

TEST_F(Pages, the_start_page_fits_a_window_of_1280) {
  const Account lena = records.student("1", "Lena Brandt");
  StartPage page(records.store(), lena, pictures, now);
  page.resize(1080, 752);  // less the bar at the side
  page.show();
  const auto* scroll = page.findChild<QScrollArea*>();
  ASSERT_NE(scroll, nullptr);
  QTest::qWait(0);
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0);
}

TEST_F(Pages, the_briefing_says_what_earns_points_and_starts) {
  const auto list = load_exercises(records.store());
  Briefing page(list->exercises.front(), pictures, {});
  page.show();
  const Scenario& s = list->exercises.front().scenario;
  const QString all = texts(page);
  EXPECT_TRUE(all.contains(QString::fromStdString(s.title.at("en"))));
  EXPECT_TRUE(all.contains(QString::fromStdString(s.briefing.at("en"))));
  const auto* table = page.findChild<Table*>();
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->model()->rowCount(), static_cast<int>(s.rubric.criteria.size()));
  QSignalSpy started(&page, &Briefing::start_wanted);
  page.start_button()->click();
  EXPECT_EQ(started.count(), 1);
}

TEST_F(Pages, my_results_filters_by_exercise_and_opens_a_report) {
  const Account lena = records.student("1", "Lena Brandt");
  records.go(lena, "channel-1", 60, 300);
  const SessionId block = records.go(lena, "paper-block", 70, 200);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table()->model()->rowCount(), 2);
  std::optional<SessionId> wanted;
  QObject::connect(&page, &OwnHistory::report_wanted, [&](const SessionId& id) { wanted = id; });
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted, block);  // the newest first
  page.exercise()->setCurrentIndex(2);
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
}

TEST_F(Pages, my_results_without_a_go_offers_the_exercises) {
  const Account lena = records.student("1", "Lena Brandt");
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table(), nullptr);
  QSignalSpy wanted(&page, &OwnHistory::exercises_wanted);
  page.findChild<QPushButton*>()->click();
  EXPECT_EQ(wanted.count(), 1);
}

}  // namespace
}  // namespace cusp
