// The handles of nodes: union, intersection, difference and offset.

#include "ui/editor/node_handles.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <tuple>

#include "scenarios/shapes/region.h"
#include "tests/scenarios/regions.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/part_handles.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

using Kind = TargetHandle::Kind;

constexpr double kVoxelMm = 0.1;

/// Enamel from -4 to 4 mm in x and y and below z = 0, with a pulp of 1 mm edge about (0, 0, -3).
std::shared_ptr<const Specimen> block() {
  VoxelVolume out(Grid{IVec3(100, 100, 60), kVoxelMm, Vec3(-4.95, -4.95, -4.95)});
  IVec3 v;
  for (v.z = 10; v.z < 50; ++v.z)
    for (v.y = 10; v.y < 90; ++v.y)
      for (v.x = 10; v.x < 90; ++v.x) {
        const Vec3 from_pulp = glm::abs(out.grid.centre_mm(v) - Vec3(0, 0, -3));
        out.s[out.grid.index(v)] = kSolid;
        out.tissue[out.grid.index(v)] = std::max({from_pulp.x, from_pulp.y, from_pulp.z}) < 0.5 ? Tissue::pulp : Tissue::enamel;
      }
  static const auto specimen = Specimen::build(out, Reading::banded);
  return specimen;
}

Region pulp() {
  Region out;
  out.kind = RegionKind::tissue;
  out.tissue = Tissue::pulp;
  return out;
}

std::vector<TargetHandle> handles_in_block(const Region& node) { return handles_of_node(node, node_anchor(node, block())); }

const TargetHandle& the_handle(const std::vector<TargetHandle>& handles, Kind kind) {
  const auto found = std::ranges::find(handles, kind, &TargetHandle::kind);
  if (found == handles.end()) throw std::runtime_error("no such handle");
  return *found;
}

/// A cuboid over the block's face and one across it, both with upright walls.
Region two_boxes(RegionKind kind) { return node(kind, {box_region({0, 0, 0}, {4, 2, 3}), box_region({1, 0, 0}, {1, 6, 2})}, 0.3); }

std::vector<Region> leaves_of_each_kind() {
  Region outline = region_of({});
  outline.outline.paths = {{{-1, 0.5, -1.8}, {1, 0.5, -1.8}}};
  outline.outline.depth_mm = 1.8;
  const auto ended = [](RegionKind kind) { return along(kind, {0, 0, 0}, {0.5, 0, -2}, 0.8, 0.4); };
  Region ellipsoid = box_region({1, 0, -1}, {2, 3, 2});
  ellipsoid.kind = RegionKind::ellipsoid;
  return {outline, box_region({0, 0, -1}, {2, 1, 1}), ended(RegionKind::cylinder), ended(RegionKind::cone), ended(RegionKind::capsule),
          sphere({0.2, 0.1, -1}, 1), ellipsoid, half_space({0, 0, -0.5}, {0, 0, 1})};
}

TEST(NodeHandles, move_every_leaf_with_a_place_by_the_same_way_and_change_no_size) {
  const Vec3 by(0.25, -0.4, 0.15);
  std::vector<Region> leaves = leaves_of_each_kind();
  leaves.push_back(pulp());
  const Region whole = node(RegionKind::joined, {node(RegionKind::common, leaves, 0.1), node(RegionKind::offset, {leaves[1]}, 0.2)}, 0.3);
  const TargetHandle place = the_handle(handles_in_block(whole), Kind::whole);
  const Region after = moved_part(whole, place, place.at_mm + by);
  EXPECT_LT(glm::length(the_handle(handles_in_block(after), Kind::whole).at_mm - place.at_mm - by), 1e-9);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Region &leaf = leaves[i], &moved = after.parts[0].parts[i];
    const RegionShape before_shape(leaf, block()), after_shape(moved, block());
    const Vec3 way = is_of_voxels(leaf.kind) ? Vec3(0.0) : by;
    for (const Vec3 p : {Vec3(0.3, 0.2, -0.7), Vec3(-2, 1, 0), Vec3(1.5, -1.5, -2.5)})
      EXPECT_NEAR(after_shape.near(p + way).distance_mm, before_shape.near(p).distance_mm, 1e-9) << key_of(leaf.kind);
  }
  EXPECT_EQ(moved_part(after, place, place.at_mm - by), whole) << "and back";
}

TEST(NodeHandles, of_shapes_of_voxels_alone_have_no_place_to_move) {
  for (const Region& whole : {node(RegionKind::offset, {pulp()}, 0.5), node(RegionKind::joined, {pulp(), node(RegionKind::offset, {pulp()}, 0.3)})}) {
    for (const TargetHandle& handle : handles_in_block(whole)) EXPECT_NE(handle.kind, Kind::whole);
    EXPECT_FALSE(middle_of_leaves(whole).has_value());
  }
}

TEST(NodeHandles, place_of_all_shapes_leaves_a_half_space_out_unless_it_stands_alone) {
  const Region plane = half_space({9, 9, 9}, {0, 0, 1});
  EXPECT_EQ(middle_of_leaves(node(RegionKind::common, {sphere({1, 0, -1}, 1), sphere({2, 1, -1}, 1), plane})), Vec3(1.5, 0.5, -1));
  EXPECT_EQ(middle_of_leaves(node(RegionKind::offset, {plane}, 0.1)), Vec3(9, 9, 9));
}

TEST(NodeHandles, rounding_stands_on_the_edge_within_the_tooth_and_leads_away_from_both_faces) {
  for (const RegionKind kind : {RegionKind::joined, RegionKind::common, RegionKind::difference}) {
    const Region whole = two_boxes(kind);
    const auto anchor = node_anchor(whole, block());
    ASSERT_TRUE(anchor.has_value()) << key_of(kind);
    // Upright walls meet at (0.5 or 1.5, -1 or 1).
    EXPECT_NEAR(std::abs(anchor->at_mm.x - 1), 0.5, 2e-3) << key_of(kind);
    EXPECT_NEAR(std::abs(anchor->at_mm.y), 1, 2e-3) << key_of(kind);
    EXPECT_GT(anchor->at_mm.z, -0.2) << "beside the block's face at 0";
    EXPECT_LT(anchor->at_mm.z, kVoxelMm) << key_of(kind);
    EXPECT_NEAR(std::abs(anchor->along.x), std::sqrt(0.5), 1e-6) << key_of(kind);
    EXPECT_NEAR(std::abs(anchor->along.y), std::sqrt(0.5), 1e-6) << key_of(kind);
    // The rounding fills a union's corner and takes the corner of the others off.
    const RegionShape plain(two_boxes(kind));
    const double there = plain.near(anchor->at_mm + 0.2 * anchor->along).distance_mm;
    EXPECT_TRUE(kind == RegionKind::joined ? there > 0 : there < 0) << key_of(kind) << ' ' << there;
    const auto handles = handles_of_node(whole, anchor);
    EXPECT_LT(glm::length(the_handle(handles, Kind::rounding).at_mm - anchor->at_mm - 0.3 * anchor->along), 1e-12);
  }
}

TEST(NodeHandles, growth_stands_on_the_grown_surface_and_leads_out_of_it) {
  for (const Region& part : {sphere({0, 0, -1}, 1), box_region({0, 0, 0}, {2, 2, 3}), pulp()})
    for (const double by : {-0.2, 0.0, 0.45}) {
      const Region whole = node(RegionKind::offset, {part}, by);
      const TargetHandle growth = the_handle(handles_in_block(whole), Kind::growth);
      EXPECT_NEAR(RegionShape(whole, block()).near(growth.at_mm).distance_mm, 0, 2e-3) << key_of(part.kind) << ' ' << by;
      EXPECT_GT(RegionShape(whole, block()).near(growth.at_mm + 0.2 * growth.along).distance_mm, 0.19) << key_of(part.kind) << ' ' << by;
    }
}

TEST(NodeHandles, stand_where_they_were_moved_to) {
  for (const Region& whole : {two_boxes(RegionKind::joined), two_boxes(RegionKind::difference), node(RegionKind::offset, {sphere({0, 0, -1}, 1)}, 0.45)}) {
    for (const TargetHandle& handle : handles_in_block(whole)) {
      const Vec3 to = handle.at_mm + (handle.is_place() ? Vec3(0.3, -0.2, 0.1) : 0.2 * handle.along);
      const auto after = handles_in_block(moved_part(whole, handle, to));
      EXPECT_LT(glm::length(the_handle(after, handle.kind).at_mm - to), 1e-9) << key_of(whole.kind) << ' ' << static_cast<int>(handle.kind);
      EXPECT_EQ(moved_part(whole, handle, handle.at_mm), whole) << "and stay where they are not";
    }
  }
}

TEST(NodeHandles, keep_rounding_and_growth_within_the_format) {
  const auto moved = [](const Region& whole, Kind kind, double mm) {
    const TargetHandle handle = the_handle(handles_in_block(whole), kind);
    return moved_part(whole, handle, handle.at_mm + mm * handle.along);
  };
  EXPECT_DOUBLE_EQ(moved(two_boxes(RegionKind::joined), Kind::rounding, -9).rounding_mm, 0);
  EXPECT_DOUBLE_EQ(moved(two_boxes(RegionKind::joined), Kind::rounding, 9).rounding_mm, 5);
  const Region grown = node(RegionKind::offset, {sphere({0, 0, -1}, 1)}, 0.45);
  EXPECT_DOUBLE_EQ(moved(grown, Kind::growth, -0.7).by_mm, -0.25) << "inwards too";
  EXPECT_DOUBLE_EQ(moved(grown, Kind::growth, -9).by_mm, -5);
}

TEST(NodeHandles, rounding_has_none_where_no_two_parts_meet_or_another_covers_the_edge) {
  const Region apart = node(RegionKind::joined, {sphere({-2, 0, -1}, 0.5), sphere({2, 0, -1}, 0.5)}, 0.3);
  EXPECT_FALSE(node_anchor(apart, block()).has_value());
  Region covered = two_boxes(RegionKind::joined);
  covered.parts.push_back(box_region({0, 0, 0}, {8, 8, 6}));
  EXPECT_FALSE(node_anchor(covered, block()).has_value());
  for (const RegionKind kind : {RegionKind::joined, RegionKind::offset}) {
    Region sizeless = node(kind, {sphere({0, 0, -1}, 0), along(RegionKind::cone, Vec3(0), Vec3(0), 0)});
    EXPECT_NO_FATAL_FAILURE(handles_in_block(sizeless));
  }
}

struct NodeHandlesOnThePage : EditorPages {
  /// The drawn channel, 6 mm along x and 1.6 wide, joined with a cuboid across it and an offset ball. The union is chosen.
  EditorStart composed() const {
    EditorStart start = coarse();
    start.draft.target = node(RegionKind::joined, {start.draft.target, box_region({0, 0, -0.5}, {2, 4, 2}), node(RegionKind::offset, {sphere({2, 0, -1}, 0.8)}, 0.4)}, 0.2);
    return start;
  }
  std::unique_ptr<EditorPage> open_at(const PartPath& path) {
    auto page = open(composed());
    page->model().choose_part(path);
    return page;
  }
  static HandleKnob* knob(const EditorPage& page, const char* name) {
    for (HandleKnob* one : knobs_of(*page.stage()))
      if (one->accessibleName() == QLatin1String(name)) return one;
    return nullptr;
  }
};

TEST_F(NodeHandlesOnThePage, a_drag_moves_the_whole_union_as_one_step_of_undo) {
  const auto page = open_at({});
  const Region before = page->model().chosen();
  HandleKnob* place = knob(*page, "Place of all shapes");
  ASSERT_NE(place, nullptr);
  const QPoint start = place->pos(), middle = place->rect().center();
  QTest::mousePress(place, Qt::LeftButton, {}, middle);
  for (int i = 1; i <= 3; ++i) QTest::mouseMove(place, middle + QPoint(10, 4));
  QTest::mouseRelease(place, Qt::LeftButton, {}, middle);
  const Region after = page->model().chosen();
  const Vec3 way = after.parts[1].from_mm - before.parts[1].from_mm;
  EXPECT_GT(glm::length(way), 0.05);
  EXPECT_LT(glm::length(after.parts[2].parts[0].from_mm - before.parts[2].parts[0].from_mm - way), 1e-9);
  EXPECT_LT(glm::length(after.parts[0].outline.paths[0][0] - before.parts[0].outline.paths[0][0] - way), 1e-9);
  EXPECT_GT((place->pos() - start).x(), 5);
  EXPECT_EQ(page->model().stack().count(), 1);
  page->model().stack().undo();
  EXPECT_EQ(page->model().chosen(), before);
}

TEST_F(NodeHandlesOnThePage, rounding_and_growth_go_with_the_hand_along_their_line) {
  const auto page = open_at({});
  EditorModel& model = page->model();
  for (const auto& [path, name, mm] : {std::tuple(PartPath{}, "Rounding of the edges", 0.3), std::tuple(PartPath{2}, "Grown by", -0.6)}) {
    model.choose_part(path);
    const auto value = [&model] { return model.chosen().kind == RegionKind::offset ? model.chosen().by_mm : model.chosen().rounding_mm; };
    HandleKnob* handle = knob(*page, name);
    ASSERT_NE(handle, nullptr);
    const double before = value();
    const int steps = model.stack().count();
    const TargetHandle at = handle->handle();
    const QPointF way = *page->stage()->view()->project(at.at_mm + mm * at.along) - *page->stage()->view()->project(at.at_mm);
    const QPoint middle = handle->rect().center();
    QTest::mousePress(handle, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + way, handle->mapToGlobal(middle + way), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(handle, &move);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, middle);
    EXPECT_NEAR(value(), before + mm, 0.011) << name << ": rounded to a step of 0.01 mm";
    EXPECT_EQ(model.stack().count(), steps + 1) << name;
  }
}

TEST_F(NodeHandlesOnThePage, arrow_keys_move_round_and_grow_and_names_say_so) {
  const auto page = open_at({});
  EditorModel& model = page->model();
  const Region before = model.chosen();
  QTest::keyClick(knob(*page, "Place of all shapes"), Qt::Key_Right);
  const Vec3 way = model.chosen().parts[1].from_mm - before.parts[1].from_mm;
  EXPECT_NEAR(glm::length(way), 0.05, 1e-9);
  EXPECT_EQ(model.chosen(), shifted(before, way));
  HandleKnob* rounding = knob(*page, "Rounding of the edges");
  ASSERT_NE(rounding, nullptr);
  QTest::keyClick(rounding, Qt::Key_Up);
  QTest::keyClick(rounding, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(model.chosen().rounding_mm, 0.24);
  EXPECT_TRUE(rounding->accessibleDescription().contains(QStringLiteral("0.24"))) << rounding->accessibleDescription().toStdString();
  model.choose_part({2});
  HandleKnob* growth = knob(*page, "Grown by");
  ASSERT_NE(growth, nullptr);
  QTest::keyClick(growth, Qt::Key_Right);
  EXPECT_DOUBLE_EQ(model.chosen().by_mm, 0.45);
  EXPECT_EQ(model.stack().count(), 4) << "each key is a step of its own";
  while (model.stack().canUndo()) model.stack().undo();
  EXPECT_EQ(model.scenario().target, before);
}

TEST_F(NodeHandlesOnThePage, numbers_move_the_union_as_its_handle_does) {
  const auto page = open_at({});
  const Region before = page->model().chosen();
  const Vec3 middle = *middle_of_leaves(before);
  auto* height = named<NumberField>(*page, "Place of all shapes: Height");
  ASSERT_NE(height, nullptr);
  EXPECT_TRUE(height->isVisible());
  EXPECT_DOUBLE_EQ(height->value(), middle.z);
  height->setValue(middle.z - 0.35);
  EXPECT_EQ(page->model().chosen(), shifted(before, {0, 0, -0.35}));
  EXPECT_EQ(page->model().stack().count(), 1);
  page->model().choose_part({1});
  EXPECT_FALSE(height->isVisible());
}

TEST_F(NodeHandlesOnThePage, place_of_all_shapes_goes_to_a_landmark_by_key) {
  EditorStart start = coarse();
  start.draft = *load_builtin("class-2-46-mo");
  start.draft.specimen.voxel_mm = 0.4;
  start.published = start.draft;
  const auto page = open(start);
  page->model().choose_part({});
  HandleKnob* place = knob(*page, "Place of all shapes");
  ASSERT_NE(place, nullptr);
  const Region before = page->model().chosen();
  place->setFocus();
  QTest::keyClick(place, Qt::Key_L);
  const Vec3 way = *middle_of_leaves(page->model().chosen()) - *middle_of_leaves(before);
  EXPECT_GT(glm::length(way), 0.01);
  EXPECT_EQ(page->model().chosen(), shifted(before, way));
  EXPECT_TRUE(place->accessibleDescription().contains(u';')) << "a landmark: " << place->accessibleDescription().toStdString();
}

}  // namespace
}  // namespace cusp::test
