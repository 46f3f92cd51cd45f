// The handles of a target: what each moves, and what it leaves where it was.

#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "ui/editor/target_handles.h"

namespace cusp::test {
namespace {

TEST(target_handles, each_handle_moves_what_it_is_named_for_and_nothing_else) {
  Outline t = load_builtin("channel-1")->target.outline;  // 6 mm along x, 1.6 wide, 2 deep, top 0
  const auto find = [](const Outline& of, TargetHandle::Kind kind) {
    for (const TargetHandle& h : handles_of(of)) {
      if (h.kind == kind) return h;
    }
    return TargetHandle{};
  };
  EXPECT_EQ(handles_of(t).size(), 4u);  // two ends, width, depth
  const Outline wide = moved(t, find(t, TargetHandle::Kind::width), {0, 1.0, 0});
  EXPECT_DOUBLE_EQ(wide.width_mm, 2.0);
  EXPECT_EQ(wide.paths, t.paths);
  const Outline deep = moved(t, find(t, TargetHandle::Kind::depth), {0, 0, -2.5});
  EXPECT_DOUBLE_EQ(deep.depth_mm, 2.5);
  EXPECT_DOUBLE_EQ(deep.paths[0][0].z, -2.5);
  EXPECT_DOUBLE_EQ(moved(t, find(t, TargetHandle::Kind::depth), {0, 0, 5}).depth_mm, kLeastHandleMm);
  const Outline bent = moved(t, handles_of(t)[0], {-2.504, 1.006, 7});
  EXPECT_DOUBLE_EQ(bent.paths[0][0].x, -2.5);
  EXPECT_DOUBLE_EQ(bent.paths[0][0].y, 1.01);
  EXPECT_DOUBLE_EQ(bent.paths[0][0].z, -2);
  EXPECT_EQ(bent.paths[0][1], t.paths[0][1]);
}

TEST(target_handles, where_lines_meet_one_handle_moves_them_all) {
  const Outline t = load_builtin("class-1-36")->target.outline;
  std::size_t points = 0;
  for (const auto& path : t.paths) points += path.size();
  // Three branches begin on points of the long line: 15 points, 12 places; width and depth besides.
  EXPECT_EQ(points, 15u);
  ASSERT_EQ(handles_of(t).size(), 14u);
  for (const TargetHandle& h : handles_of(t)) {
    if (h.kind != TargetHandle::Kind::point || h.path != 0 || h.point != 5) continue;  // (0.74, 0.05)
    const Outline out = moved(t, h, {0.8, 0.1, t.top_mm});
    EXPECT_DOUBLE_EQ(out.paths[0][5].x, 0.8);
    EXPECT_DOUBLE_EQ(out.paths[1][0].x, 0.8);
    EXPECT_EQ(out.paths[2], t.paths[2]);
  }
}

TEST(target_handles, a_box_is_moved_by_its_middle_and_sized_by_its_sides) {
  EditorModel model(class_one());
  ASSERT_TRUE(model.set_shape("box"));
  const Outline t = model.scenario().target.outline;
  const auto handles = handles_of(t);
  ASSERT_EQ(handles.size(), 4u);
  const Outline longer = moved(t, handles[1], t.paths[0][0] + Vec3(2, 0, 0));
  EXPECT_DOUBLE_EQ(longer.box_size_mm.x, 4.0);
  EXPECT_DOUBLE_EQ(longer.box_size_mm.y, t.box_size_mm.y);
  EXPECT_EQ(moved(t, handles[0], {1, 1, 0}).box_size_mm, t.box_size_mm);
}

}  // namespace
}  // namespace cusp::test
