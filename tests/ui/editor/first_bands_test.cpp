// Bands of new criteria, and how those of depth and isthmus follow the target.

#include "ui/editor/first_bands.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <algorithm>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/points_form.h"

namespace cusp::test {
namespace {

/// The template's own bands are expressions of the same floor and wall.
TEST(FirstBands, Grow_with_the_outlines_floor_and_wall_and_move_with_its_width) {
  const Scenario premolar = *load_builtin("class-1-25");
  ASSERT_EQ(premolar.target.kind, RegionKind::outline);
  for (const Criterion& c : premolar.rubric.criteria) {
    if (!c.metric.starts_with("overcut_") && c.metric != "isthmus_width") continue;
    const Bands first = first_bands(c.metric, premolar.target, 25);
    EXPECT_NEAR(first.ideal_hi, c.bands.ideal_hi, 0.02 + 0.02 * c.bands.ideal_hi) << c.metric;
    EXPECT_NEAR(first.fail_hi, c.bands.fail_hi, 0.02 + 0.02 * c.bands.fail_hi) << c.metric;
    EXPECT_EQ(first.ideal_lo, c.bands.ideal_lo) << c.metric;
  }
  Region wide = premolar.target;
  wide.outline.width_mm = 1.6;
  EXPECT_NEAR(first_bands("isthmus_width", wide, 25).ideal_lo, 1.4, 1e-9);
  wide.outline.shape = "box";
  wide.outline.box_size_mm = {5, 3, 0};
  EXPECT_NEAR(first_bands("isthmus_width", wide, 25).ideal_lo, 2.8, 1e-9) << "across the tooth a box has its second size";
  wide.kind = RegionKind::box;
  EXPECT_NEAR(first_bands("isthmus_width", wide, 25).ideal_lo, 0.8, 1e-9) << "a box has no width of its own";
}

TEST(FirstBands, Of_one_faces_overcut_are_those_of_its_kind_and_lose_points) {
  const Region target = load_builtin("class-1-36")->target;
  for (const std::string zone : {"overcut_leeway_", "overcut_beyond_"}) {
    for (const char* wall : {"mesial_wall", "axial_wall", "side_wall"})
      EXPECT_EQ(first_bands(zone + wall, target, 36), first_bands(zone + "side", target, 36)) << zone << wall;
    for (const char* floor : {"pulpal_floor", "gingival_floor"})
      EXPECT_EQ(first_bands(zone + floor, target, 36), first_bands(zone + "floor", target, 36)) << zone << floor;
    EXPECT_LT(first_bands(zone + "mesial_wall", target, 36).fail_hi, 100.0);
  }
  EXPECT_EQ(first_bands("depth_least", target, 36), first_bands("depth_mean", target, 36));
}

TEST(Width, Of_an_outline_moves_the_bands_of_its_isthmus_in_one_step) {
  EditorStart start;
  start.draft = *load_builtin("class-1-25");
  EditorModel model(start);
  const Scenario before = model.scenario();
  ASSERT_TRUE(model.set_width_mm(1.3));
  const auto isthmus = std::ranges::find(model.scenario().rubric.criteria, "isthmus_width", &Criterion::metric);
  ASSERT_NE(isthmus, model.scenario().rubric.criteria.end());
  EXPECT_EQ(isthmus->bands, (Bands{0.8, 1.0, 1.1, 1.5, 1.8, 2.3}));
  model.stack().undo();
  EXPECT_EQ(model.scenario(), before);
}

TEST(Width, And_depth_of_several_targets_move_the_bands_of_the_whole_with_the_narrowest_and_the_deepest) {
  EditorStart start;
  start.draft = *load_builtin("class-1-16");
  EditorModel model(start);
  const auto bands_of = [&](const char* metric) {
    return std::ranges::find(model.scenario().rubric.criteria, metric, &Criterion::metric)->bands;
  };
  const Bands isthmus = bands_of("isthmus_width"), deepest = bands_of("depth_most");
  const Outline mesial = model.scenario().target.parts[0].outline;
  model.choose_part({0});
  ASSERT_TRUE(model.set_width_mm(mesial.width_mm + 0.3));
  EXPECT_EQ(bands_of("isthmus_width"), isthmus) << "the distal cavity is as narrow as before";
  ASSERT_TRUE(model.set_depth_mm(mesial.depth_mm + 0.4));
  EXPECT_NEAR(bands_of("depth_most").ideal_hi, deepest.ideal_hi + 0.4, 1e-9);
  model.choose_part({1});
  ASSERT_TRUE(model.set_width_mm(mesial.width_mm + 0.3));
  EXPECT_NEAR(bands_of("isthmus_width").ideal_lo, isthmus.ideal_lo + 0.3, 1e-9);
  ASSERT_TRUE(model.set_depth_mm(mesial.depth_mm + 0.4));
  EXPECT_NEAR(bands_of("depth_most").ideal_hi, deepest.ideal_hi + 0.4, 1e-9) << "the other is as deep";
}

TEST(Width, Of_a_box_moves_the_bands_of_its_isthmus_and_its_length_moves_none) {
  EditorStart start;
  start.draft = *load_builtin("class-1-25");
  EditorModel model(start);
  ASSERT_TRUE(model.set_shape("box"));
  const Vec3 size = model.outline().box_size_mm;
  const Rubric before = model.scenario().rubric;
  ASSERT_TRUE(model.set_box_size_mm(size.x + 1.0, size.y));
  EXPECT_EQ(model.scenario().rubric, before);
  ASSERT_TRUE(model.set_box_size_mm(size.x + 1.0, size.y + 0.5));
  const auto isthmus = [](const Rubric& rubric) { return std::ranges::find(rubric.criteria, "isthmus_width", &Criterion::metric)->bands; };
  EXPECT_NEAR(isthmus(model.scenario().rubric).ideal_lo, isthmus(before).ideal_lo + 0.5, 1e-9);
  EXPECT_NEAR(isthmus(model.scenario().rubric).fail_hi, isthmus(before).fail_hi + 0.5, 1e-9);
}

TEST(Width, Of_an_outline_that_takes_another_shape_moves_the_bands_of_its_isthmus) {
  EditorStart start;
  start.draft = *load_builtin("class-1-36");
  EditorModel model(start);
  const auto isthmus = [&model] { return std::ranges::find(model.scenario().rubric.criteria, "isthmus_width", &Criterion::metric)->bands; };
  const double width = model.outline().width_mm;
  const Bands before = isthmus();
  for (const char* shape : {"box", "channel"}) {
    ASSERT_TRUE(model.set_shape(shape));
    const double wider = isthmus_mm(model.outline()) - width;
    EXPECT_GT(wider, 0.5) << "the outline has branches across the tooth";
    EXPECT_NEAR(isthmus().ideal_lo, before.ideal_lo + wider, 1e-4) << shape;
    EXPECT_NEAR(isthmus().fail_hi, before.fail_hi + wider, 1e-4) << shape;
  }
}

TEST(FirstBands, Of_a_ridge_go_by_the_number_of_a_tooth_from_a_file) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  start.draft.specimen = {};
  start.draft.specimen.volume = "tooth.nrrd";
  start.draft.specimen.landmarks.fdi = 46;
  start.draft.specimen.landmarks.marks = {{MarkKind::cusp_tip, "MB", {Vec3(2, 2, 7)}, MarkState::set}};
  EditorModel model(start);
  PointsForm form(model);
  const auto named = [](const auto& all, const char* name) {
    return *std::ranges::find_if(all, [name](const auto* widget) { return widget->accessibleName() == QLatin1String(name); });
  };
  auto* metrics = named(form.findChildren<QComboBox*>(), "Criterion to add");
  metrics->setCurrentIndex(metrics->findData(QStringLiteral("ridge_mesial")));
  named(form.findChildren<QPushButton*>(), "Add a criterion")->click();
  ASSERT_EQ(model.scenario().rubric.criteria.back().metric, "ridge_mesial");
  EXPECT_EQ(model.scenario().rubric.criteria.back().bands.ideal_lo, 2.0) << "of a molar; of a premolar 1.6";
}

}  // namespace
}  // namespace cusp::test
