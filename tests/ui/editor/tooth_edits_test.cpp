// Edits of the draft's tooth without a window: its carious lesions and neighbours, and what another tooth brings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scenarios/library/library.h"
#include "scenarios/templates/templates.h"
#include "scenarios/tissues/tissue_facts.h"
#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/specimen_grower.h"

namespace cusp::test {
namespace {

TEST(editor_tooth, another_tooth_is_grown_anew_and_the_old_facts_are_forgotten) {
  EditorModel model(class_one());
  model.set_facts(facts_of_36());
  int changes = 0;
  QObject::connect(&model, &EditorModel::specimen_changed, [&changes] { ++changes; });
  model.set_width_mm(1.4);
  EXPECT_EQ(changes, 0);
  SpecimenSource other = model.scenario().specimen;
  other.fdi = 46;
  ASSERT_TRUE(model.set_specimen(other, model.scenario().tissues));
  EXPECT_EQ(changes, 1);
  EXPECT_FALSE(model.facts().has_value());
  model.stack().undo();
  EXPECT_EQ(changes, 2);
}

TEST(editor_tooth, carious_lesions_and_neighbours_bring_their_tissues_and_leave_the_figures_of_the_others) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_tissue_figures(0, 2.5, 0.6));
  SpecimenSource tooth = model.scenario().specimen;
  tooth.lesions = {{"fissure", "central", 0.8, 1.0, 0.7}};
  tooth.around = {"neighbours"};
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("around")));
  const auto figures = [&](Tissue tissue) {
    const auto& all = model.scenario().tissues;
    const auto it = std::ranges::find(all, tissue, &ScenarioTissue::tissue);
    return it == all.end() ? ScenarioTissue{Tissue::empty, 0, 0} : *it;
  };
  EXPECT_DOUBLE_EQ(figures(Tissue::enamel).stiffness_n_per_mm, 2.5);
  EXPECT_DOUBLE_EQ(figures(Tissue::carious_dentine).speed_mm_s, tissue_facts(Tissue::carious_dentine).speed_mm_s.value);
  EXPECT_EQ(figures(static_cast<Tissue>(29)).tissue, static_cast<Tissue>(29));
  tooth.typodont = true;
  tooth.lesions.clear();
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("plastic")));
  ASSERT_EQ(model.scenario().tissues.size(), 1u);
  EXPECT_EQ(model.scenario().tissues[0].tissue, Tissue::plastic);
  EXPECT_TRUE(model.scenario().protected_parts.empty());
  model.stack().undo();
  EXPECT_DOUBLE_EQ(figures(Tissue::enamel).stiffness_n_per_mm, 2.5);
}

TEST(editor_tooth, a_mesial_box_stays_mesial_on_the_tooth_of_the_other_side) {
  const ScenarioId id = ScenarioId::make();
  const auto of_36 = fit_template({.key = "class-2-adhesive", .fdi = 36, .id = id}), of_46 = fit_template({.key = "class-2-adhesive", .fdi = 46, .id = id});
  ASSERT_TRUE(of_36 && of_46);
  ASSERT_NE(of_36->target, of_46->target);
  EditorStart start;
  start.draft = *of_36;
  EditorModel model(start);
  const auto take = [&](int fdi) {
    SpecimenSource tooth = model.scenario().specimen;
    tooth.fdi = fdi;
    model.end_gesture();
    return model.set_tooth(tooth, QStringLiteral("fdi"));
  };
  ASSERT_TRUE(take(46));
  EXPECT_EQ(model.scenario().target, of_46->target);
  ASSERT_TRUE(take(45));
  EXPECT_EQ(model.scenario().target, of_46->target) << "mesial lies on the same side";
  ASSERT_TRUE(take(16));
  EXPECT_EQ(model.scenario().target, of_36->target);
  for (int i = 0; i < 3; ++i) model.stack().undo();
  EXPECT_EQ(model.scenario(), start.draft);
}

/// Landmarks of a tooth of that number which lies as its frame wants it.
SpecimenLandmarks lying_right(int fdi) {
  SpecimenLandmarks out;
  out.fdi = fdi;
  out.marks = {{MarkKind::mesial_axis, {}, {Vec3(0.0), Vec3(fdi / 10 % 2 == 1 ? 5.0 : -5.0, 0, 0)}, MarkState::proposed}};
  return out;
}

/// A class II, moved from the grown 36 to a file without a number.
struct ClassTwoOnAFile : ::testing::Test {
  void SetUp() override {
    SpecimenSource file;
    file.volume = "tooth.nrrd";
    file.voxel_mm = of_36.specimen.voxel_mm;
    ASSERT_TRUE(model.set_specimen(file, of_36.tissues));
    ASSERT_EQ(model.scenario().target, of_36.target) << "no side is known yet";
  }
  static EditorStart start(const Scenario& draft) {
    EditorStart out;
    out.draft = draft;
    return out;
  }
  bool finds(std::string_view code) const { return std::ranges::find(model.findings(), code, &Finding::code) != model.findings().end(); }
  const Scenario of_36 = fit_template({.key = "class-2-adhesive", .fdi = 36, .id = ScenarioId::make()}).value();
  const Scenario of_46 = fit_template({.key = "class-2-adhesive", .fdi = 46, .id = of_36.id}).value();
  EditorModel model{start(of_36)};
};

TEST_F(ClassTwoOnAFile, stays_mesial_when_the_number_puts_the_file_on_the_other_side) {
  EXPECT_TRUE(finds("sides_unknown"));
  ASSERT_TRUE(model.take_proposed(lying_right(46)));
  EXPECT_EQ(model.scenario().target, of_46.target);
  EXPECT_FALSE(finds("sides_unknown") || finds("wall_of_other_side"));
  model.stack().undo();
  EXPECT_EQ(model.scenario().target, of_36.target);
  ASSERT_TRUE(model.take_proposed(lying_right(35)));
  EXPECT_EQ(model.scenario().target, of_36.target) << "mesial lies on the same side";
}

TEST_F(ClassTwoOnAFile, that_was_drawn_anew_there_stays_where_it_is_and_a_check_names_the_wall) {
  Region moved = model.chosen();
  moved.outline.width_mm += 0.1;
  ASSERT_TRUE(model.set_part(moved, QStringLiteral("part")));
  const Region drawn = model.scenario().target;
  ASSERT_TRUE(model.take_proposed(lying_right(46)));
  EXPECT_EQ(model.scenario().target, drawn);
  EXPECT_TRUE(finds("wall_of_other_side"));
}

TEST_F(ClassTwoOnAFile, keeps_its_place_and_changes_its_names_when_a_wrong_number_is_corrected) {
  ASSERT_TRUE(model.take_proposed(lying_right(36)));
  ASSERT_TRUE(model.take_proposed(lying_right(46)));
  const Region& target = model.scenario().target;
  EXPECT_NE(target, of_36.target);
  EXPECT_NE(target, of_46.target);
  EXPECT_FALSE(finds("wall_of_other_side"));
  ASSERT_TRUE(model.take_proposed(lying_right(36)));
  EXPECT_EQ(model.scenario().target, of_36.target) << "names changed over twice";
}

TEST(editor_tooth, a_target_that_stood_on_a_block_in_between_is_still_of_its_side) {
  const ScenarioId id = ScenarioId::make();
  const auto of_36 = fit_template({.key = "class-2-adhesive", .fdi = 36, .id = id}), of_46 = fit_template({.key = "class-2-adhesive", .fdi = 46, .id = id});
  ASSERT_TRUE(of_36 && of_46);
  EditorStart start;
  start.draft = *of_36;
  EditorModel model(start);
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.1;
  ASSERT_TRUE(model.set_specimen(block, of_36->tissues));
  ASSERT_TRUE(model.set_specimen(of_46->specimen, of_46->tissues));
  EXPECT_EQ(model.scenario().target, of_46->target);
}

TEST(editor_tooth, a_protected_region_is_mirrored_with_the_tooth) {
  EditorStart start = class_one();
  Region ball;
  ball.kind = RegionKind::sphere;
  ball.from_mm = {3.0, 1.0, 2.0};
  ball.radius_mm = 0.5;
  start.draft.protected_parts.emplace_back(ball);
  EditorModel model(start);
  SpecimenSource tooth = model.scenario().specimen;
  tooth.fdi = 46;
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("fdi")));
  EXPECT_EQ(model.scenario().protected_parts.back().region->from_mm, Vec3(-3.0, 1.0, 2.0));
}

TEST(editor_tooth, turning_a_lesions_number_is_one_step_and_two_lesions_are_two) {
  EditorModel model(class_one());
  SpecimenSource tooth = model.scenario().specimen;
  tooth.lesions = {{"fissure", "central", 0.8, 1.0, 0.7}, {"root", "buccal", 0.8, 1.0, 0.7}};
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("lesions")));
  model.end_gesture();
  for (const double depth : {1.1, 1.2, 1.3}) {
    tooth.lesions[0].depth_mm = depth;
    ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("lesion/0/depth")));
  }
  tooth.lesions[1].depth_mm = 2.0;
  ASSERT_TRUE(model.set_tooth(tooth, QStringLiteral("lesion/1/depth")));
  EXPECT_EQ(model.stack().count(), 3);
  tooth.lesions[1].softness = 1.5;  // what a file may not hold
  EXPECT_FALSE(model.set_tooth(tooth, QStringLiteral("lesion/1/soft")));
  tooth.lesions[1].softness = std::nan("");
  EXPECT_FALSE(model.set_tooth(tooth, QStringLiteral("lesion/1/soft")));
  EXPECT_EQ(model.stack().count(), 3);
}

TEST(editor_tooth, a_new_tooth_begins_with_the_usual_figures_and_its_critical_tissues_protected) {
  const auto usual = usual_tissues({Tissue::enamel, Tissue::pulp, static_cast<Tissue>(17)});
  ASSERT_EQ(usual.size(), 3u);
  EXPECT_EQ(usual[0].speed_mm_s, tissue_facts(Tissue::enamel).speed_mm_s.value);
  EXPECT_EQ(usual[2].stiffness_n_per_mm, tissue_facts(static_cast<Tissue>(17)).stiffness_n_per_mm.value);
  const auto tooth = usual_tissues(std::string("tooth"));
  ASSERT_FALSE(tooth.empty());
  for (const ScenarioTissue& t : tooth) EXPECT_EQ(t.speed_mm_s, tissue_facts(t.tissue).speed_mm_s.value);
  // The paper's block keeps the paper's speeds.
  for (const ScenarioTissue& t : usual_tissues(std::string("paper-block"))) {
    EXPECT_TRUE(t.tissue != Tissue::dentine || t.speed_mm_s == 1.2);
  }
  EditorStart start = class_one();
  start.draft.protected_parts.clear();
  EditorModel model(start);
  SpecimenSource source = start.draft.specimen;
  source.seed = 3;
  EXPECT_TRUE(model.set_specimen(source, usual));
  EXPECT_EQ(model.scenario().protected_parts, std::vector<Protected>{Tissue::pulp});
}

}  // namespace
}  // namespace cusp::test
