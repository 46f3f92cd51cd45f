// Faces of a target that a fault moves or tilts: where the changed region ends.

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/operators/faulty_target.h"
#include "scenarios/shapes/region.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

bool is_floor_of_pulp(FaceName face) { return face == FaceName::pulpal_floor; }
bool is_wall(FaceName face) { return !is_floor(face); }

Region box() {
  Region out;
  out.kind = RegionKind::box;
  out.from_mm = {0, 0, 0};
  out.size_mm = {4, 2, 2};
  return out;
}

Region slot() {
  Outline out;
  out.paths = {{{-2, 0, 0}, {2, 0, 0}}};
  return scenarios::region_of(out);
}

bool holds(const Region& region, Vec3 p) { return RegionShape(region).near(p).distance_mm <= 0.0; }

TEST(FaultyTarget, MovesTheChosenFacesAlone) {
  Region deep = box();
  ASSERT_TRUE(move_faces(deep, is_floor_of_pulp, 0.5));
  EXPECT_TRUE(holds(deep, {0, 0, -1.49}));
  EXPECT_FALSE(holds(deep, {0, 0, -1.51}));
  EXPECT_TRUE(holds(deep, {0, 0.99, 0.99}));
  EXPECT_FALSE(holds(deep, {0, 1.01, 0}));
  EXPECT_FALSE(holds(deep, {0, 0, 1.01}));
  Region wide = slot();
  ASSERT_TRUE(move_faces(wide, is_wall, 0.2));
  EXPECT_DOUBLE_EQ(wide.outline.width_mm, 1.6) << "both walls of 1.2";
  EXPECT_DOUBLE_EQ(wide.outline.depth_mm, 2.0);
}

TEST(FaultyTarget, TurnsTheFacesOfWhatIsTakenOff) {
  Region left = without(box(), grown(box(), -0.5));
  ASSERT_TRUE(move_faces(left, is_floor_of_pulp, 0.2));
  EXPECT_TRUE(holds(left, {0, 0, -1.1})) << "the outer floor is lower";
  EXPECT_TRUE(holds(left, {0, 0, -0.4})) << "the inner one higher";
}

TEST(FaultyTarget, LeavesHalfSpacesAndVoxels) {
  Region plane;
  plane.kind = RegionKind::half_space;
  EXPECT_FALSE(move_faces(plane, [](FaceName) { return true; }, 1.0));
  Region enamel = scenarios::region_of(Tissue::enamel);
  EXPECT_FALSE(move_faces(enamel, [](FaceName) { return true; }, 1.0));
  EXPECT_FALSE(tilt_walls(enamel, 5.0));
}

TEST(FaultyTarget, TiltsAWallAboutItsLowerEdge) {
  const double tangent = std::tan(10.0 * 3.14159265358979 / 180.0);
  Region tilted = box();
  ASSERT_TRUE(tilt_walls(tilted, 10.0));
  for (const double up : {0.1, 1.0, 1.9}) {
    EXPECT_TRUE(holds(tilted, {0, 1.0 + up * tangent - 0.01, -1.0 + up})) << up;
    EXPECT_FALSE(holds(tilted, {0, 1.0 + up * tangent + 0.01, -1.0 + up})) << up;
    EXPECT_FALSE(holds(tilted, {0, -1.01, -1.0 + up})) << "the wall across stands";
  }
  Region outline = slot();
  ASSERT_TRUE(tilt_walls(outline, 10.0));
  EXPECT_TRUE(holds(outline, {0, 0.6 + tangent - 0.01, -1.0}));
  EXPECT_FALSE(holds(outline, {0, 0.6 + tangent + 0.01, -1.0}));
  EXPECT_FALSE(holds(outline, {0, -0.61, -1.0}));
}

}  // namespace
}  // namespace cusp::test
