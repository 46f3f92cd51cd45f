// The editor's messages about figures and checks.

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/check_messages.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/tissues_form.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"

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
       {"no_instrument", "no_target", "path_count", "point_count", "empty_target", "critical_twice", "criterion_unmeasured", "no_criteria", "weight_zero",
        "bands_not_ordered", "pass_unreachable", "protected_missing", "protected_twice", "tissue_missing", "target_outside",
        "voxel_mismatch", "feature_thin", "bur_small", "head_short", "neck_wider_than_ball", "bur_wider_than_target",
        "corner_below_bur", "leeway_below_voxel", "point_off_floor", "target_scores_less", "bands_without_edge", "target_fails", "language_missing",
        "nothing_can_be_cut", "tissue_unused", "target_opens_pulp", "leeway_opens_pulp", "two_spindles",
        "spindle_missing", "heat_missing", "expected_beyond_limit", "tooth_turned", "tooth_tilted", "landmark_outside", "wall_of_other_side", "bur_not_of_number", "bur_short", "ridge_of_plastic", "sides_unknown"}) {
    const QString shown = check_message({Severity::error, "/target", code, {{"value", 1}, {"limit", 2}}, "pulp"});
    EXPECT_TRUE(shown.endsWith(u'.')) << code;
    EXPECT_FALSE(shown.contains(QLatin1String(code))) << code;
    EXPECT_FALSE(shown.startsWith(QStringLiteral("Something is wrong"))) << code;
    EXPECT_FALSE(shown.contains(u'%')) << shown.toStdString();
  }
}

TEST(check_messages, an_expected_time_beyond_the_limit_is_given_with_units) {
  const QString shown = check_message({Severity::warning, "/expected_time_s", "expected_beyond_limit", {{"value", 3900}, {"limit", 1200}}, {}});
  EXPECT_EQ(shown, QStringLiteral("The expected time, %1, is longer than the time limit, %2.").arg(duration_text(3900), duration_text(1200)));
}

TEST(check_messages, a_number_out_of_range_has_a_name_and_a_unit_as_people_write_it) {
  const Finding lean{Severity::error, "/target/parts/1/taper_deg/x_low", "out_of_range", {{"value", 40}, {"least", -30}, {"most", 30}}, {}};
  const QString message = check_message(lean);
  EXPECT_TRUE(message.startsWith(QStringLiteral("The lean of a wall is"))) << message.toStdString();
  EXPECT_TRUE(message.contains(unit_text(QStringLiteral("deg")))) << message.toStdString();
  EXPECT_FALSE(message.contains(QStringLiteral("deg;"))) << message.toStdString();
  const Finding tilt{Severity::error, "/device/tool_tilt_deg", "out_of_range", {{"value", 90}, {"least", -80}, {"most", 80}}, {}};
  EXPECT_TRUE(check_message(tilt).startsWith(QStringLiteral("The tilt of the handpiece is"))) << check_message(tilt).toStdString();
  const Finding turn{Severity::error, "/device/tool_turn_deg", "out_of_range", {{"value", 90}, {"least", 0}, {"most", 60}}, {}};
  EXPECT_TRUE(check_message(turn).startsWith(QStringLiteral("The turn of the handpiece is"))) << check_message(turn).toStdString();
}

TEST(check_messages, a_copy_keeps_the_text_of_its_template_and_a_new_version_its_own) {
  const auto keeps_text_of_template = [](ScenarioId id) {
    EditorStart start;
    start.draft = *load_builtin("channel-1");
    start.draft.id = id;
    EditorModel model(start);
    EXPECT_TRUE(model.set_depth_mm(2.2));
    return std::ranges::find(model.findings(), "text_of_template", &Finding::code) != model.findings().end();
  };
  EXPECT_FALSE(keeps_text_of_template(load_builtin("channel-1")->id));
  EXPECT_TRUE(keeps_text_of_template(ScenarioId::make()));
}

TEST(change_messages, name_the_points_of_an_outline_if_one_moved_along_the_floor) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  ASSERT_TRUE(model.set_depth_mm(2.2));
  const auto points = [&] { return change_messages(start.draft, model.scenario()).contains(QStringLiteral("Points of the outline: changed")); };
  EXPECT_FALSE(points());
  ASSERT_TRUE(model.set_point_mm(0, 0, -2.5, 0.5));
  EXPECT_TRUE(points());
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

TEST(check_messages, and_changes_name_a_tissue_as_the_volume_does) {
  const TissueNames own = {{16, "pulp stone"}};
  EXPECT_TRUE(check_message({Severity::error, "/tissues", "tissue_missing", {}, "16"}, nullptr, own).contains(QStringLiteral("pulp stone")));
  Scenario before = *load_builtin("channel-1");
  before.tissues.push_back({Tissue{16}, 2, 3});
  Scenario after = before;
  after.tissues.back().speed_mm_s = 1;
  const QStringList faster = change_messages(before, after, own);
  ASSERT_EQ(faster.size(), 1);
  EXPECT_TRUE(faster.front().contains(QStringLiteral("pulp stone"))) << faster.front().toStdString();
  EXPECT_TRUE(check_message({Severity::error, "/rubric", "weight_zero", {}, "removed_16"}, nullptr, own).contains(QStringLiteral("pulp stone removed")));
  Scenario graded = before;
  graded.rubric.criteria.push_back({"removed_16", 1, {0, 1, 2, 3, 4, 5}});
  EXPECT_TRUE(change_messages(before, graded, own).join(u'|').contains(QStringLiteral("pulp stone removed")));
  Scenario wider = graded;
  wider.rubric.criteria.back().bands = {0, 1, 2, 4, 5, 6};
  EXPECT_TRUE(change_messages(graded, wider, own).join(u'|').contains(QStringLiteral("pulp stone removed")));
  after.tissues.pop_back();
  EXPECT_FALSE(change_messages(before, after, own).join(u'|').contains(QStringLiteral("pulp stone"))) << "the volume has names of its own tissues alone";
}

}  // namespace
}  // namespace cusp::test
