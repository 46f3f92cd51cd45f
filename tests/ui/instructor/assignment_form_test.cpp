// The form of an assignment while another desk changes what can be assigned.
#include <gtest/gtest.h>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/instructor/cohorts_page.h"

namespace cusp::test {
namespace {

TEST(AssignmentForm, puts_no_other_exercise_in_the_place_of_one_that_is_gone) {
  DeskRecords records;
  Ports ports;
  ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
  const Account instructor =
      *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  Scenarios& scenarios = records.store().scenarios;
  Scenario own = *load_builtin("channel-1");
  own.id = ScenarioId::make();
  own.key.clear();
  own.version = 1;
  const auto version = scenarios.publish(instructor.actor(), own, canonical_json(own), content_hash(own).bytes);
  ASSERT_TRUE(version);
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_exercise(own.id);
  ASSERT_EQ(page.form()->wish().exercise.version, version->id);
  ASSERT_TRUE(scenarios.withdraw(instructor.actor(), version->id));
  page.assign();
  EXPECT_TRUE(page.message().contains(QStringLiteral("no longer has this exercise"))) << page.message().toStdString();
  EXPECT_FALSE(page.form()->has_exercise());
  for (int again = 0; again < 2; ++again) {
    page.assign();
    EXPECT_EQ(page.assignments().rowCount(), 0) << "the form's first exercise: " << page.message().toStdString();
    EXPECT_TRUE(page.message().contains(QStringLiteral("No exercise is chosen."))) << page.message().toStdString();
    page.read_again();
    EXPECT_FALSE(page.form()->has_exercise());
  }
  page.form()->choose_exercise(load_builtin("channel-1")->id);
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
}

}  // namespace
}  // namespace cusp::test
