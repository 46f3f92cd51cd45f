// The editor's messages about figures and checks.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/check_messages.h"
#include "ui/editor/tissues_form.h"
#include "ui/text/grade_text.h"

namespace cusp::test {
namespace {

TEST(tissues_form, a_figure_that_is_not_verified_or_was_set_here_shows_it) {
  EXPECT_EQ(figure_note(3, {3, "M", false}), QStringLiteral("usual, not verified"));
  EXPECT_EQ(figure_note(0.5, {0.5, "paper", true}), QStringLiteral("usual, from the published method"));
  EXPECT_TRUE(figure_note(2.1, {2.1, "chun-2014", true}).contains(QStringLiteral("Chun 2014")));
  EXPECT_EQ(figure_note(2.2, {2.1, "chun-2014", true}), QStringLiteral("set for this exercise"));
}

TEST(check_messages, every_code_of_the_checks_has_a_message) {
  for (const char* code :
       {"no_instrument", "no_target", "path_count", "point_count", "empty_target", "no_criteria", "weight_zero",
        "bands_not_ordered", "pass_unreachable", "protected_missing", "tissue_missing", "target_outside",
        "voxel_mismatch", "feature_thin", "bur_small", "head_short", "neck_wider_than_ball", "bur_wider_than_target",
        "corner_below_bur", "leeway_below_voxel", "point_off_floor", "target_scores_less", "language_missing",
        "nothing_can_be_cut", "tissue_unused", "target_opens_pulp", "leeway_opens_pulp", "two_spindles",
        "spindle_missing", "heat_missing", "expected_beyond_limit", "tooth_turned", "tooth_tilted", "landmark_outside"}) {
    const QString shown = check_message({Severity::error, "/target", code, {{"value", 1}, {"limit", 2}}, "pulp"});
    EXPECT_TRUE(shown.endsWith(u'.')) << code;
    EXPECT_FALSE(shown.contains(QLatin1String(code))) << code;
    EXPECT_FALSE(shown.startsWith(QStringLiteral("Something is wrong"))) << code;
    EXPECT_FALSE(shown.contains(u'%')) << shown.toStdString();
  }
}

TEST(check_messages, and_changes_name_one_of_several_targets_by_its_title) {
  const Scenario exercise = *load_builtin("class-1-16");
  const QString named = metric_name("depth_mean@mesial", &exercise.target);
  EXPECT_NE(named, metric_name("depth_mean@mesial"));
  EXPECT_TRUE(check_message({Severity::error, "/rubric", "weight_zero", {}, "depth_mean@mesial"}, &exercise.target).contains(named));
  Scenario lighter = exercise;
  std::ranges::find(lighter.rubric.criteria, "depth_mean@mesial", &Criterion::metric)->weight += 1;
  ASSERT_EQ(change_messages(exercise, lighter).size(), 1);
  EXPECT_TRUE(change_messages(exercise, lighter).front().contains(named));
}

}  // namespace
}  // namespace cusp::test
