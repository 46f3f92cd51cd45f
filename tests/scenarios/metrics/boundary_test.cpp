// The target's own boundary, of which the uncertainty of target_removed and uncut_remainder is made.

#include <gtest/gtest.h>

#include <numbers>

#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

TEST(Boundary, OfABoxWhoseWallsPassMidwayBetweenVoxelsIsNoLargerThanItsFaces) {
  constexpr double kRadius = 0.3;  // of the line angle
  Grid grid;
  grid.size = IVec3(60, 60, 40);
  grid.origin_mm = Vec3(-2.95, -2.95, -3.95);  // the block fills its grid
  const auto specimen = carved::specimen(grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -2), Vec3(3, 3, 2)); },
                                         [](Vec3) { return Tissue::enamel; });
  const Scenario s = box_exercise_on_36({3, 2, 1.5}, {Tissue::enamel, 3, 0.5});
  const Reference reference(s, specimen);
  const double walls_mm = 2.0 * (3.0 + 2.0), exact = walls_mm * 1.5 + 3.0 * 2.0 - walls_mm * (2.0 - 0.5 * std::numbers::pi) * kRadius;
  EXPECT_GT(reference.target_boundary_mm2(), 0.8 * exact);  // measured 17.1 of 19.7: faces on a plane of samples count in part
  EXPECT_LT(reference.target_boundary_mm2(), exact);

  Volume volume(specimen);
  const OutlineShape box(s.target.outline);
  carved::carve(volume, [&](Vec3 p) { return box.distance_mm(p); });
  for (const Measure& m : measure(reference, volume, {})) {
    if (m.metric == "target_removed") {
      EXPECT_NEAR(m.value, 100.0, m.uncertainty);
      EXPECT_LT(m.uncertainty, 0.5);  // %; measured 0.31
    }
    if (m.metric == "uncut_remainder") {
      EXPECT_LT(m.uncertainty, 0.05);  // mm3, of 8.8; measured 0.03
    }
  }
}

}  // namespace
}  // namespace cusp::test
