// What is chosen on a page stays while another page lies over it.

#include <gtest/gtest.h>

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cstdint>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/people_import.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/admin/performance.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/instructor/cohorts_page.h"
#include "ui/instructor/library_page.h"
#include "ui/student/assessments.h"
#include "ui/student/course.h"
#include "ui/student/exercise_cards.h"
#include "ui/student/exercises_page.h"
#include "ui/student/own_history.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

struct ComingBack : ::testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  std::unique_ptr<Desktop> desktop;
  template <class Page>
  Page* open(const Account& account, const char* key) {
    desktop = std::make_unique<Desktop>(settings, Ports::of_the_system(), records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(account);
    desktop->shell()->show_page(QLatin1String(key));
    return page<Page>();
  }
  template <class Page>
  Page* page() {
    return qobject_cast<Page*>(desktop->shell()->page());
  }
  /// A page with a way back and a field, with which it begins: that field.
  const QLineEdit* push_page() {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->addWidget(new QPushButton(QStringLiteral("Back")));
    auto* begins = new QLineEdit;
    column->addWidget(begins);
    page->setFocusProxy(begins);
    desktop->push(page);
    return begins;
  }
  void cover_and_come_back() {
    desktop->push(new QWidget);
    desktop->back();
  }
};

TEST_F(ComingBack, performance_keeps_its_filters_order_and_row_and_reads_what_is_new) {
  const Account lena = records.student("1", "Lena Brandt"), omar = records.student("2", "Omar Said");
  const SessionId chosen = records.attempt(lena, "channel-1", 40, 100);
  records.attempt(lena, "channel-1", 90, 100);
  records.attempt(omar, "channel-1", 50, 100);
  auto* shown = open<Performance>(records.administrator(), "performance");
  ASSERT_NE(shown, nullptr);
  shown->search()->setText(QStringLiteral("brandt"));
  shown->exercise()->setCurrentIndex(1);
  shown->table()->sortByColumn(AttemptsModel::kScore, Qt::DescendingOrder);
  shown->table()->choose_row(1);
  records.attempt(lena, "channel-1", 95, 100);
  cover_and_come_back();
  shown = page<Performance>();
  EXPECT_EQ(shown->search()->text(), QStringLiteral("brandt"));
  EXPECT_EQ(shown->exercise()->currentIndex(), 1);
  EXPECT_EQ(shown->attempts().rowCount(), 3) << "with what was drilled meanwhile";
  ASSERT_EQ(shown->table()->chosen_row(), 2);
  std::optional<SessionId> opened;
  QObject::connect(shown, &Performance::report_wanted, [&](const SessionId& id) { opened = id; });
  Q_EMIT shown->table()->row_opened(shown->table()->model()->index(2, 0));
  EXPECT_EQ(opened, chosen);
}

TEST_F(ComingBack, people_keep_their_order_and_row_and_show_who_is_new) {
  records.student("2", "Noah Adler");
  const Account lena = records.student("10", "Lena Brandt");
  auto* shown = open<PeoplePage>(records.administrator(), "people");
  ASSERT_NE(shown, nullptr);
  shown->table()->sortByColumn(PeopleModel::kNumber, Qt::DescendingOrder);
  shown->table()->choose_row(shown->model()->row_of(lena.id));
  desktop->import_people();
  records.student("11", "Mia Falk");
  auto* import = desktop->findChild<PeopleImport*>();
  ASSERT_NE(import, nullptr);
  Q_EMIT import->back_wanted();
  ASSERT_EQ(page<PeoplePage>(), shown);
  ASSERT_EQ(shown->model()->rowCount(), 4);
  EXPECT_EQ(shown->model()->account(1).name, "Mia Falk") << "between anna and 10";
  EXPECT_EQ(shown->table()->chosen_row(), shown->model()->row_of(lena.id));
  EXPECT_EQ(shown->table()->chosen_row(), 2);
}

TEST_F(ComingBack, the_keyboard_is_where_it_was_on_the_page) {
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 40, 100);
  auto* shown = open<Performance>(records.administrator(), "performance");
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  ASSERT_TRUE(shown->isAncestorOf(QApplication::focusWidget()));
  shown->table()->setFocus();
  ASSERT_EQ(QApplication::focusWidget(), shown->table());
  auto* cover = new QLineEdit;
  desktop->push(cover);
  ASSERT_EQ(QApplication::focusWidget(), cover);
  desktop->back();
  EXPECT_EQ(QApplication::focusWidget(), shown->table());
}

TEST_F(ComingBack, a_page_that_opens_has_the_keyboard_where_it_begins) {
  apply_theme(*qApp, ColourScheme::light, 100);
  open<Performance>(records.administrator(), "performance");
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  desktop->push(new HandedIn(QStringLiteral("W7C UPT")));
  const auto* next = qobject_cast<QPushButton*>(QApplication::focusWidget());
  ASSERT_NE(next, nullptr) << "Enter leads to the next candidate";
  EXPECT_EQ(next->text().toStdString(), "Next candidate");
  const QLineEdit* begins = push_page();
  EXPECT_EQ(QApplication::focusWidget(), begins) << "not on the first control";
}

TEST_F(ComingBack, the_keyboard_is_where_it_was_on_a_page_over_the_window) {
  apply_theme(*qApp, ColourScheme::light, 100);
  open<Performance>(records.administrator(), "performance");
  desktop->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(desktop.get()));
  const QLineEdit* candidates = push_page();
  ASSERT_EQ(QApplication::focusWidget(), candidates);
  cover_and_come_back();
  EXPECT_EQ(QApplication::focusWidget(), candidates) << "Enter would leave the page";
  auto* report = new QLineEdit;
  desktop->push(report);
  ASSERT_EQ(QApplication::focusWidget(), report);
  desktop->back();
  EXPECT_EQ(QApplication::focusWidget(), candidates);
}

TEST_F(ComingBack, performance_offers_an_exercise_that_was_drilled_for_the_first_time) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 40, 100);
  EXPECT_EQ(open<Performance>(records.administrator(), "performance")->exercise()->count(), 2);
  records.attempt(lena, "paper-block", 40, 100);
  cover_and_come_back();
  EXPECT_EQ(page<Performance>()->exercise()->count(), 3);
}

TEST_F(ComingBack, cohorts_keep_the_chosen_one_and_its_assignment) {
  const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  for (const char* name : {"Year 1", "Year 2"}) ASSERT_TRUE(records.store().cohorts.create(berg.actor(), name));
  const auto table_of = [](const CohortsPage& of, const QAbstractItemModel& model) {
    Table* out = nullptr;
    for (Table* table : of.findChildren<Table*>())
      if (table->model() == &model) out = table;
    return out;
  };
  auto* shown = open<CohortsPage>(berg, "cohorts");
  ASSERT_NE(shown, nullptr);
  table_of(*shown, shown->cohorts())->choose_row(1);
  shown->assign();
  table_of(*shown, shown->assignments())->choose_row(0);
  cover_and_come_back();
  shown = page<CohortsPage>();
  EXPECT_EQ(table_of(*shown, shown->cohorts())->chosen_row(), 1);
  EXPECT_EQ(table_of(*shown, shown->assignments())->chosen_row(), 0);
  EXPECT_EQ(desktop->focusWidget(), table_of(*shown, shown->cohorts())) << "the keyboard is on the page";
  Assignment earlier = shown->assignments().row(0).assignment;
  const AssignmentId chosen = earlier.id;
  earlier.due_utc_us = earlier.due_utc_us.value_or(std::int64_t{4'000'000'000} * 1'000'000) - 1;
  ASSERT_TRUE(records.store().assignments.create(berg.actor(), earlier));  // at another desk
  cover_and_come_back();
  const int row = table_of(*shown, shown->assignments())->chosen_row();
  ASSERT_GE(row, 0);
  EXPECT_EQ(shown->assignments().row(row).assignment.id, chosen) << "and no other one is withdrawn";
}

TEST_F(ComingBack, library_keeps_search_and_row) {
  const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  auto* shown = open<LibraryPage>(berg, "library");
  ASSERT_NE(shown, nullptr);
  shown->search()->setText(QStringLiteral("46"));
  int last = -1;
  for (int row = 0; row < shown->model().rowCount(); ++row)
    if (!shown->table()->isRowHidden(row)) last = row;
  ASSERT_GT(last, 0);
  shown->table()->choose_row(last);
  cover_and_come_back();
  shown = page<LibraryPage>();
  EXPECT_EQ(shown->search()->text(), QStringLiteral("46"));
  EXPECT_EQ(shown->table()->chosen_row(), last);
}

TEST_F(ComingBack, exercises_keep_search_standing_and_card_and_count_what_was_passed) {
  const Account lena = records.student("1", "Lena Brandt");
  auto* shown = open<ExercisesPage>(lena, "exercises");
  ASSERT_NE(shown, nullptr);
  shown->standing()->setCurrentIndex(1);  // not passed yet
  shown->search()->setText(QStringLiteral("class i, tooth"));
  ExerciseCards* cards = shown->cards(ExerciseGroup::class_1);
  ASSERT_EQ(cards->model()->rowCount(), 3);
  const QString opened = cards->model()->index(1, 0).data().toString();
  Q_EMIT cards->opened(cards->model()->index(1, 0));
  ASSERT_NE(desktop->page(), desktop->shell()) << "the briefing";
  records.attempt(lena, "class-1-36", 90, 100);
  desktop->back();
  shown = page<ExercisesPage>();
  EXPECT_EQ(shown->standing()->currentIndex(), 1);
  EXPECT_EQ(shown->search()->text().toStdString(), "class i, tooth");
  cards = shown->cards(ExerciseGroup::class_1);
  EXPECT_EQ(cards->model()->rowCount(), 2);
  EXPECT_EQ(cards->currentIndex().data().toString().toStdString(), opened.toStdString());
}

TEST_F(ComingBack, my_results_keep_the_exercise) {
  const Account lena = records.student("1", "Lena Brandt");
  for (const char* key : {"channel-1", "paper-block"}) records.attempt(lena, key, 60, 100);
  auto* shown = open<OwnHistory>(lena, "results");
  ASSERT_NE(shown, nullptr);
  shown->exercise()->setCurrentIndex(2);
  cover_and_come_back();
  shown = page<OwnHistory>();
  EXPECT_EQ(shown->exercise()->currentIndex(), 2);
  EXPECT_EQ(shown->table()->model()->rowCount(), 1);
}

}  // namespace
}  // namespace cusp::test
