// The tooth of a report beside the tooth as it was.

#include "ui/report/before_after.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/report/against_before.h"
#include "ui/report/pinned_tooth.h"
#include "ui/session/operator_cut.h"
#include "ui/session/scene_builder.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;  // waits for progress, never decides

struct BeforeAfterTest : testing::Test {
  BeforeAfterTest() {
    scenario.specimen.voxel_mm = 0.4;
    cut = cut_by_operator("reference", scenario, build_specimen(scenario, {}).value())->volume;
    tooth = new PinnedTooth(cut, scenario);
    teeth = std::make_unique<BeforeAfter>(tooth, cut, scenario);
    teeth->resize(600, 500);
    teeth->show();
  }
  void show_both() {
    teeth->show_teeth(BeforeAfter::Shown::both);
    ASSERT_TRUE(QTest::qWaitFor([&] { return tooth->tooth_shown() && teeth->before_shown(); }, kPatienceMs));
  }
  /// Of the surface in the middle of the target.
  double height_mm(const ToothView& view) const {
    Ray down{tooth->view()->camera().centre_mm(), {0, 0, -1}};
    down.from_mm.z += 20;
    const auto hit = view.store().pick(down);
    return hit ? hit->at_mm.z : -1e9;
  }
  Scenario scenario = *load_builtin("channel-1");
  std::shared_ptr<const Volume> cut;
  PinnedTooth* tooth;
  std::unique_ptr<BeforeAfter> teeth;
};

TEST_F(BeforeAfterTest, shows_the_uncut_tooth_beside_the_cut_one_in_halves) {
  show_both();
  EXPECT_GT(height_mm(*teeth->before()), height_mm(*tooth->view()) + 0.8);  // the channel is 1 mm deep or more
  EXPECT_EQ(teeth->before()->width(), tooth->width());
  EXPECT_LT(teeth->before()->geometry().right(), tooth->x());
  teeth->show_teeth(BeforeAfter::Shown::after);
  EXPECT_EQ(tooth->geometry(), teeth->rect());
  EXPECT_FALSE(teeth->before()->isVisible());
}

TEST_F(BeforeAfterTest, turns_both_teeth_together) {
  show_both();
  EXPECT_EQ(teeth->before()->camera(), tooth->view()->camera());
  Camera turned = tooth->view()->camera();
  turned.set_preset(PresetView::buccal);
  tooth->view()->set_camera(turned);
  EXPECT_EQ(teeth->before()->camera(), turned);
  turned.zoom(2);
  teeth->before()->set_camera(turned);
  EXPECT_EQ(tooth->view()->camera(), turned);
}

TEST_F(BeforeAfterTest, a_pinned_place_is_marked_where_one_tooth_stands_alone) {
  show_both();
  tooth->pin(tooth->view()->camera().centre_mm(), QStringLiteral("Floor"), {});
  EXPECT_FALSE(tooth->ring_shown());
  const auto* card = tooth->findChild<QLabel*>();
  EXPECT_FALSE(card->isVisible());
  teeth->show_teeth(BeforeAfter::Shown::after);
  EXPECT_TRUE(card->isVisible());
}

TEST_F(BeforeAfterTest, the_tooth_as_it_was_stands_where_reading_begins) {
  teeth->setLayoutDirection(Qt::RightToLeft);
  show_both();
  EXPECT_GT(teeth->before()->x(), tooth->x());
}

TEST(AgainstBefore, full_points_of_another_rubric_are_no_gain) {
  Grade before = sample_grade(60);
  before.criteria[0].points = before.criteria[0].points_max = 5;  // of 15; now 20 of 30
  const AgainstBefore view(sample_grade(60), before);
  ASSERT_EQ(view.rows().size(), 2);
  EXPECT_DOUBLE_EQ(view.rows()[0].before, 1);
  EXPECT_DOUBLE_EQ(view.rows()[0].now, 1);
  EXPECT_NEAR(view.rows()[0].points, 0, 1e-9);
  EXPECT_NEAR(view.rows()[1].points, 0, 0.05);  // 4 of 10 in both
}

}  // namespace
}  // namespace cusp::test
