// Exercises, standing, and charts as plain data.

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/course.h"
#include "ui/student/history_charts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

using test::DeskRecords;

TEST(Exercises, those_that_come_with_the_program_are_there_in_an_empty_database) {
  DeskRecords records;
  const auto list = load_exercises(records.store());
  ASSERT_TRUE(list.has_value());
  ASSERT_EQ(list->exercises.size(), builtin_scenarios().size());
  for (const Exercise& e : list->exercises) EXPECT_TRUE(e.version.is_nil());
}

TEST(Exercises, a_newer_version_published_here_takes_the_place_of_the_built_in_one) {
  DeskRecords records;
  Scenario changed = *load_builtin(builtin_scenarios().front());
  changed.version += 1;
  changed.target.outline.depth_mm += 0.1;
  ASSERT_TRUE(records.store().scenarios.ensure(changed, canonical_json(changed), content_hash(changed).bytes));
  const auto list = load_exercises(records.store());
  ASSERT_TRUE(list.has_value());
  EXPECT_EQ(list->exercises.size(), builtin_scenarios().size());
  const Exercise* found = list->find(changed.id);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->scenario, changed);
  EXPECT_FALSE(found->version.is_nil());
}

TEST(HistoryCharts, the_pass_mark_lies_on_the_axis) {
  HistoryRow row;
  row.score = 80;
  row.pass_mark = 30;
  EXPECT_LE(time_and_score({row}).y.least, 30);
}

TEST(Course, the_next_exercise_is_the_first_that_was_not_passed_yet) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  auto course = load_course(records.store(), lena.actor());
  ASSERT_TRUE(course.has_value());
  EXPECT_EQ(course->next(), 0);
  EXPECT_FALSE(course->last_graded);

  const std::string first(builtin_scenarios()[0]);
  records.attempt(lena, first, 55, 300);
  course = load_course(records.store(), lena.actor());
  EXPECT_EQ(course->next(), 0);  // not passed
  records.attempt(lena, first, 82, 280);
  course = load_course(records.store(), lena.actor());
  EXPECT_EQ(course->next(), 1);
  EXPECT_EQ(course->rows[0].attempts, 2);
  ASSERT_TRUE(course->rows[0].best.has_value());
  EXPECT_DOUBLE_EQ(*course->rows[0].best->score, 82);
}

TEST(Course, a_student_sees_no_one_elses_attempts) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt"), noah = records.student("2", "Noah Adler");
  records.attempt(noah, "channel-1", 90, 100);
  const auto course = load_course(records.store(), lena.actor());
  ASSERT_TRUE(course.has_value());
  EXPECT_FALSE(course->last_graded);
  EXPECT_TRUE(course->charted.empty());
}

TEST(CourseModel, shows_what_is_missing_as_text_not_as_zero) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 300);
  const auto course = load_course(records.store(), lena.actor());
  const CourseModel model(course->rows);
  for (int row = 0; row < model.rowCount(); ++row) {
    const bool drilled = model.row(row).exercise.scenario.key == "channel-1";
    EXPECT_EQ(model.index(row, CourseModel::kBest).data().toString().toStdString(), drilled ? "78" : "none yet");
    EXPECT_EQ(model.index(row, CourseModel::kAttempts).data().toString().toStdString(), drilled ? "1" : "0");
  }
}

TEST(AttemptsModel, has_a_line_an_attempt_with_result_and_state) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 300);
  records.attempt(lena, "channel-1", 40, 200);
  records.broken_attempt(lena, "channel-1");
  const auto rows = records.store().history.list(lena.actor());
  ASSERT_TRUE(rows.has_value());
  AttemptsModel model;
  model.set_rows(*rows);
  ASSERT_EQ(model.rowCount(), 3);
  const auto text = [&](int row, int column) { return model.index(row, column).data().toString().toStdString(); };
  EXPECT_EQ(text(0, AttemptsModel::kResult), "Interrupted");
  EXPECT_EQ(text(0, AttemptsModel::kScore), "–");
  EXPECT_EQ(text(1, AttemptsModel::kResult), "Not passed");
  EXPECT_EQ(text(2, AttemptsModel::kResult), "Passed");
  EXPECT_EQ(text(2, AttemptsModel::kScore), "78");
  EXPECT_EQ(text(2, AttemptsModel::kAttempt), "1");
  EXPECT_TRUE(model.index(2, AttemptsModel::kTime).data().toString().contains(QStringLiteral("5:00")));
  EXPECT_LT(model.index(0, AttemptsModel::kScore).data(SortRole).toDouble(), 0);
}

TEST(Course, the_charted_attempts_are_graded_ones_of_one_exercise_and_one_device_class) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId first = records.attempt(lena, "channel-1", 60, 300);
  records.attempt(lena, "channel-1", 70, 300, "falcon");
  records.attempt(lena, "paper-block", 80, 300);
  records.broken_attempt(lena, "channel-1");
  const SessionId last = records.attempt(lena, "channel-1", 90, 300);
  const SessionId broken = records.broken_attempt(lena, "paper-block");
  const auto course = load_course(records.store(), lena.actor());
  ASSERT_TRUE(course && course->last_graded);
  EXPECT_EQ(course->last_graded->session, last);
  ASSERT_EQ(course->interrupted.size(), 1u) << "of practice the newest";
  EXPECT_EQ(course->interrupted[0].session, broken);
  ASSERT_EQ(course->charted.size(), 2u);
  EXPECT_EQ(course->charted[0].session, last);
  EXPECT_EQ(course->charted[1].session, first);
}

TEST(AttemptsModel, fetches_the_next_page_when_asked_and_stops_after_the_last_and_after_a_failure) {
  const auto rows = [](int n) { return std::vector<HistoryRow>(static_cast<std::size_t>(n)); };
  AttemptsModel model;
  std::vector<std::int64_t> asked;
  model.set_pages({rows(3), HistoryKey{5}}, [&](const HistoryKey& after) -> std::optional<HistoryPage> {
    asked.push_back(after.started_utc_us);
    if (asked.size() == 1) return HistoryPage{rows(2), HistoryKey{4}};
    return HistoryPage{rows(1), std::nullopt};
  });
  EXPECT_EQ(model.rowCount(), 3);
  while (model.canFetchMore()) model.fetchMore();
  EXPECT_EQ(model.rowCount(), 6);
  EXPECT_EQ(asked, (std::vector<std::int64_t>{5, 4}));
  model.set_pages({rows(3), HistoryKey{5}}, [](const HistoryKey&) { return std::optional<HistoryPage>{}; });
  model.fetchMore();
  EXPECT_EQ(model.rowCount(), 3);
  EXPECT_FALSE(model.canFetchMore());
  EXPECT_TRUE(model.failed());
  model.set_rows(rows(1));
  EXPECT_FALSE(model.failed()) << "these are all";
}

TEST(AttemptsModel, asks_again_for_the_page_that_failed) {
  const auto rows = [](int n) { return std::vector<HistoryRow>(static_cast<std::size_t>(n)); };
  AttemptsModel model;
  std::vector<std::int64_t> asked;
  model.set_pages({rows(3), HistoryKey{5}}, [&](const HistoryKey& after) -> std::optional<HistoryPage> {
    asked.push_back(after.started_utc_us);
    if (asked.size() == 1) return std::nullopt;
    return HistoryPage{rows(2), HistoryKey{4}};
  });
  model.fetchMore();
  model.fetchMore();
  EXPECT_EQ(asked.size(), 1u) << "a list that scrolls asks no more";
  model.fetch_again();
  EXPECT_EQ(asked, (std::vector<std::int64_t>{5, 5}));
  EXPECT_EQ(model.rowCount(), 5);
  EXPECT_FALSE(model.failed());
  EXPECT_TRUE(model.canFetchMore());
}

TEST(AttemptsModel, shows_the_points_of_every_row_with_the_same_decimals_also_once_a_later_page_needs_them) {
  const auto rows = [](std::initializer_list<double> scores) {
    std::vector<HistoryRow> out(1);  // one without a result
    for (const double score : scores) out.emplace_back().score = score;
    return out;
  };
  AttemptsModel model;
  model.set_pages({rows({81, 7}), HistoryKey{5}}, [&](const HistoryKey&) { return std::optional(HistoryPage{rows({66.7}), std::nullopt}); });
  const auto shown = [&](int row) { return model.index(row, AttemptsModel::kScore).data().toString().toStdString(); };
  EXPECT_EQ(shown(1), "81");
  QSignalSpy changed(&model, &AttemptsModel::dataChanged);
  model.fetchMore();
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(shown(0), "–");
  EXPECT_EQ(shown(1), "81.0");
  EXPECT_EQ(shown(2), "7.0");
  EXPECT_EQ(shown(4), "66.7");
}

TEST(HistoryCharts, the_newest_attempt_is_the_strong_point_and_the_axes_hold_every_attempt) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  for (const auto& [score, seconds] : {std::pair{54.0, 744.0}, {61.0, 640.0}, {78.0, 426.0}}) {
    records.attempt(lena, "channel-1", score, seconds);
  }
  const auto rows = records.store().history.list(lena.actor());
  const ChartData chart = time_and_score(*rows);
  ASSERT_EQ(chart.series.size(), 1);
  ASSERT_EQ(chart.series[0].points.size(), 3);
  EXPECT_TRUE(chart.series[0].points.last().strong);
  EXPECT_DOUBLE_EQ(chart.series[0].points.last().y, 78);
  EXPECT_NEAR(chart.series[0].points.last().x, 7.1, 1e-6);  // 426 s in minutes
  EXPECT_EQ(chart.mark, 70.0);
  for (const ChartPoint& p : chart.series[0].points) {
    EXPECT_GE(p.x, chart.x.least);
    EXPECT_LE(p.x, chart.x.most);
    EXPECT_GE(p.y, chart.y.least);
    EXPECT_LE(p.y, chart.y.most);
  }
  EXPECT_EQ(score_by_attempt(*rows).series[0].points.last().x, 3.0);
}

TEST(HistoryCharts, attempts_of_one_time_stand_in_the_order_in_which_they_began) {
  // As History::list() gives them, the newest first: on one station at a time that a clock set back has twice.
  HistoryRow first, second;
  first.started_utc_us = second.started_utc_us = 1'790'000'000'000'000;
  first.sequence = 7;
  first.attempt = 1;
  first.score = 54;
  second.sequence = 9;
  second.attempt = 2;
  second.score = 78;
  for (const ChartData& chart : {time_and_score({second, first}), score_by_attempt({second, first})}) {
    ASSERT_EQ(chart.series[0].points.size(), 2);
    EXPECT_DOUBLE_EQ(chart.series[0].points[0].y, 54);
    EXPECT_DOUBLE_EQ(chart.series[0].points[1].y, 78);
    EXPECT_TRUE(chart.series[0].points[1].strong);
    EXPECT_TRUE(chart.summary.contains(QStringLiteral("78"))) << chart.summary.toStdString();
  }
}

TEST(HistoryCharts, an_attempt_stands_above_the_number_that_the_table_gives_it) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 54, 744);
  records.broken_attempt(lena, "channel-1");
  records.attempt(lena, "channel-1", 61, 640, "falcon");
  records.attempt(lena, "channel-1", 78, 426);
  HistoryFilter pointer;
  pointer.device_class = "pointer";
  const ChartData chart = score_by_attempt(*records.store().history.list(lena.actor(), pointer));
  ASSERT_EQ(chart.series[0].points.size(), 2);
  EXPECT_EQ(chart.series[0].points[0].x, 1.0);
  EXPECT_EQ(chart.series[0].points[1].x, 4.0);
  EXPECT_GT(chart.x.most, 4.0);
}

TEST(HistoryCharts, the_axis_of_attempts_counts_from_the_first_one) {
  const auto chart = [](int attempts) {
    std::vector<HistoryRow> rows(static_cast<std::size_t>(attempts));
    for (int i = 0; i < attempts; ++i) {
      rows[static_cast<std::size_t>(i)].attempt = rows[static_cast<std::size_t>(i)].sequence = i + 1;
      rows[static_cast<std::size_t>(i)].score = 50 + i % 40;
    }
    return score_by_attempt(rows);
  };
  for (const int attempts : {1, 4, 10, 11, 20, 200}) {
    const ChartAxis x = chart(attempts).x;
    EXPECT_EQ(x.least, attempts > 20 ? 0 : 1) << attempts;
    EXPECT_GT(x.most, attempts) << attempts;
    EXPECT_LE((x.most - x.least) / x.step, 12) << attempts << ": figures that do not meet";
  }
  EXPECT_EQ(chart(60).series[0].draw, ChartSeries::Draw::line_dots);
  EXPECT_EQ(chart(200).series[0].draw, ChartSeries::Draw::dots) << "lines and rings would run into one band";
}

TEST(HistoryCharts, the_summary_has_the_last_and_the_best_points_and_the_pass_mark) {
  HistoryRow best, last;
  best.sequence = 1;
  last.sequence = 2;
  best.score = 83.4;
  last.score = 1;
  best.pass_mark = last.pass_mark = 70;
  EXPECT_EQ(score_by_attempt({last, best}).summary, QStringLiteral("Attempts: 2. The last has 1 of 100 points. The best has 83.4. The pass mark is 70."));
  EXPECT_EQ(score_by_attempt({last}).summary, QStringLiteral("Attempts: 1. The last has 1 of 100 points. The pass mark is 70."));
}

TEST(HistoryCharts, one_point_is_said_in_the_singular) {
  for (const ChartData& chart : {time_and_score({}), score_by_attempt({}), own_against_measured({})}) {
    ASSERT_NE(chart.value_text, nullptr) << chart.title.toStdString();
    EXPECT_EQ(chart.value_text(1), QStringLiteral("1 point"));
    EXPECT_EQ(chart.value_text(1.5), QStringLiteral("1.5 points"));
    EXPECT_EQ(chart.value_text(0), QStringLiteral("0 points"));
    EXPECT_EQ(chart.value_text(-1), QStringLiteral("\u22121 point"));
  }
}

TEST(HistoryCharts, without_an_attempt_there_is_nothing_to_draw) {
  EXPECT_TRUE(time_and_score({}).series[0].points.isEmpty());
  EXPECT_TRUE(score_by_attempt({}).summary.isEmpty());
}

TEST(Course, an_exercise_that_was_passed_is_not_next_after_an_attempt_with_more_points_that_fails) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const std::string first(builtin_scenarios()[0]);
  records.attempt(lena, first, 78, 300);
  Grade opened_pulp = sample_grade(92);
  opened_pulp.critical = {"pulp_exposure"};
  opened_pulp.passed = false;
  records.graded_attempt(lena, first, opened_pulp, 300);
  const auto course = load_course(records.store(), lena.actor());
  ASSERT_TRUE(course);
  EXPECT_EQ(course->next(), 1);
  const CourseModel model(course->rows);
  EXPECT_TRUE(model.index(0, CourseModel::kExercise).data(CourseModel::PassedRole).toBool());
}

}  // namespace
}  // namespace cusp::test
