// Sides of a tooth from a file: by its number and its mesial axis, as those of a grown tooth. And the names of its tissues.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "scenarios/landmarks/landmarks.h"
#include "tests/modules.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/score_panel.h"
#include "ui/text/critical_events.h"
#include "ui/view/compass.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

/// A tooth of that number whose mesial axis begins at (10, 20, 0) and points along `mesial`.
Scenario of_a_file(int fdi, Vec3 mesial) {
  const Vec3 middle(10, 20, 0);
  Scenario out;
  out.specimen.volume = "molar.nrrd";
  out.specimen.landmarks.fdi = fdi;
  out.specimen.landmarks.marks = {{MarkKind::mesial_axis, {}, {middle, middle + mesial}, MarkState::set}};
  return out;
}

void show_exercise(DrillStage& stage, const Scenario& scenario) {
  stage.set_exercise(scenario, TargetLook(Region{}, {}, nullptr), {.bounds = {Vec3(-5.0), Vec3(5.0)}, .by_mouse = true, .is_tooth = true});
}

/// How far along x the eye stands from the tooth after so many turns.
double eye_after_turns(DrillStage& stage, int turns) {
  for (QPushButton* button : stage.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Turn"))
      for (int i = 0; i < turns; ++i) button->click();
  const Camera& camera = stage.findChild<ToothView*>()->camera();
  return camera.eye_mm().x - camera.centre_mm().x;
}

TEST(ImportedSides, are_those_of_the_number_where_the_mesial_axis_agrees) {
  EXPECT_EQ(sided_fdi(of_a_file(46, {-5, 0, 0}).specimen), 46);
  EXPECT_EQ(sided_fdi(of_a_file(46, {5, 0, 0}).specimen), 0) << "it lies the wrong way round";
  EXPECT_EQ(sided_fdi(of_a_file(0, {5, 0, 0}).specimen), 0);
  Scenario bare = of_a_file(46, {-5, 0, 0});
  bare.specimen.landmarks.marks.clear();
  EXPECT_EQ(sided_fdi(bare.specimen), 0);
}

TEST(ImportedSides, stand_in_the_compass_and_in_the_section_of_the_drilling_screen) {
  DrillStage stage;
  show_exercise(stage, of_a_file(26, {-5, 0, 0}));
  EXPECT_FALSE(stage.findChild<Compass*>()->isHidden());
  show_exercise(stage, of_a_file(26, {0, 5, 0}));
  EXPECT_TRUE(stage.findChild<Compass*>()->isHidden()) << "it is turned";
  ScorePanel panel;
  panel.set_exercise(of_a_file(26, {-5, 0, 0}), {.target = true, .pulp = true});
  const auto labels = panel.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) { return label->text() == QStringLiteral("buccal–palatal"); }));
}

TEST(ImportedTissues, stand_in_the_score_panel_by_their_author_s_names) {
  Scenario scenario = of_a_file(26, {-5, 0, 0});
  scenario.tissues = {{Tissue::enamel, 3, 0.5}, {Tissue{16}, 2, 3}};
  ScorePanel panel;
  panel.set_exercise(scenario, {.target = true, .names = {{16, "pulp stone"}}});
  const auto names = [&panel](const QString& text) {
    return std::ranges::any_of(panel.findChildren<QLabel*>(), [&text](const QLabel* label) { return label->text() == text; });
  };
  EXPECT_TRUE(names(QStringLiteral("pulp stone")));
  EXPECT_TRUE(names(QStringLiteral("Enamel")));
}

TEST(ImportedSides, turn_the_view_to_distal_in_each_quadrant) {
  for (const int mesial_x : {1, -1}) {
    DrillStage stage;
    show_exercise(stage, of_a_file(mesial_x > 0 ? 36 : 46, {5.0 * mesial_x, 0, 0}));
    EXPECT_LT(mesial_x * eye_after_turns(stage, 2), -1.0);  // buccal, then distal
  }
}

TEST(ImportedSides, name_a_place_by_the_middle_of_the_tooth) {
  const SpecimenSource tooth = of_a_file(46, {-5, 0, 0}).specimen;
  EXPECT_EQ(side_text(tooth, {13, 20, 2}), QStringLiteral("distal"));
  EXPECT_EQ(side_text(tooth, {7, 20, 2}), QStringLiteral("mesial"));
  EXPECT_EQ(side_text(tooth, {10, 17, 2}), QStringLiteral("lingual"));
  EXPECT_EQ(side_text(tooth, {10.2, 20.1, 2}), QString());
}

}  // namespace
}  // namespace cusp::test
