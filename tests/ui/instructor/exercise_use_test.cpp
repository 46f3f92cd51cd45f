// Who uses an exercise of the library.

#include "ui/instructor/exercise_use.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/instructor/library_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kHourUs = 3'600'000'000;

struct UseOfAnExercise : ::testing::Test {
  DeskRecords records;
  QTemporaryDir cache;
  Ports ports = Ports::of_the_system();
  const ScenarioId channel = load_builtin("channel-1")->id;
  Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  Actor instructor() const { return berg.actor(); }
  QString text(ScenarioId id) { return use_text(*use_of(records.store(), instructor(), id, records.now_us)); }
  /// Assigns the version that was drilled.
  void assign(const std::string& cohort_name, std::optional<std::int64_t> due_utc_us) {
    const auto versions = records.store().scenarios.versions(channel);
    const Cohort cohort = *records.store().cohorts.create(instructor(), cohort_name);
    ASSERT_TRUE(records.store().assignments.create(instructor(), {.version = versions->back().id, .cohort = cohort.id, .due_utc_us = due_utc_us}));
  }
};

TEST_F(UseOfAnExercise, is_nobody_before_an_attempt_is_graded) {
  EXPECT_EQ(text(channel), QStringLiteral("No student has a graded attempt yet."));
  records.broken_attempt(records.student("1001", "Lena Brandt"), "channel-1");
  EXPECT_EQ(text(channel), QStringLiteral("No student has a graded attempt yet."));
}

TEST_F(UseOfAnExercise, counts_students_and_graded_attempts_of_it_alone) {
  const Account lena = records.student("1001", "Lena Brandt"), omar = records.student("1002", "Omar Haddad");
  for (const double score : {60.0, 80.0}) records.attempt(lena, "channel-1", score, 60);
  records.attempt(omar, "channel-1", 90, 60);
  records.attempt(omar, "channel-2", 10, 60);
  EXPECT_EQ(text(channel), QStringLiteral("2 students, 3 graded attempts, median 80 points."));
}

TEST_F(UseOfAnExercise, names_the_cohorts_that_have_it_assigned_now) {
  records.attempt(records.student("1001", "Lena Brandt"), "channel-1", 70, 60);
  assign("Year 3", std::nullopt);
  assign("Year 2", records.now_us - kHourUs);  // over
  EXPECT_TRUE(text(channel).contains(QStringLiteral("Assigned now: "))) << text(channel).toStdString();
  EXPECT_TRUE(text(channel).contains(QStringLiteral("Year 3")));
  EXPECT_FALSE(text(channel).contains(QStringLiteral("Year 2")));
}

TEST_F(UseOfAnExercise, stands_under_the_list_for_the_chosen_row) {
  records.attempt(records.student("1001", "Lena Brandt"), "channel-1", 70, 60);
  LibraryPage page(records.store(), instructor(), ports, records.file(), cache.path().toStdString());
  page.show();
  const auto shown = [&](const QString& part) {
    const auto labels = page.findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* label) { return label->isVisible() && label->text().contains(part); });
  };
  for (int i = 0; i < page.model().rowCount(); ++i) {
    page.table()->choose_row(i);
    const bool drilled = page.model().row(i).shown().id == channel;
    EXPECT_EQ(shown(QStringLiteral("1 graded attempt")), drilled);
    EXPECT_EQ(shown(QStringLiteral("No student has a graded attempt yet.")), !drilled);
  }
}

TEST_F(UseOfAnExercise, counts_no_attempt_of_staff) {
  records.attempt(berg, "channel-1", 95, 60);
  EXPECT_EQ(text(channel), QStringLiteral("No student has a graded attempt yet."));
}

}  // namespace
}  // namespace cusp::test
