// The editor's draft without a window: every edit undone and done again, merging, what is refused, checks.

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "engine/volume/voxel_volume.h"
#include "scenarios/library/library.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "ui/editor/check_messages.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/first_bands.h"
#include "ui/editor/target_handles.h"

namespace cusp::test {
namespace {

struct Edit {
  const char* name;
  std::function<bool(EditorModel&)> make;
};

bool change_tooth(EditorModel& model, void (*change)(SpecimenSource&)) {
  SpecimenSource tooth = model.scenario().specimen;
  change(tooth);
  return model.set_tooth(tooth, QStringLiteral("tooth"));
}

const std::vector<Edit>& every_edit() {
  static const std::vector<Edit> edits = {
      {"title", [](EditorModel& m) { return m.set_title("de", QStringLiteral("Anders")); }},
      {"no German title", [](EditorModel& m) { return m.set_title("de", {}); }},
      {"briefing", [](EditorModel& m) { return m.set_briefing("en", QStringLiteral("Cut it.")); }},
      {"level", [](EditorModel& m) { return m.set_level(Level::advanced); }},
      {"no level", [](EditorModel& m) { return m.set_level(std::nullopt); }},
      {"expected time", [](EditorModel& m) { return m.set_expected_time_s(2400); }},
      {"specimen",
       [](EditorModel& m) {
         SpecimenSource s;
         s.generator = "block";
         s.voxel_mm = 0.1;
         return m.set_specimen(s, load_builtin("channel-1")->tissues);
       }},
      {"carious lesion", [](EditorModel& m) { return change_tooth(m, [](SpecimenSource& s) { s.lesions.push_back({"proximal", "mesial", 1.0, 1.2, 0.6}); }); }},
      {"neighbours", [](EditorModel& m) { return change_tooth(m, [](SpecimenSource& s) { s.around = {"neighbours", "gingiva"}; }); }},
      {"shape box", [](EditorModel& m) { return m.set_shape("box"); }},
      {"shape channel", [](EditorModel& m) { return m.set_shape("channel"); }},
      {"depth", [](EditorModel& m) { return m.set_depth_mm(2.1); }},
      {"width", [](EditorModel& m) { return m.set_width_mm(1.5); }},
      {"top", [](EditorModel& m) { return m.set_top_mm(4.0); }},
      {"corner", [](EditorModel& m) { return m.set_corner_radius_mm(0.4); }},
      {"size", [](EditorModel& m) { return m.set_box_size_mm(3, 2); }},
      {"point", [](EditorModel& m) { return m.set_point_mm(0, 0, -3.0, -0.4); }},
      {"add a point", [](EditorModel& m) { return m.add_point(0); }},
      {"remove a point", [](EditorModel& m) { return m.remove_point(0, 1); }},
      {"add a branch", [](EditorModel& m) { return m.add_path(); }},
      {"handle",
       [](EditorModel& m) {
         const Outline& t = m.scenario().target.outline;
         return m.set_outline(moved(t, handles_of(t).front(), {-2.9, -0.4, t.top_mm}), QStringLiteral("handle/0"));
       }},
      {"leeway", [](EditorModel& m) { return m.set_leeway(0.2, 0.25); }},
      {"add a criterion", [](EditorModel& m) { return m.add_criterion("uncut_remainder", first_bands("uncut_remainder", m.scenario().target)); }},
      {"remove a criterion", [](EditorModel& m) { return m.remove_criterion(1); }},
      {"weight", [](EditorModel& m) { return m.set_weight(0, 25); }},
      {"bands", [](EditorModel& m) { return m.set_bands(0, {70, 80, 95, 100, 100, 100}); }},
      {"pass", [](EditorModel& m) { return m.set_pass(80); }},
      {"critical", [](EditorModel& m) { return m.set_critical("pulp_exposure", EditorModel::Listed::no); }},
      {"add a bur", [](EditorModel& m) { return m.add_bur(catalogue_bur("8")->bur); }},
      {"remove a bur", [](EditorModel& m) { return m.remove_bur(0); }},
      {"bur", [](EditorModel& m) { return m.set_bur_radius_mm(1, 0.55); }},
      {"time", [](EditorModel& m) { return m.set_time_limit_s(600); }},
      {"tissue", [](EditorModel& m) { return m.set_tissue_figures(0, 2.5, 0.6); }},
      {"tilt", [](EditorModel& m) { return m.set_tool_tilt_deg(15); }},
      {"turn", [](EditorModel& m) { return m.set_tool_turn_deg(25); }},
      {"handpiece", [](EditorModel& m) { return m.set_handpiece("spindle-electric"); }},
      {"coolant", [](EditorModel& m) { return m.set_phenomenon("heat", EditorModel::Listed::yes); }},
  };
  return edits;
}

TEST(editor_model, every_edit_is_one_step_that_undo_takes_back_and_redo_brings_again) {
  for (const Edit& edit : every_edit()) {
    EditorModel model(class_one());
    const Scenario before = model.scenario();
    ASSERT_TRUE(edit.make(model)) << edit.name;
    const Scenario after = model.scenario();
    EXPECT_FALSE(after == before) << edit.name;
    EXPECT_EQ(model.stack().count(), 1) << edit.name;
    model.stack().undo();
    EXPECT_TRUE(model.scenario() == before) << edit.name;
    model.stack().redo();
    EXPECT_TRUE(model.scenario() == after) << edit.name;
  }
}

TEST(editor_model, undoing_everything_restores_the_exercise_and_redoing_everything_the_draft) {
  EditorModel model(class_one());
  const Scenario before = model.scenario();
  for (const Edit& edit : every_edit()) edit.make(model);
  const Scenario after = model.scenario();
  EXPECT_GT(model.stack().count(), 15);
  while (model.stack().canUndo()) model.stack().undo();
  EXPECT_TRUE(model.scenario() == before);
  EXPECT_TRUE(model.unchanged());
  while (model.stack().canRedo()) model.stack().redo();
  EXPECT_TRUE(model.scenario() == after);
}

TEST(editor_model, turning_a_number_is_one_step_until_it_rests) {
  EditorModel model(class_one());
  const double depth = model.scenario().target.outline.depth_mm;
  for (int i = 1; i <= 10; ++i) model.set_depth_mm(depth + 0.05 * i);
  EXPECT_EQ(model.stack().count(), 1);
  model.end_gesture();
  model.set_depth_mm(depth + 1);
  EXPECT_EQ(model.stack().count(), 2);
  model.set_width_mm(1.4);  // another field never merges
  EXPECT_EQ(model.stack().count(), 3);
  model.stack().undo();
  model.stack().undo();
  EXPECT_DOUBLE_EQ(model.scenario().target.outline.depth_mm, depth + 0.5);
  model.stack().undo();
  EXPECT_TRUE(model.unchanged());
}

TEST(editor_model, a_number_turned_back_to_where_it_was_leaves_no_step) {
  EditorModel model(class_one());
  const double depth = model.scenario().target.outline.depth_mm;
  model.set_depth_mm(depth + 0.05);
  model.set_depth_mm(depth + 0.10);
  model.set_depth_mm(depth);
  EXPECT_EQ(model.stack().count(), 0);
  EXPECT_TRUE(model.unchanged());
}

TEST(editor_model, a_warning_of_the_check_before_publishing_is_shown_and_stands_once) {
  EditorModel model(class_one());
  const std::size_t before = model.findings().size();
  int shown = 0;
  QObject::connect(&model, &EditorModel::changed, &model, [&shown] { ++shown; });
  const Finding warning{Severity::warning, "/rubric/criteria", "token_earns", {{"value", 31}, {"limit", 5}}, {}};
  EXPECT_TRUE(model.prove({warning}));
  EXPECT_EQ(shown, 1);
  EXPECT_TRUE(model.prove({warning})) << "as after Cancel";
  EXPECT_EQ(model.findings().size(), before + 1);
}

TEST(editor_model, what_an_exercise_may_not_hold_is_refused_and_changes_nothing) {
  EditorModel model(class_one());
  const Scenario before = model.scenario();
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 0.0, -1.0, 101.0}) {  // the format admits (0, 100] mm
    EXPECT_FALSE(model.set_depth_mm(bad)) << bad;
    EXPECT_FALSE(model.set_width_mm(bad)) << bad;
    EXPECT_FALSE(model.set_bur_radius_mm(0, bad)) << bad;
    EXPECT_FALSE(model.set_box_size_mm(bad, 5000.0)) << bad;
  }
  for (const double bad : {nan, inf, -1.0, 101.0}) {
    EXPECT_FALSE(model.set_pass(bad)) << bad;
    EXPECT_FALSE(model.set_leeway(bad, 0.3)) << bad;
    EXPECT_FALSE(model.set_tool_turn_deg(bad)) << bad;
  }
  EXPECT_FALSE(model.set_top_mm(nan));
  EXPECT_FALSE(model.set_tool_tilt_deg(nan));
  EXPECT_FALSE(model.set_weight(0, -1));
  EXPECT_FALSE(model.set_weight(99, 1));
  EXPECT_FALSE(model.set_point_mm(0, 0, nan, 0));
  EXPECT_FALSE(model.set_point_mm(0, 99, 0, 0));
  EXPECT_FALSE(model.set_point_mm(99, 0, 0, 0));
  EXPECT_FALSE(model.set_title("en", {}));                                  // English is always there
  EXPECT_FALSE(model.add_bur(model.scenario().instruments.front()));      // a name twice
  EXPECT_FALSE(model.add_criterion("target_removed", {}));                 // a metric twice
  EXPECT_FALSE(model.add_criterion("beauty", {}));                         // no such metric
  EXPECT_FALSE(model.set_shape("banana"));
  EXPECT_FALSE(model.remove_bur(99));
  EXPECT_FALSE(model.remove_criterion(99));
  SpecimenSource wisdom;
  wisdom.generator = "tooth";
  wisdom.fdi = 49;  // no quadrant has a ninth tooth
  EXPECT_FALSE(model.set_specimen(wisdom, before.tissues));
  EXPECT_TRUE(model.scenario() == before);
  EXPECT_EQ(model.stack().count(), 0);
}

TEST(editor_model, a_target_keeps_at_least_one_line) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_shape("channel"));
  ASSERT_TRUE(model.set_shape("outline"));
  EXPECT_FALSE(model.remove_point(0, 0));
  ASSERT_TRUE(model.add_path());
  EXPECT_TRUE(model.remove_point(1, 0));  // the branch goes as a whole
  EXPECT_EQ(model.scenario().target.outline.paths.size(), 1u);
}

TEST(editor_model, points_stay_on_the_floor_and_bands_of_depth_move_with_it) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_depth_mm(2.3));
  const Scenario& s = model.scenario();
  for (const auto& path : s.target.outline.paths) {
    for (const Vec3& p : path) EXPECT_DOUBLE_EQ(p.z, 1.9);  // 4.2 - 2.3
  }
  for (const Criterion& c : s.rubric.criteria) {
    // 1.8 -> 2.3: the mean's full band 1.65 to 1.95 becomes 2.15 to 2.45; the deepest's open side stays open.
    if (c.metric == "depth_mean") {
      EXPECT_DOUBLE_EQ(c.bands.ideal_lo, 2.15);
      EXPECT_DOUBLE_EQ(c.bands.ideal_hi, 2.45);
    }
    if (c.metric == "depth_most") {
      EXPECT_DOUBLE_EQ(c.bands.ideal_lo, 0);
      EXPECT_DOUBLE_EQ(c.bands.ideal_hi, 2.6);
    }
  }
  for (const Finding& f : model.findings()) EXPECT_NE(f.code, "target_scores_less");
}

TEST(editor_model, a_shape_made_from_another_keeps_place_and_depth) {
  EditorModel model(class_one());
  const Outline before = model.scenario().target.outline;
  for (const char* shape : {"box", "channel", "outline", "box", "outline"}) {
    ASSERT_TRUE(model.set_shape(shape)) << shape;
    const Outline& t = model.scenario().target.outline;
    EXPECT_EQ(t.shape, shape);
    EXPECT_DOUBLE_EQ(t.depth_mm, before.depth_mm);
    EXPECT_DOUBLE_EQ(t.top_mm, before.top_mm);
    model.set_facts(facts_of_36());
    EXPECT_FALSE(has_error(model.findings())) << shape << ": " << check_message(model.findings().front()).toStdString();
  }
}

TEST(editor_model, publishing_waits_for_a_change_the_tooth_and_every_check) {
  EditorModel model(class_one());
  EXPECT_EQ(model.standing(), EditorModel::Standing::unchanged);
  model.set_depth_mm(2.0);
  EXPECT_EQ(model.standing(), EditorModel::Standing::unproved);
  model.set_facts(facts_of_36());
  EXPECT_TRUE(model.publishable());
  model.set_top_mm(-20);
  EXPECT_EQ(model.standing(), EditorModel::Standing::failing);
  EXPECT_EQ(model.findings().front().code, "target_outside");
  EXPECT_EQ(place_of(model.findings().front()), EditorPlace::shape);
  model.stack().undo();
  EXPECT_TRUE(model.publishable());
  while (!model.scenario().instruments.empty()) model.remove_bur(0);
  EXPECT_EQ(model.standing(), EditorModel::Standing::failing);
  EXPECT_EQ(place_of(model.findings().front()), EditorPlace::burs);
}

TEST(editor_model, what_does_not_pass_the_check_before_publishing_can_be_tried_out) {
  EditorModel model(class_one());
  model.set_facts(facts_of_36());
  ASSERT_TRUE(model.set_pass(80));
  EXPECT_TRUE(model.playable());
  EXPECT_FALSE(model.prove({{Severity::error, "/rubric/pass", "target_fails", {{"value", 60}, {"limit", 80}}, {}}}));
  EXPECT_FALSE(model.publishable());
  EXPECT_TRUE(model.playable()) << "the operators' report shows which criteria cost the points";
  while (!model.scenario().instruments.empty()) model.remove_bur(0);
  EXPECT_FALSE(model.playable());
}

TEST(editor_model, a_finding_about_the_figures_of_tissues_leads_to_them) {
  EditorModel model(class_one());
  for (std::size_t i = 0; i < model.scenario().tissues.size(); ++i) ASSERT_TRUE(model.set_tissue_figures(i, 1, 0));
  const auto none = std::ranges::find(model.findings(), "nothing_can_be_cut", &Finding::code);
  ASSERT_NE(none, model.findings().end());
  EXPECT_EQ(place_of(*none), EditorPlace::tissues);
  ASSERT_TRUE(model.set_tissue_figures(0, 0.01, 1));  // as a file may state it
  ASSERT_EQ(model.findings().front().code, "out_of_range");
  EXPECT_EQ(place_of(model.findings().front()), EditorPlace::tissues);
  EXPECT_EQ(place_of({Severity::error, "/tissues", "tissue_missing", {}, "pulp"}), EditorPlace::tooth);
}

TEST(editor_model, a_block_has_no_pulp_to_protect_or_to_open) {
  EditorModel model(class_one());
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.1;
  ASSERT_TRUE(model.set_specimen(block, load_builtin("channel-1")->tissues));
  EXPECT_TRUE(model.scenario().protected_parts.empty());
  EXPECT_TRUE(model.scenario().rubric.critical.empty());
}

TEST(editor_model, a_target_that_opens_a_pulp_that_must_stay_closed_is_never_published) {
  EditorModel model(class_one());
  const Vec3 on_line = model.scenario().target.outline.paths[0][4];  // (0.2, -0.15), floor at 2.4
  model.set_facts(facts_of_36(), {{on_line.x, on_line.y, 1.5}});
  EXPECT_TRUE(model.findings().empty());
  // The briefing still names the depth of before: these are other findings.
  const auto of_the_pulp = [&model] {
    std::vector<Finding> out;
    for (const Finding& finding : model.findings())
      if (finding.code.ends_with("opens_pulp")) out.push_back(finding);
    return out;
  };
  ASSERT_TRUE(model.set_depth_mm(2.5));  // floor 1.7, leeway down to 1.4
  ASSERT_EQ(of_the_pulp().size(), 1u);
  EXPECT_EQ(of_the_pulp()[0].code, "leeway_opens_pulp");
  EXPECT_NEAR(of_the_pulp()[0].args.at("value"), 0.2, 1e-9);
  EXPECT_TRUE(model.publishable());
  ASSERT_TRUE(model.set_depth_mm(2.8));  // floor 1.4
  ASSERT_EQ(of_the_pulp().size(), 1u);
  EXPECT_EQ(of_the_pulp()[0].code, "target_opens_pulp");
  EXPECT_FALSE(model.publishable());
  ASSERT_TRUE(model.set_critical("pulp_exposure", EditorModel::Listed::no));  // as where the pulp is to be reached
  EXPECT_TRUE(model.publishable());
}

TEST(editor_model, a_handpiece_brings_what_needs_one_and_takes_it_along_and_coolant_what_is_graded_of_it) {
  EditorModel model(class_one());
  EXPECT_TRUE(model.set_handpiece("spindle-turbine"));
  EXPECT_TRUE(model.set_phenomenon("vibration", EditorModel::Listed::yes));
  EXPECT_TRUE(model.set_phenomenon("heat", EditorModel::Listed::yes));
  EXPECT_TRUE(model.set_critical("dry_cutting", EditorModel::Listed::yes));
  EXPECT_EQ(model.scenario().phenomena, (std::vector<std::string>{"spindle-turbine", "vibration", "heat"}));
  EXPECT_TRUE(model.set_handpiece("spindle-slow"));
  EXPECT_EQ(model.scenario().phenomena, (std::vector<std::string>{"spindle-slow", "vibration", "heat"}));
  EXPECT_FALSE(model.set_handpiece("spindle-pedalled")) << "no key of the format";
  EXPECT_FALSE(model.set_phenomenon("magic", EditorModel::Listed::yes));
  EXPECT_TRUE(model.set_handpiece(""));
  EXPECT_EQ(model.scenario().phenomena, std::vector<std::string>{"heat"});
  EXPECT_TRUE(model.set_phenomenon("heat", EditorModel::Listed::no));
  EXPECT_EQ(model.scenario().rubric.critical, std::vector<std::string>{"pulp_exposure"});
  while (model.stack().canUndo()) model.stack().undo();
  EXPECT_EQ(model.scenario(), class_one().draft);
}

TEST(editor_model, a_bur_of_another_size_takes_the_number_of_that_size_or_a_name_by_its_diameter) {
  EditorStart start = class_one();
  auto& burs = start.draft.instruments;
  burs = {catalogue_bur("2")->bur, catalogue_bur("4")->bur, catalogue_bur("4")->bur};
  burs[2].name = "Dr. Weber's";
  EditorModel model(start);
  const auto names = [&] {
    std::vector<std::string> out;
    for (const Bur& bur : model.scenario().instruments) out.push_back(bur.name);
    return out;
  };
  using Names = std::vector<std::string>;
  ASSERT_TRUE(model.set_bur_radius_mm(0, 0.55));
  EXPECT_EQ(names(), (Names{"Ø 1.1", "4", "Dr. Weber's"}));
  ASSERT_TRUE(model.set_bur_radius_mm(0, 0.9));
  EXPECT_EQ(model.scenario().instruments[0], catalogue_bur("6")->bur);
  ASSERT_TRUE(model.set_bur_radius_mm(0, 0.7));
  EXPECT_EQ(names(), (Names{"Ø 1.4", "4", "Dr. Weber's"})) << "one of each number";
  ASSERT_TRUE(model.set_bur_radius_mm(1, 0.55));
  ASSERT_TRUE(model.set_bur_radius_mm(0, 0.55));
  EXPECT_EQ(names(), (Names{"Ø 1.1 (2)", "Ø 1.1", "Dr. Weber's"}));
  ASSERT_TRUE(model.set_bur_radius_mm(2, 0.55));
  EXPECT_EQ(names().back(), "Dr. Weber's");
  while (model.stack().canUndo()) model.stack().undo();
  EXPECT_EQ(model.scenario(), start.draft);
}

}  // namespace
}  // namespace cusp::test
