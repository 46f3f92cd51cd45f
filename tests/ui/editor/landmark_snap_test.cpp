// Handles of the target that go to landmarks.

#include "ui/editor/landmark_snap.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <algorithm>

#include "scenarios/specimens/specimens.h"
#include "scenarios/teeth/tooth.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

std::vector<Landmark> pit_on_a_fissure() {
  return {{MarkKind::long_axis, {}, {Vec3(0.05, 0, -8), Vec3(0.05, 0, 6)}, MarkState::set},
          {MarkKind::fissure, "central mesial", {Vec3(0, 0, 5), Vec3(2, 0, 6)}, MarkState::set},
          {MarkKind::pit, "central", {Vec3(0, 0, 5)}, MarkState::proposed},
          {MarkKind::cej, {}, {Vec3(1, 0.1, 0), Vec3(0, 4, 0), Vec3(1, 0.1, 0)}, MarkState::set}};
}

TEST(NearestPlace, is_a_pit_before_the_line_through_it) {
  const auto marks = pit_on_a_fissure();
  const auto place = nearest_place(marks, {0.2, 0.05, 9}, 0.3);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->mark, 2u);
  EXPECT_EQ(place->at_mm, Vec3(0, 0, 5));
}

TEST(NearestPlace, lies_on_a_line_between_its_points) {
  const auto marks = pit_on_a_fissure();
  const auto place = nearest_place(marks, {1.0, 0.2, 9}, 0.3);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->mark, 1u);
  EXPECT_LT(glm::length(place->at_mm - Vec3(1, 0, 5.5)), 1e-12);
  EXPECT_NEAR(place->far_mm, 0.2, 1e-12);
}

TEST(NearestPlace, is_none_out_of_reach_nor_on_an_axis_nor_on_the_neck) {
  const auto marks = pit_on_a_fissure();
  EXPECT_FALSE(nearest_place(marks, {1.0, 0.4, 9}, 0.3).has_value());
  const std::vector<Landmark> others = {marks[0], marks[3]};
  EXPECT_FALSE(nearest_place(others, {0.05, 0, 0}, 5).has_value());
  EXPECT_FALSE(nearest_place({}, {0, 0, 0}, 5).has_value());
}

/// The page of class I on 36 with a coarse tooth.
struct SnapOnThePage : EditorPages {
  EditorStart of_36() const {
    EditorStart start = coarse();
    start.draft = *load_builtin("class-1-36");
    start.draft.specimen.voxel_mm = 0.4;
    start.published = start.draft;
    return start;
  }
  Vec3 central_pit() const {
    const auto grown = *tooth_landmarks(tooth_request(of_36().draft.specimen));
    return std::ranges::find(grown.pits, "central", &SurfacePlace::name)->at_mm;
  }
  /// The first point is dragged to 0.15 mm beside a place; where it stands then.
  static Vec3 drag_beside(const EditorPage& page, Vec3 mm, Qt::KeyboardModifiers held) {
    HandleKnob* knob = knobs_of(*page.stage())[0];
    const Vec3 before = knob->handle().at_mm;
    const auto px = [&](Vec3 at) { return *page.stage()->view()->project(at); };
    const QPointF to = px(Vec3(mm.x + 0.15, mm.y, before.z));
    QTest::mousePress(knob, Qt::LeftButton, {}, knob->rect().center());
    knob->setFocus();  // as a press by hand does
    const QPointF local = to - QPointF(knob->pos());
    QMouseEvent move(QEvent::MouseMove, local, knob->mapToGlobal(local), Qt::NoButton, Qt::LeftButton, held);
    QApplication::sendEvent(knob, &move);
    QTest::mouseRelease(knob, Qt::LeftButton, {}, knob->rect().center());
    return knobs_of(*page.stage())[0]->handle().at_mm;
  }
  static bool shows(const EditorPage& page, const char* text) {
    const auto labels = page.stage()->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* l) { return !l->isHidden() && l->text() == QLatin1String(text); });
  }
};

TEST_F(SnapOnThePage, a_point_dragged_beside_the_central_pit_stands_above_it_and_says_so) {
  const auto page = open(of_36());
  const Vec3 pit = central_pit();
  const Vec3 at = drag_beside(*page, pit, Qt::NoModifier);
  EXPECT_DOUBLE_EQ(at.x, on_handle_step(pit.x));
  EXPECT_DOUBLE_EQ(at.y, on_handle_step(pit.y));
  EXPECT_EQ(page->model().stack().count(), 1);
  EXPECT_TRUE(knobs_of(*page->stage())[0]->accessibleDescription().endsWith(QStringLiteral("Pit, central")));
  EXPECT_TRUE(shows(*page, "Pit, central"));
}

TEST_F(SnapOnThePage, with_shift_it_stands_where_it_is_dropped_and_the_key_l_takes_it_to_the_pit) {
  const auto page = open(of_36());
  const Vec3 pit = central_pit();
  const Vec3 at = drag_beside(*page, pit, Qt::ShiftModifier);
  EXPECT_GT(std::abs(at.x - pit.x), 0.05);
  EXPECT_FALSE(shows(*page, "Pit, central"));
  QTest::keyClick(knobs_of(*page->stage())[0], Qt::Key_L);
  const Vec3 there = knobs_of(*page->stage())[0]->handle().at_mm;
  EXPECT_NE(there, at);
  EXPECT_EQ(page->model().stack().count(), 2);
}

TEST_F(SnapOnThePage, a_block_has_no_landmark_and_its_hint_names_none) {
  const auto page = open();
  const auto labels = page->stage()->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::none_of(labels, [](const QLabel* l) { return l->text().contains(QStringLiteral("landmark,")); }));
  const Vec3 at = knobs_of(*page->stage())[0]->handle().at_mm;
  QTest::keyClick(knobs_of(*page->stage())[0], Qt::Key_L);
  EXPECT_EQ(knobs_of(*page->stage())[0]->handle().at_mm, at);
  EXPECT_EQ(page->model().stack().count(), 0);
}

}  // namespace
}  // namespace cusp::test
