// The cohorts' page over records that cannot be read.
#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/instructor/cohorts_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct UnreadCohorts : ::testing::Test {
  UnreadCohorts() {
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  }
  ScenarioVersion exercise() {
    const Scenario scenario = *load_builtin("channel-1");
    return *records.store().scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes);
  }

  DeskRecords records;
  Ports ports;
  Account lena = records.student("4711", "Lena Brandt");
  Actor instructor =
      records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
};

TEST_F(UnreadCohorts, ShowNoStudentsAndTasksOfAnother) {
  Store& store = records.store();
  const Cohort one = *store.cohorts.create(instructor, "A year");
  ASSERT_TRUE(store.cohorts.create(instructor, "B year"));
  ASSERT_TRUE(store.cohorts.add(instructor, one.id, lena.id));
  const auto version = exercise();
  ASSERT_TRUE(store.assignments.create(instructor, {.version = version.id, .cohort = one.id, .kind = SessionKind::practice}, ""));
  CohortsPage page(store, instructor, ports);
  ASSERT_EQ(page.students().rowCount(), 1);
  ASSERT_EQ(page.assignments().rowCount(), 1);
  ASSERT_TRUE(store.database().run("ALTER TABLE cohort_students RENAME TO lost_students"));
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.cohorts()) table->choose_row(1);
  EXPECT_NE(page.message(), QString());
  EXPECT_EQ(page.students().rowCount(), 0);
  EXPECT_EQ(page.assignments().rowCount(), 0);
}

TEST_F(UnreadCohorts, TakeTheirMessageAwayOnceAnotherOneWasRead) {
  Store& store = records.store();
  for (const char* name : {"A year", "B year"}) ASSERT_TRUE(store.cohorts.create(instructor, name));
  CohortsPage page(store, instructor, ports);
  const auto choose = [&page](int row) {
    for (Table* table : page.findChildren<Table*>())
      if (table->model() == &page.cohorts()) table->choose_row(row);
  };
  ASSERT_TRUE(store.database().run("ALTER TABLE cohort_students RENAME TO lost_students"));
  choose(1);
  EXPECT_NE(page.message(), QString());
  ASSERT_TRUE(store.database().run("ALTER TABLE lost_students RENAME TO cohort_students"));
  choose(0);
  EXPECT_EQ(page.message(), QString());
  page.make_cohort(QStringLiteral("C year"));
  ASSERT_NE(page.message(), QString());
  choose(0);
  EXPECT_NE(page.message(), QString()) << "it is no failure of a cohort";
}

TEST_F(UnreadCohorts, SayWithoutExercisesWhyNothingCanBeAssigned) {
  ASSERT_TRUE(records.store().database().run("ALTER TABLE scenario_versions RENAME TO lost_versions"));
  const CohortsPage page(records.store(), instructor, ports);
  EXPECT_EQ(page.form(), nullptr);
  EXPECT_NE(page.message(), QString());
}

TEST_F(UnreadCohorts, ShowThatTheStartCodeOfAnAssessmentCannotBeRead) {
  Store& store = records.store();
  const Cohort year = *store.cohorts.create(instructor, "A year");
  const auto version = exercise();
  ASSERT_TRUE(store.assignments.create(instructor, {.version = version.id, .cohort = year.id, .kind = SessionKind::assessment}, "4711"));
  ASSERT_TRUE(store.database().run("ALTER TABLE assessments RENAME TO lost_assessments"));
  CohortsPage page(store, instructor, ports);
  ASSERT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.assignments()) table->choose_row(0);
  const auto says_why = [](const QLabel* label) { return label->text().contains(QStringLiteral("The start code could not be read")); };
  EXPECT_TRUE(std::ranges::any_of(page.findChildren<QLabel*>(), says_why));
}

}  // namespace
}  // namespace cusp::test
