// The handles of shapes that are no outlines.

#include "ui/editor/part_handles.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QTreeWidget>

#include "tests/scenarios/regions.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

using Kind = TargetHandle::Kind;

/// One of each kind that has handles; the box stands turned and leaning.
std::vector<Region> shapes_with_handles() {
  std::vector<Region> out;
  for (const RegionKind kind : {RegionKind::box, RegionKind::ellipsoid, RegionKind::sphere, RegionKind::cylinder, RegionKind::cone,
                                RegionKind::capsule, RegionKind::half_space}) {
    Region part;
    part.kind = kind;
    part.from_mm = {0.5, -0.25, 1.0};
    part.to_mm = {0.5, 1.75, -1.0};
    part.size_mm = {2.0, 1.5, 3.0};
    part.radius_mm = 0.75;
    part.end_radius_mm = 0.5;
    if (kind == RegionKind::box) {
      part.x_axis = {1, 1, 0};
      part.z_axis = {0.2, -0.2, 1};
    }
    out.push_back(part);
  }
  return out;
}

const TargetHandle* handle_of(const std::vector<TargetHandle>& handles, Kind kind) {
  const auto found = std::ranges::find(handles, kind, &TargetHandle::kind);
  return found == handles.end() ? nullptr : &*found;
}

TEST(PartHandles, of_a_box_whose_axes_span_nothing_are_its_place_alone) {
  for (const Vec3 z_axis : {Vec3(0.0), Vec3(1, 1, 0)}) {
    Region part = shapes_with_handles().front();
    part.z_axis = z_axis;
    const auto handles = handles_of_part(part);
    ASSERT_EQ(handles.size(), 1u);
    EXPECT_EQ(handles[0].kind, Kind::place);
  }
}

TEST(PartHandles, stand_where_they_were_moved_to) {
  for (const Region& part : shapes_with_handles()) {
    const auto handles = handles_of_part(part);
    ASSERT_FALSE(handles.empty()) << key_of(part.kind);
    for (const TargetHandle& handle : handles) {
      const Vec3 to = handle.at_mm + (handle.is_place() ? Vec3(0.3, -0.2, 0.1) : 0.2 * handle.along);
      const Region moved = moved_part(part, handle, to);
      const auto after = handles_of_part(moved);
      const TargetHandle* again = handle_of(after, handle.kind);
      ASSERT_NE(again, nullptr);
      // A place of a leaning floor and a side follow a length that is rounded to 0.01 mm.
      EXPECT_LT(glm::length(again->at_mm - to), 0.011) << key_of(part.kind) << ' ' << static_cast<int>(handle.kind);
      EXPECT_NE(moved, part);
    }
  }
}

TEST(PartHandles, leave_the_shape_where_they_are_not_moved) {
  for (const Region& part : shapes_with_handles())
    for (const TargetHandle& handle : handles_of_part(part)) {
      const Region same = moved_part(part, handle, handle.at_mm);
      EXPECT_LT(glm::length(same.from_mm - part.from_mm), 1e-9) << key_of(part.kind);
      EXPECT_LT(glm::length(same.size_mm - part.size_mm), 1e-9) << key_of(part.kind);
      EXPECT_NEAR(same.radius_mm, part.radius_mm, 1e-9) << key_of(part.kind);
    }
}

TEST(PartHandles, a_floor_moves_under_a_top_that_stays) {
  Region part = shapes_with_handles()[1];  // ellipsoid, upright: from 2.5 down to -0.5
  const auto handles = handles_of_part(part);
  const Region moved = moved_part(part, *handle_of(handles, Kind::floor), {0.5, -0.25, -1.0});
  EXPECT_DOUBLE_EQ(moved.size_mm.z, 3.5);
  EXPECT_DOUBLE_EQ(moved.from_mm.z, 0.75);
  EXPECT_DOUBLE_EQ(moved_part(part, *handle_of(handles, Kind::floor), {0.5, -0.25, 9.0}).size_mm.z, kLeastHandleMm);
}

TEST(PartHandles, nodes_and_shapes_of_voxels_have_none) {
  for (const RegionKind kind : {RegionKind::outline, RegionKind::tissue, RegionKind::lesion, RegionKind::joined, RegionKind::common,
                                RegionKind::difference, RegionKind::offset}) {
    Region part;
    part.kind = kind;
    EXPECT_TRUE(handles_of_part(part).empty()) << key_of(kind);
  }
}

struct PartHandlesOnThePage : EditorPages {
  /// The page with a ball beside the drawn target, chosen.
  std::unique_ptr<EditorPage> open_ball() {
    EditorStart start = coarse();
    start.draft.target = node(RegionKind::joined, {start.draft.target, sphere({1, 0, -1}, 1)});
    auto page = open(start);
    page->model().choose_part({1});
    return page;
  }
};

TEST_F(PartHandlesOnThePage, a_drag_is_one_step_of_undo_and_goes_with_the_hand) {
  const auto page = open_ball();
  TargetView& stage = *page->stage();
  const Region before = page->model().chosen();
  const auto knobs = knobs_of(stage);
  ASSERT_EQ(knobs.size(), 2u);
  HandleKnob* place = knobs[0];
  const QPoint middle = place->rect().center();
  QTest::mousePress(place, Qt::LeftButton, {}, middle);
  const QPoint start = place->pos();
  for (int i = 1; i <= 3; ++i) QTest::mouseMove(place, middle + QPoint(10, 4));
  QTest::mouseRelease(place, Qt::LeftButton, {}, place->rect().center());
  const Region after = page->model().chosen();
  EXPECT_NE(after.from_mm, before.from_mm);
  EXPECT_EQ(after.radius_mm, before.radius_mm);
  const QPoint way = place->pos() - start;
  EXPECT_GT(way.x(), 5) << way.x() << ' ' << way.y();
  page->model().stack().undo();
  page->model().choose_part({1});
  EXPECT_EQ(page->model().chosen(), before);
}

TEST_F(PartHandlesOnThePage, an_arrow_key_grows_a_radius_and_a_name_says_so) {
  const auto page = open_ball();
  const auto knobs = knobs_of(*page->stage());
  ASSERT_EQ(knobs.size(), 2u);
  EXPECT_EQ(knobs[1]->accessibleName(), QStringLiteral("Radius"));
  QTest::keyClick(knobs[1], Qt::Key_Right);
  EXPECT_DOUBLE_EQ(page->model().chosen().radius_mm, 1.05);
  QTest::keyClick(knobs[1], Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(page->model().chosen().radius_mm, 1.04);
  EXPECT_TRUE(knobs[1]->accessibleDescription().contains(QStringLiteral("1.04"))) << knobs[1]->accessibleDescription().toStdString();
}

}  // namespace
}  // namespace cusp::test
