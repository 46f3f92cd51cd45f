// Patches of a box that was cut by analysis: their areas and places are known.

#include "scenarios/metrics/evidence_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/measure.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

constexpr double kVoxelMm = 0.1;
const Vec3 kTarget(4.0, 2.0, 1.5);  // along x, along y, depth

/// Half a block of plastic below z = 0, so that a box from above is the whole cut.
std::shared_ptr<const Specimen> block() {
  Grid grid;
  grid.size = {96, 72, 56};
  grid.voxel_mm = kVoxelMm;
  grid.origin_mm = {-4.75, -3.55, -4.45};
  return engine::carved::specimen(
      grid, Reading::banded,
      [](Vec3 p) {
        const Vec3 off = glm::abs(p - Vec3(0, 0, -2)) - Vec3(4.2, 3.0, 2.0);
        return std::max({off.x, off.y, off.z});
      },
      [](Vec3) { return Tissue::plastic; });
}

/// A box `wider_mm` beyond the target on each side and `deeper_mm` below it.
struct Cut {
  double wider_mm = 0, deeper_mm = 0;
};
EvidencePatches patches_of(const Cut& cut) {
  const auto specimen = block();
  auto volume = std::make_shared<Volume>(specimen);
  engine::carved::carve(*volume, [&cut](Vec3 p) {
    return std::max({std::fabs(p.x) - 0.5 * kTarget.x - cut.wider_mm, std::fabs(p.y) - 0.5 * kTarget.y - cut.wider_mm, -kTarget.z - cut.deeper_mm - p.z});
  });
  Scenario s = box_exercise_on_36(kTarget, {Tissue::plastic});
  s.leeway = {0.3, 0.3};
  return {std::make_shared<const Reference>(s, specimen), volume};
}

double mm2_of(const EvidencePatch& patch) {
  double sum = 0;
  for (const auto& t : patch.triangles) sum += 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
  return sum;
}

/// Whether each corner lies there.
template <class IsThere>
bool all_lie(const EvidencePatch& patch, IsThere is_there) {
  return std::ranges::all_of(patch.triangles, [&](const auto& t) { return std::ranges::all_of(t, is_there); });
}

TEST(EvidencePatch, OfAWallIsThatWall) {
  const EvidencePatches patches = patches_of({});
  const EvidencePatch mesial = patches.of("wall_angle_mesial");  // of 36: towards +x
  EXPECT_TRUE(all_lie(mesial, [](Vec3 p) { return std::fabs(p.x - 0.5 * kTarget.x) < 0.05; }));
  // Above the rounded line angle of 0.3 mm and half a voxel; a rim of a voxel at the line angles leans.
  const double height = kTarget.z - 0.35;
  EXPECT_NEAR(mm2_of(mesial), kTarget.y * height, 0.15 * kTarget.y * height);
  EXPECT_NEAR(mm2_of(patches.of("convergence_mesiodistal")), 2 * mm2_of(mesial), 0.05);
}

TEST(EvidencePatch, OfTheFloorIsLevelAndFlat) {
  const EvidencePatch floor = patches_of({}).of("floor_flatness");
  EXPECT_TRUE(all_lie(floor, [](Vec3 p) { return std::fabs(p.z + kTarget.z) < 0.02; }));
  // Off the walls by the rounded line angle less a quarter of a voxel.
  const double inset = 2 * (0.3 - 0.25 * kVoxelMm);
  EXPECT_NEAR(mm2_of(floor), (kTarget.x - inset) * (kTarget.y - inset), 0.3);
  EXPECT_EQ(patches_of({}).of("depth_mean").triangles.size(), floor.triangles.size());
}

TEST(EvidencePatch, OfAnOvercutIsTheCutInThatZoneAlone) {
  const EvidencePatches deep = patches_of({.deeper_mm = 0.2});
  const EvidencePatch tolerated = deep.of("overcut_leeway_floor");
  EXPECT_TRUE(deep.of("overcut_beyond_floor").empty());
  EXPECT_TRUE(all_lie(tolerated, [](Vec3 p) { return p.z < -kTarget.z + 0.05; }));
  EXPECT_GT(mm2_of(tolerated), 0.8 * kTarget.x * kTarget.y);
  // A cut on the target's surface is none; sharp where the target's line angle is rounded by 0.3 mm, it is.
  EXPECT_TRUE(all_lie(patches_of({}).of("overcut_leeway_floor"),
                      [](Vec3 p) { return std::fabs(p.x) > 0.5 * kTarget.x - 0.35 || std::fabs(p.y) > 0.5 * kTarget.y - 0.35; }));
  const EvidencePatches deeper = patches_of({.deeper_mm = 0.5});
  EXPECT_GT(mm2_of(deeper.of("overcut_beyond_floor")), 0.8 * kTarget.x * kTarget.y);
  EXPECT_GT(mm2_of(deeper.of("overcut_beyond_pulpal_floor")), 0.8 * kTarget.x * kTarget.y);
  const EvidencePatch wide = patches_of({.wider_mm = 0.5}).of("overcut_beyond_side");
  EXPECT_GT(mm2_of(wide), 0.7 * 2 * (kTarget.x + kTarget.y) * kTarget.z);
  EXPECT_TRUE(all_lie(wide, [](Vec3 p) { return std::fabs(p.x) > 0.5 * kTarget.x || std::fabs(p.y) > 0.5 * kTarget.y; }));
}

TEST(EvidencePatch, OfTheSurfaceIsWhatIsFurtherOff) {
  const EvidencePatches patches = patches_of({.wider_mm = 0.25});
  EXPECT_GT(mm2_of(patches.of("surface_within_200")), 0.7 * 2 * (kTarget.x + kTarget.y) * kTarget.z);
  EXPECT_TRUE(patches.of("surface_within_500").empty()) << "a corner is sqrt(3) * 0.25 mm off";
  EXPECT_TRUE(patches_of({}).of("surface_p95").empty());
}

TEST(EvidencePatch, OfARemainderIsTheSurfaceOfWhatStands) {
  const EvidencePatches shallow = patches_of({.deeper_mm = -0.5});
  const EvidencePatch left = shallow.of("uncut_remainder");
  EXPECT_NEAR(mm2_of(left), kTarget.x * kTarget.y, 0.15 * kTarget.x * kTarget.y);
  EvidencePatch aloft = left;  // voxels round the upright edges of the cut
  std::erase_if(aloft.triangles, [](const auto& t) { return t[0].z < -kTarget.z + 0.55; });
  EXPECT_LT(mm2_of(aloft), 0.05 * mm2_of(left));
  EXPECT_EQ(shallow.of("target_removed").triangles.size(), left.triangles.size());
  // Nothing cut: the tooth's own surface over the target.
  const auto specimen = block();
  const EvidencePatches idle(std::make_shared<const Reference>(box_exercise_on_36(kTarget, {Tissue::plastic}), specimen), std::make_shared<Volume>(specimen));
  const EvidencePatch whole = idle.of("target_removed");
  EXPECT_TRUE(all_lie(whole, [](Vec3 p) { return std::fabs(p.z) < 0.05; }));
  EXPECT_NEAR(mm2_of(whole), kTarget.x * kTarget.y, 0.15 * kTarget.x * kTarget.y);
}

TEST(EvidencePatch, OfAWidthIsTheLineThatIsMeasured) {
  const EvidencePatch width = patches_of({}).of("isthmus_width");
  ASSERT_EQ(width.lines.size(), 1u);
  EXPECT_NEAR(glm::length(width.lines[0][1] - width.lines[0][0]), kTarget.y, 0.1);
  const EvidencePatch ridge = patches_of({}).of("ridge_mesial");
  ASSERT_EQ(ridge.lines.size(), 1u);
  EXPECT_NEAR(ridge.lines[0][1].x - ridge.lines[0][0].x, 4.2 - 0.5 * kTarget.x, 0.05) << "from wall to proximal face";
}

TEST(EvidencePatch, OfWhatHasNoneIsEmpty) {
  const EvidencePatches patches = patches_of({});
  for (const char* metric : {"time", "force_peak", "remaining_over_pulp", "no such"}) EXPECT_TRUE(patches.of(metric).empty()) << metric;
}

}  // namespace
}  // namespace cusp::test
