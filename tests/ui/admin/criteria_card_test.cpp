// What the card of criteria says of its figures, alone and on the performance page.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QTemporaryDir>
#include <filesystem>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "tests/ui/published_block.h"
#include "ui/admin/criteria_card.h"
#include "ui/admin/performance.h"
#include "ui/text/grade_text.h"

namespace cusp::test {
namespace {

TEST(CriteriaCard, with_full_points_in_all_attempts_but_one_are_not_100_percent) {
  CriterionFiguresModel model;
  model.set_rows({{.id = "floor_depth_max", .attempts = 400, .full = 399, .mean_share = 0.99}, {.id = "target_removed", .attempts = 400, .full = 1, .mean_share = 0.5}}, {}, {});
  const auto full = [&](int row) { return plain_text(model.index(row, CriterionFiguresModel::kFull).data().toString()); };
  EXPECT_EQ(full(0), "99 %");
  EXPECT_EQ(full(1), "1 %");
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

TEST_F(AdminPages, performance_names_a_tissue_among_the_criteria_as_the_volume_does) {
  const QTemporaryDir cache;
  const std::filesystem::path folder = cache.path().toStdString();
  Grade grade = sample_grade(60);
  grade.criteria.resize(1);
  grade.criteria[0].id = "removed_16";
  records.graded_attempt(records.student("1", "Lena Brandt"), "channel-1", grade, 100);
  const Actor author = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
  ASSERT_NO_FATAL_FAILURE(publish_named_block(records.store(), author, folder));
  Performance page(records.store(), records.administrator().actor(), ports, folder);
  page.show();
  page.exercise()->setCurrentIndex(1);
  const CriterionFiguresModel& model = page.criteria()->model();
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(model.index(0, CriterionFiguresModel::kName).data().toString().toStdString(), "pulp stone removed");
}

}  // namespace
}  // namespace cusp::test
