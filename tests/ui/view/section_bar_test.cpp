// The section of a tooth that stands still: its plane, its slider, and the picture that closes the cutaway.

#include "ui/view/section_bar.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>

#include "scenarios/library/library.h"
#include "scenarios/shapes/target.h"
#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/session/scene_builder.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

constexpr int kSectionPatienceMs = 60'000;  // waits for progress, never decides

struct SectionOfABlock : testing::Test {
  SectionOfABlock() { bar.show_cut(cut()); }
  SectionBar::Cut cut() const {
    return {.volume = whole, .target = scenario.target, .leeway = scenario.leeway, .scenery = nullptr, .ideal = nullptr};
  }
  QStringList texts() const {
    QStringList out;
    for (const QLabel* label : bar.findChildren<QLabel*>()) out << label->text();
    return out;
  }
  Scenario scenario = *load_builtin("channel-1");
  std::shared_ptr<const Volume> whole = [this] {
    scenario.specimen.voxel_mm = 0.4;
    return std::make_shared<const Volume>(build_specimen(scenario, {}).value());
  }();
  ToothView view;
  SectionBar bar{view};
};

TEST_F(SectionOfABlock, begins_in_the_middle_of_the_target) {
  EXPECT_EQ(bar.slider()->value(), 0);
  EXPECT_TRUE(texts().contains(QStringLiteral("Through the middle")));
}

TEST(SectionOfALesion, begins_in_the_middle_of_the_target_once_its_voxels_are_found) {
  Scenario scenario = *load_builtin("caries-26");
  scenario.specimen.voxel_mm = 0.4;
  const auto whole = std::make_shared<const Volume>(build_specimen(scenario, {}).value());
  ToothView view;
  SectionBar bar(view);
  bar.show_cut({.volume = whole, .target = scenario.target, .leeway = scenario.leeway, .scenery = nullptr, .ideal = nullptr});
  QSignalSpy shown(&bar, &SectionBar::shown);
  bar.open();
  ASSERT_TRUE(shown.wait(kSectionPatienceMs));
  const TargetShape target(scenario.target, whole->specimen_ptr());
  ASSERT_FALSE(target.empty());
  EXPECT_NEAR(bar.plane().centre_mm.x, 0.5 * (target.low().x + target.high().x), 1e-9);
  EXPECT_NEAR(bar.place_mm(), 0.0, 1e-9);
}

TEST_F(SectionOfABlock, holds_the_top_of_the_block_where_the_target_has_no_end) {
  SectionBar::Cut endless = cut();
  endless.target = Region{};
  endless.target.kind = RegionKind::half_space;
  bar.show_cut(endless);
  const Grid& grid = whole->grid();
  const double top_mm = grid.centre_mm(grid.size - IVec3(1)).z;
  EXPECT_LE(bar.plane().centre_mm.z, top_mm);
  EXPECT_GE(bar.plane().centre_mm.z, top_mm - 12.0) << "the picture is 24 mm high";
}

TEST_F(SectionOfABlock, moves_across_its_plane_by_a_tenth_of_a_millimetre_a_step) {
  bar.choose(SectionBar::Way::mesiodistal);
  const SectionPlane before = bar.plane();
  bar.slider()->setValue(7);
  EXPECT_DOUBLE_EQ(bar.place_mm(), 0.7);
  EXPECT_NEAR(std::abs(glm::dot(bar.plane().centre_mm - before.centre_mm, before.normal())), 0.7, 1e-12);
  EXPECT_EQ(bar.plane().right, before.right);
}

TEST_F(SectionOfABlock, meets_a_wall_at_right_angles) {
  const Vec3 middle = bar.plane().centre_mm;
  bar.go_through(middle + Vec3(3.0, 0.2, 0.0));
  EXPECT_EQ(bar.way(), SectionBar::Way::mesiodistal);
  EXPECT_NEAR(bar.place_mm(), 0.2, 1e-9);
  bar.go_through(middle + Vec3(0.3, 1.5, 0.0));
  EXPECT_EQ(bar.way(), SectionBar::Way::buccolingual);
  EXPECT_NEAR(bar.place_mm(), 0.3, 1e-9);
}

TEST_F(SectionOfABlock, keeps_its_way_for_a_place_on_the_floor) {
  bar.choose(SectionBar::Way::mesiodistal);
  bar.go_through(bar.plane().centre_mm + Vec3(0.3, 0.2, 0.0));
  EXPECT_EQ(bar.way(), SectionBar::Way::mesiodistal);
}

TEST_F(SectionOfABlock, closes_the_cutaway_while_it_is_open_and_gives_the_view_back) {
  const Camera before = view.camera();
  QSignalSpy shown(&bar, &SectionBar::shown);
  bar.open();
  ASSERT_TRUE(shown.wait(kSectionPatienceMs));
  ASSERT_TRUE(view.scene().cutaway);
  EXPECT_EQ(*view.scene().cutaway, bar.plane());
  EXPECT_NE(view.camera(), before);
  bar.close();
  EXPECT_FALSE(view.scene().cutaway);
  EXPECT_EQ(view.camera(), before);
}

TEST_F(SectionOfABlock, faces_whoever_turns_the_tooth) {
  bar.open();
  const Vec3 to_viewer = bar.plane().normal();
  Camera turned = view.camera();
  turned.orbit(3.14159, 0.0);
  view.set_camera(turned);
  EXPECT_NEAR(glm::dot(bar.plane().normal(), to_viewer), -1.0, 1e-12);
  EXPECT_GT(glm::dot(bar.plane().normal(), -turned.forward()), 0.0);
}

TEST_F(SectionOfABlock, stays_where_it_was_moved_when_another_cut_comes) {
  bar.slider()->setValue(4);
  SectionBar::Cut changed = cut();
  changed.target.outline.depth_mm += 0.2;
  bar.show_cut(changed);
  EXPECT_DOUBLE_EQ(bar.place_mm(), 0.4);
}

TEST_F(SectionOfABlock, shows_its_whole_texts_in_a_narrow_view) {
  bar.set_tooth(36);
  bar.choose(SectionBar::Way::mesiodistal);
  bar.slider()->setValue(-12);
  bar.show();
  for (const int width : {320, 600}) {
    bar.setFixedWidth(width);
    bar.adjustSize();
    EXPECT_EQ(bar.width(), width);
    for (const QLabel* label : bar.findChildren<QLabel*>()) EXPECT_GE(label->width(), label->sizeHint().width()) << width << ": " << label->text().toStdString();
    for (const QAbstractButton* button : bar.findChildren<QAbstractButton*>()) {
      const QFontMetrics bold(font_of(TextRole::body, Weight::bold));
      EXPECT_GT(button->width(), bold.horizontalAdvance(button->text())) << width << ": " << button->text().toStdString();
    }
  }
}

TEST_F(SectionOfABlock, comes_back_into_a_smaller_tooth) {
  bar.slider()->setValue(bar.slider()->maximum());
  SectionBar::Cut small = cut();
  small.volume = std::make_shared<const Volume>(Specimen::build(ball(1.5), Reading::banded));
  bar.show_cut(small);
  EXPECT_NEAR(bar.place_mm(), SectionBar::kStepMm * bar.slider()->value(), SectionBar::kStepMm);
}

TEST(SectionBetweenNeighbours, closes_all_that_is_cut_open) {
  Scenario scenario = *load_builtin("class-2-36-do");
  scenario.specimen.voxel_mm = 0.4;
  const auto whole = std::make_shared<const Volume>(build_specimen(scenario, {}).value());
  ToothView view;
  SectionBar bar(view);
  bar.show_cut({.volume = whole, .target = scenario.target, .leeway = scenario.leeway, .scenery = nullptr, .ideal = nullptr});
  const Grid& grid = whole->grid();
  for (const SectionBar::Way way : {SectionBar::Way::mesiodistal, SectionBar::Way::buccolingual}) {
    bar.choose(way);
    const SectionPlane plane = bar.plane();
    const glm::dvec2 half = 0.5 * bar.picture_mm();
    for (const Vec3& corner : {grid.centre_mm(IVec3(0)), grid.centre_mm(grid.size - IVec3(1))}) {
      EXPECT_LE(std::abs(glm::dot(corner - plane.centre_mm, plane.right)), half.x + 1e-9);
      EXPECT_LE(std::abs(corner.z - plane.centre_mm.z), half.y + 1e-9);
    }
  }
}

TEST_F(SectionOfABlock, names_the_sides_of_a_tooth) {
  EXPECT_FALSE(texts().contains(QStringLiteral("mesial")));
  bar.set_tooth(16);
  bar.choose(SectionBar::Way::mesiodistal);
  bar.slider()->setValue(-3);
  EXPECT_TRUE(texts().contains(QStringLiteral("palatal")));
  const auto away = [](double mm, const char* side) { return format({mm, {}, QStringLiteral("mm"), 1}) + u' ' + QLatin1String(side); };
  EXPECT_EQ(bar.slider()->accessibleDescription(), away(0.3, "palatal"));
  bar.set_tooth(46);  // x points to distal in quadrant 4
  bar.choose(SectionBar::Way::buccolingual);
  bar.slider()->setValue(5);
  EXPECT_EQ(bar.slider()->accessibleDescription(), away(0.5, "distal"));
}

}  // namespace
}  // namespace cusp::test
