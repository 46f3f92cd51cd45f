// The target's own boundary, of which the uncertainty of target_removed and uncut_remainder is made.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

/// A cube of enamel, 1.6 mm wide about the origin.
constexpr double kCubeMm = 1.6;

/// The boundary's area of a target in the cube. `shift_voxels`: of the grid against both.
double boundary_mm2(const Region& target, double voxel_mm, Vec3 shift_voxels) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  grid.size = IVec3(static_cast<int>(std::lround(kCubeMm / voxel_mm)) + 9);
  grid.origin_mm = Vec3(-0.5 * kCubeMm) + voxel_mm * (shift_voxels - 4.5);
  const auto specimen = carved::specimen(grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0.0), Vec3(0.5 * kCubeMm)); },
                                         [](Vec3) { return Tissue::enamel; });
  Scenario s = box_exercise_on_36({1, 1, 1}, {Tissue::enamel, 3, 0.5});
  s.target = target;
  return Reference(s, specimen).target_boundary_mm2();
}

/// Of the grid against the target, in voxels: 0.5 has planes of samples in the target's faces.
constexpr std::array kOffsets = {0.0, 0.25, 0.4, 0.5, 0.6, 0.75, 1.0};
constexpr std::array kVoxelsMm = {0.05, 0.1, 0.2};

TEST(Boundary, OfAPlaneIsItsSectionWhereverItPassesBetweenVoxels) {
  // A sharp edge of the cube loses 0.14 voxel² (engine/volume/cut_volume.h), and the plane passes over four of them. Measured:
  // 0.44 voxel² at most, whatever the offset and the lean.
  constexpr double kLostVoxels2 = 0.6;
  for (const double voxel_mm : kVoxelsMm)
    for (const double offset : kOffsets)
      for (const Vec3 up : {Vec3(0, 0, 1), Vec3(0.02, 0, 1), Vec3(0.25, 0, 1), Vec3(0.3, 0.3, 1), Vec3(0.1, -0.45, 1)}) {
        const Vec3 normal = glm::normalize(up);
        Region below = box_region(-5.0 * normal, {20, 20, 10});
        below.z_axis = normal;
        const double exact = kCubeMm * kCubeMm / normal.z;
        const double found = boundary_mm2(below, voxel_mm, {0, 0, offset});
        EXPECT_NEAR(found, exact, kLostVoxels2 * voxel_mm * voxel_mm) << voxel_mm << " mm, offset " << offset << ", " << up.x << ' ' << up.y;
      }
}

TEST(Boundary, OfACylinderAndASphereIsTheirSurfaceButForItsChords) {
  constexpr double kRadius = 0.6;
  const double tube = 2.0 * std::numbers::pi * kRadius * kCubeMm, ball = 4.0 * std::numbers::pi * kRadius * kRadius;
  for (const double voxel_mm : kVoxelsMm)
    for (const double offset : kOffsets) {
      SCOPED_TRACE(testing::Message() << voxel_mm << " mm, offset " << offset);
      const double bend = voxel_mm * voxel_mm / (kRadius * kRadius);
      EXPECT_NEAR(boundary_mm2(along(RegionKind::cylinder, {0, 0, -5}, {0, 0, 5}, kRadius), voxel_mm, {offset, 0.3, 0.2}), tube, 0.03 * bend * tube);  // measured 0.016
      EXPECT_NEAR(boundary_mm2(sphere(Vec3(0.0), kRadius), voxel_mm, {0.2, 0.3, offset}), ball, 0.1 * bend * ball);  // measured 0.065
    }
}

TEST(Boundary, OfABoxWhoseWallsPassMidwayBetweenVoxelsIsThatOfItsFaces) {
  constexpr double kRadius = 0.3;  // of the line angle
  Grid grid;
  grid.size = IVec3(60, 60, 40);
  grid.origin_mm = Vec3(-2.95, -2.95, -3.95);  // the block fills its grid
  const auto specimen = carved::specimen(grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -2), Vec3(3, 3, 2)); },
                                         [](Vec3) { return Tissue::enamel; });
  const Scenario s = box_exercise_on_36({3, 2, 1.5}, {Tissue::enamel, 3, 0.5});
  const Reference reference(s, specimen);
  const double walls_mm = 2.0 * (3.0 + 2.0), exact = walls_mm * 1.5 + 3.0 * 2.0 - walls_mm * (2.0 - 0.5 * std::numbers::pi) * kRadius;
  EXPECT_NEAR(reference.target_boundary_mm2(), exact, 0.01 * exact);  // measured 19.61 of 19.71: chords across its edges

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
