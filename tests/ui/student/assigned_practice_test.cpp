// Practice that is assigned to a student's cohort, in the course.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/course.h"
#include "ui/widgets/format.h"

namespace cusp::test {
namespace {

constexpr std::int64_t kHourUs = 3'600'000'000;

struct AssignedPractice : testing::Test {
  DeskRecords records;
  Account lena = records.student("4711", "Lena Brandt");
  Actor examiner = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
  CohortId cohort = records.store().cohorts.create(examiner, "Year 3")->id;

  void SetUp() override { ASSERT_TRUE(records.store().cohorts.add(examiner, cohort, lena.id)); }
  VersionId delivered() {
    const Scenario scenario = *load_builtin("channel-1");
    return records.store().scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes)->id;
  }
  /// The exercise with a time limit, as its next version.
  VersionId newer() {
    Scenario scenario = *load_builtin("channel-1");
    scenario.version += 1;
    scenario.time_limit_s = 600;
    return records.store().scenarios.publish(examiner, scenario, canonical_json(scenario), content_hash(scenario).bytes)->id;
  }
  Assignment assign(Assignment wanted) {
    wanted.cohort = cohort;
    return *records.store().assignments.create(examiner, wanted);
  }
  /// What the course shows of the exercise that is assigned.
  CourseRow row() {
    const Course course = *load_course(records.store(), lena.actor());
    const auto it = std::ranges::find_if(course.rows, [](const CourseRow& r) { return r.assignment.has_value(); });
    return it == course.rows.end() ? CourseRow{} : *it;
  }
  /// Whether the student is shown that a further attempt does not count, by these words.
  bool warns(const char* words) { return uncounted_text(row(), "pointer").contains(QLatin1String(words)); }
  QString text_of(int column, int role = Qt::DisplayRole) {
    const CourseModel model(std::vector<CourseRow>{row()});
    return model.index(0, column).data(role).toString();
  }
};

TEST_F(AssignedPractice, ThatIsOverLimitsNothing) {
  assign({.version = delivered(), .due_utc_us = kMorning + kHourUs, .attempts_allowed = 3, .device_classes = {"falcon"}});
  records.attempt(lena, "channel-1", 60, 100);
  EXPECT_EQ(text_of(CourseModel::kAttempts), QStringLiteral("0 of 3"));
  records.now_us = kMorning + 2 * kHourUs;
  ASSERT_TRUE(row().over);
  EXPECT_TRUE(row().device_classes.empty()) << "an attempt counts with no device";
  EXPECT_EQ(text_of(CourseModel::kAttempts), QStringLiteral("1"));
}

TEST_F(AssignedPractice, WarnsOnceItIsOverUntilItIsPassed) {
  assign({.version = delivered(), .due_utc_us = kMorning + kHourUs});
  EXPECT_TRUE(uncounted_text(row(), "pointer").isEmpty());
  records.now_us = kMorning + 2 * kHourUs;
  EXPECT_TRUE(warns("is over"));
  records.attempt(lena, "channel-1", 90, 100);
  EXPECT_TRUE(uncounted_text(row(), "pointer").isEmpty());
}

TEST_F(AssignedPractice, WarnsOnceEveryAttemptIsUsed) {
  const Assignment once = assign({.version = delivered(), .attempts_allowed = 1});
  EXPECT_TRUE(uncounted_text(row(), "pointer").isEmpty());
  NewSession wanted{.student = lena.id, .version = once.version, .assignment = once.id};
  wanted.header.device.device_class = "pointer";
  wanted.header.scene = "{}";
  ASSERT_TRUE(records.store().sessions.start(lena.actor(), wanted));
  EXPECT_TRUE(warns("Every attempt that counts is used"));
}

TEST_F(AssignedPractice, WarnsWhereItAsksForAnotherDevice) {
  assign({.version = delivered(), .device_classes = {"falcon"}});
  EXPECT_TRUE(warns("ask the staff to choose it on the page Device"));
  EXPECT_TRUE(uncounted_text(row(), "falcon").isEmpty());
}

TEST_F(AssignedPractice, WhoseAttemptsCannotBeCountedIsNotTakenForUntried) {
  assign({.version = delivered(), .attempts_allowed = 1});
  records.attempt(lena, "channel-1", 60, 100);
  ASSERT_TRUE(load_course(records.store(), lena.actor()));
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_assignment"));  // no attempt is counted without it
  EXPECT_FALSE(load_course(records.store(), lena.actor()));
}

TEST_F(AssignedPractice, ThatIsOverAndWasNeverTriedIsNoLongerDue) {
  assign({.version = delivered(), .due_utc_us = kMorning + kHourUs});
  EXPECT_TRUE(text_of(0, CourseModel::StandingRole).startsWith(QStringLiteral("Due ")));
  records.now_us = kMorning + 2 * kHourUs;
  EXPECT_EQ(text_of(0, CourseModel::StandingRole), QStringLiteral("not tried yet"));
}

TEST_F(AssignedPractice, DueAtMidnightIsShownWithItsTimeOrOnTheDayThatEndsThen) {
  const QDateTime midnight = local_time(kMorning).date().addDays(1).startOfDay();
  const std::int64_t due_us = midnight.toMSecsSinceEpoch() * 1000;
  assign({.version = delivered(), .due_utc_us = due_us});
  EXPECT_EQ(text_of(CourseModel::kDue), format_day_time(midnight));
  EXPECT_EQ(text_of(0, CourseModel::StandingRole), QStringLiteral("Due %1").arg(format_day(midnight.addSecs(-1))));
}

TEST_F(AssignedPractice, WithoutAttemptsLeftIsNoLongerDueAndNotNext) {
  const VersionId version = delivered();
  const Assignment due = assign({.version = version, .due_utc_us = kMorning + kHourUs, .attempts_allowed = 1});
  const Scenario other = *load_builtin("paper-block");
  const VersionId later = records.store().scenarios.ensure(other, canonical_json(other), content_hash(other).bytes)->id;
  assign({.version = later, .due_utc_us = kMorning + 9 * kHourUs});
  const auto next = [&] {
    const Course course = *load_course(records.store(), lena.actor());
    return course.rows[static_cast<std::size_t>(course.next())];
  };
  EXPECT_EQ(next().exercise.version, version);
  NewSession wanted{.student = lena.id, .version = version, .assignment = due.id};
  wanted.header.device.device_class = "pointer";
  wanted.header.scene = "{}";
  ASSERT_TRUE(records.store().sessions.start(lena.actor(), wanted));
  EXPECT_EQ(next().exercise.version, later) << "a further attempt at the other one counts for none";
  const Course course = *load_course(records.store(), lena.actor());
  const auto used = std::ranges::find_if(course.rows, [&](const CourseRow& r) { return r.exercise.version == version; });
  ASSERT_NE(used, course.rows.end());
  EXPECT_TRUE(used->used_up());
  EXPECT_FALSE(CourseModel({*used}).index(0, 0).data(CourseModel::StandingRole).toString().startsWith(QStringLiteral("Due ")));
}

TEST_F(AssignedPractice, WithoutAttemptsLeftGivesWayToTheNextOne) {
  const Assignment first = assign({.version = delivered(), .due_utc_us = kMorning + kHourUs, .attempts_allowed = 1});
  const Assignment second = assign({.version = newer(), .due_utc_us = kMorning + 9 * kHourUs});
  EXPECT_EQ(row().assignment, first.id);
  NewSession wanted{.student = lena.id, .version = first.version, .assignment = first.id};
  wanted.header.device.device_class = "pointer";
  wanted.header.scene = "{}";
  ASSERT_TRUE(records.store().sessions.start(lena.actor(), wanted));
  EXPECT_EQ(row().assignment, second.id);
  EXPECT_EQ(row().exercise.version, second.version) << "an attempt at the first one's version would count for none";
  EXPECT_FALSE(row().attempts_allowed) << "the second one allows any number";
}

}  // namespace
}  // namespace cusp::test
