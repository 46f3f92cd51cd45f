// What the editor protects as the tooth changes, and the rules that go with it.

#include <gtest/gtest.h>

#include <QCheckBox>
#include <algorithm>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/templates/templates.h"
#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/points_form.h"
#include "ui/editor/specimen_grower.h"

namespace cusp::test {
namespace {

/// A class I that an author has on a block, and the tooth that is to be its specimen, in coarse voxels.
EditorStart class_one_on_a_block(double depth_mm, double width_mm) {
  EditorStart start = class_one();
  Scenario& s = start.draft;
  const Scenario block = load_builtin("channel-1").value();
  s.specimen = block.specimen;
  s.tissues = block.tissues;
  s.protected_parts.clear();
  s.rubric.critical.clear();
  s.target.outline.depth_mm = depth_mm;
  s.target.outline.width_mm = width_mm;
  settle_on_floor(s.target.outline);
  return start;
}
SpecimenSource coarse_36() {
  SpecimenSource tooth = class_one().draft.specimen;
  tooth.voxel_mm = 0.2;
  return tooth;
}
/// As the grower hands it over.
void bring_the_tooth(EditorModel& model) {
  static const VoxelVolume volume = make_specimen(coarse_36(), {}).value();
  model.set_facts(facts_of(volume), {}, Specimen::build(volume, reading_of(model.scenario().method)));
}

TEST(editor_model, a_tooth_with_pulp_brings_the_rule_that_opening_it_fails_the_attempt_and_undo_takes_both) {
  const EditorStart start = class_one_on_a_block(1.8, 1.0);
  for (const bool by_form : {false, true}) {
    EditorModel model(start);
    ASSERT_TRUE(by_form ? model.set_tooth(coarse_36(), QStringLiteral("fdi"))
                        : model.set_specimen(coarse_36(), usual_tissues(std::string("tooth"))));
    EXPECT_EQ(model.scenario().rubric.critical, std::vector<std::string>{"pulp_exposure"});
    EXPECT_EQ(model.scenario().protected_parts, std::vector<Protected>{Tissue::pulp});
    bring_the_tooth(model);
    EXPECT_EQ(model.scenario().rubric.critical, std::vector<std::string>{"pulp_exposure"}) << "no pulp in the target";
    ASSERT_EQ(model.stack().count(), 1);
    model.stack().undo();
    EXPECT_EQ(model.scenario(), start.draft);
  }
}

TEST(editor_model, an_access_to_the_pulp_keeps_its_rule_off_and_undo_is_still_one_step) {
  const EditorStart start = class_one_on_a_block(5.5, 3.0);
  EditorModel model(start);
  ASSERT_TRUE(model.set_specimen(coarse_36(), usual_tissues(std::string("tooth"))));
  model.end_gesture();
  bring_the_tooth(model);
  EXPECT_TRUE(model.scenario().rubric.critical.empty());
  EXPECT_TRUE(std::ranges::any_of(model.findings(), [](const Finding& f) { return f.code == "target_holds_pulp"; }));
  ASSERT_EQ(model.stack().count(), 1);
  model.stack().undo();
  EXPECT_EQ(model.scenario(), start.draft);
  model.stack().redo();
  EXPECT_TRUE(model.scenario().rubric.critical.empty());
}

TEST(editor_model, a_rule_that_the_author_switched_off_stays_off_when_the_tooth_changes) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_critical("pulp_exposure", EditorModel::Listed::no));
  SpecimenSource other = model.scenario().specimen;
  other.fdi = 46;
  ASSERT_TRUE(model.set_tooth(other, QStringLiteral("fdi")));
  EXPECT_TRUE(model.scenario().rubric.critical.empty());
}

TEST(editor_model, neighbours_that_go_take_their_protection_along_and_the_last_one_its_rule) {
  EditorStart start;
  start.draft = load_builtin("class-2-46-mo").value();
  ASSERT_EQ(start.draft.protected_parts.size(), 3u) << "pulp, and both tissues of the neighbours";
  EditorModel model(start);
  const auto blames_what_is_gone = [&] {
    return std::ranges::any_of(model.findings(), [](const Finding& f) {
      return f.code == "target_tissue_missing" || f.code == "protected_missing" || f.code == "nothing_protected";
    });
  };
  ASSERT_FALSE(blames_what_is_gone());
  SpecimenSource tooth = start.draft.specimen;
  tooth.around = {"gingiva"};
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("around")));
  model.end_gesture();
  EXPECT_EQ(model.scenario().protected_parts, std::vector<Protected>{Tissue::pulp});
  EXPECT_FALSE(blames_what_is_gone());
  tooth.typodont = true;
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("plastic")));
  EXPECT_TRUE(model.scenario().rubric.critical.empty());
  EXPECT_FALSE(blames_what_is_gone());
  model.stack().undo();
  model.stack().undo();
  EXPECT_EQ(model.scenario(), start.draft);
}

/// One click in the form of the tooth.
bool stand_round(EditorModel& model, const std::vector<std::string>& around) {
  SpecimenSource tooth = model.scenario().specimen;
  tooth.around = around;
  model.end_gesture();
  return model.set_tooth(tooth, QStringLiteral("around"));
}

TEST(editor_model, neighbours_that_come_back_are_protected_as_they_were) {
  EditorStart start;
  start.draft = load_builtin("class-2-46-mo").value();
  start.draft.protected_parts[1].depth_mm = 0.1;
  for (const bool ruled : {true, false}) {
    if (!ruled) std::erase(start.draft.rubric.critical, "protected_damage");
    EditorModel model(start);
    const std::vector<std::string> around = start.draft.specimen.around;
    ASSERT_TRUE(stand_round(model, {"gingiva"}));
    ASSERT_EQ(model.scenario().protected_parts.size(), 1u);
    ASSERT_TRUE(stand_round(model, around));
    EXPECT_EQ(model.scenario().protected_parts, start.draft.protected_parts);
    EXPECT_EQ(model.scenario().rubric, start.draft.rubric);
    model.stack().undo();
    EXPECT_EQ(model.scenario().protected_parts.size(), 1u);
    model.stack().redo();
    EXPECT_EQ(model.scenario().protected_parts, start.draft.protected_parts);
  }
}

TEST(editor_model, a_plastic_tooth_that_is_natural_again_has_its_protection_and_its_rules) {
  EditorStart start;
  start.draft = load_builtin("class-2-46-mo").value();
  start.draft.protected_parts[0].severity = Damage::touch;
  EditorModel model(start);
  SpecimenSource tooth = start.draft.specimen;
  tooth.typodont = true;
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("plastic")));
  model.end_gesture();
  ASSERT_TRUE(model.scenario().protected_parts.empty());
  ASSERT_TRUE(model.set_tooth(start.draft.specimen, QStringLiteral("plastic")));
  EXPECT_EQ(model.scenario().protected_parts, start.draft.protected_parts);
  EXPECT_EQ(model.scenario().rubric.critical, start.draft.rubric.critical);
}

TEST(editor_model, neighbours_of_an_exercise_that_had_none_are_protected_as_in_a_new_exercise) {
  const Scenario fresh = fit_template({.key = "class-2-adhesive", .fdi = 36, .id = ScenarioId::make()}).value();
  EditorModel model(class_one());
  ASSERT_TRUE(stand_round(model, {"neighbours"}));
  EXPECT_EQ(model.scenario().protected_parts, fresh.protected_parts);
  EXPECT_EQ(model.scenario().rubric.critical, (std::vector<std::string>{"pulp_exposure", "protected_damage"}));
  model.stack().undo();
  EXPECT_EQ(model.scenario(), class_one().draft);
}

TEST(editor_model, pulp_that_is_protected_as_a_region_is_not_protected_once_more) {
  EditorStart start = class_one();
  Region pulp;
  pulp.kind = RegionKind::tissue;
  pulp.tissue = Tissue::pulp;
  start.draft.protected_parts = {Protected(pulp, Damage::touch)};
  EditorModel model(start);
  SpecimenSource other = model.scenario().specimen;
  other.seed = 3;
  ASSERT_TRUE(model.set_tooth(other, QStringLiteral("seed")));
  ASSERT_TRUE(model.set_critical("pulp_exposure", EditorModel::Listed::no));
  ASSERT_TRUE(model.set_critical("pulp_exposure", EditorModel::Listed::yes));
  EXPECT_EQ(model.scenario().protected_parts, start.draft.protected_parts);
}

TEST(editor_model, the_rule_about_damage_is_switched_where_more_than_pulp_is_protected) {
  EditorModel model(class_one());
  PointsForm form(model);
  QCheckBox* rule = nullptr;
  for (QCheckBox* box : form.findChildren<QCheckBox*>())
    if (box->text() == QStringLiteral("Damaging a protected part fails the attempt")) rule = box;
  ASSERT_NE(rule, nullptr);
  EXPECT_TRUE(rule->isHidden());
  ASSERT_TRUE(stand_round(model, {"neighbours"}));
  EXPECT_FALSE(rule->isHidden());
  EXPECT_TRUE(rule->isChecked());
  rule->click();
  EXPECT_EQ(model.scenario().rubric.critical, std::vector<std::string>{"pulp_exposure"});
  EXPECT_EQ(model.scenario().protected_parts.size(), 3u) << "they are still protected";
  rule->click();
  EXPECT_EQ(model.scenario().rubric.critical, (std::vector<std::string>{"pulp_exposure", "protected_damage"}));
}

TEST(editor_model, a_region_composed_with_a_neighbour_goes_with_it_and_comes_back) {
  EditorStart start;
  start.draft = load_builtin("class-2-46-mo").value();
  Region grown;
  grown.kind = RegionKind::offset;
  grown.by_mm = 0.1;
  grown.parts = {*start.draft.protected_parts[1].region};
  start.draft.protected_parts[1] = Protected(grown);
  EditorModel model(start);
  ASSERT_TRUE(stand_round(model, {}));
  EXPECT_EQ(model.scenario().protected_parts, std::vector<Protected>{Tissue::pulp});
  ASSERT_TRUE(stand_round(model, start.draft.specimen.around));
  EXPECT_EQ(model.scenario().protected_parts, start.draft.protected_parts);
}

TEST(editor_model, a_tooth_that_several_edits_brought_as_one_step_keeps_them_and_its_rule) {
  EditorModel model(class_one_on_a_block(5.5, 3.0));
  model.stack().beginMacro(QStringLiteral("Leanest model"));
  ASSERT_TRUE(model.set_specimen(coarse_36(), usual_tissues(std::string("tooth"))));
  ASSERT_TRUE(model.set_phenomenon("friction", EditorModel::Listed::no));
  model.stack().endMacro();
  bring_the_tooth(model);
  EXPECT_EQ(model.scenario().rubric.critical, std::vector<std::string>{"pulp_exposure"}) << "a finding names the pulp";
  EXPECT_EQ(model.stack().count(), 1);
}

}  // namespace
}  // namespace cusp::test
