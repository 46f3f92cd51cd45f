#include "scenarios/metrics/recover_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/import/label_map.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

/// A block with a bevelled top, so that base and cut meet at several angles.
double bevelled(Vec3 p) {
  const double block = box_distance(p, Vec3(0, 0, -1.7), Vec3(3.5, 2.3, 1.7));
  return std::max(block, (p.z + 0.4 * p.y) / std::sqrt(1.16) - 0.1);
}
double cavity(Vec3 p) { return std::max(box_distance(p, Vec3(0, 0, 0), Vec3(1.5, 0.8, 1.8)), -2.0); }

std::shared_ptr<const Specimen> bevelled_block(Reading reading = Reading::banded) {
  Grid grid;
  grid.size = IVec3(80, 56, 44);
  grid.origin_mm = Vec3(-3.97, -2.76, -3.83);
  return carved::specimen(grid, reading, bevelled, [](Vec3) { return Tissue::dentine; });
}

Scenario exercise_on_block() { return box_exercise_on_36({3, 1.6, 1.8}, {Tissue::dentine, 2, 1.6}); }

TEST(RecoverCut, GivesTheMeasuresOfTheVolumeThatTheFileHolds) {
  const Scenario scenario = exercise_on_block();
  for (const Reading reading : {Reading::banded, Reading::filled}) {
    const auto specimen = bevelled_block(reading);
    Volume volume(specimen);
    carved::carve(volume, cavity);
    const auto recovered = recover_cut(specimen, volume.dense());
    ASSERT_TRUE(recovered);
    const Reference reference(scenario, specimen);
    const auto wanted = measure(reference, volume, {}), got = measure(reference, *recovered, {});
    ASSERT_EQ(wanted.size(), got.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(got[i].measured, wanted[i].measured) << wanted[i].metric;
      // The field beside the mouth is continued, not known: a quarter of the uncertainty is left to it.
      EXPECT_NEAR(got[i].value, wanted[i].value, 0.25 * wanted[i].uncertainty + 1e-6) << wanted[i].metric;
    }
  }
}

TEST(RecoverCut, OfAnUntouchedSpecimenIsNoCut) {
  const auto specimen = bevelled_block();
  const auto recovered = recover_cut(specimen, Volume(specimen).dense());
  ASSERT_TRUE(recovered);
  EXPECT_TRUE(recovered->cut_bricks().empty());
}

TEST(RecoverCut, TakesAFileOfAnotherExtentOnTheSameGrid) {
  const auto specimen = bevelled_block();
  Volume volume(specimen);
  carved::carve(volume, cavity);
  const VoxelVolume whole = volume.dense();
  Grid larger = whole.grid;
  larger.size += IVec3(6, 4, 2);
  larger.origin_mm -= larger.voxel_mm * Vec3(3, 2, 1);
  VoxelVolume shifted(larger);
  IVec3 v;
  for (v.z = 0; v.z < whole.grid.size.z; ++v.z)
    for (v.y = 0; v.y < whole.grid.size.y; ++v.y)
      for (v.x = 0; v.x < whole.grid.size.x; ++v.x) {
        shifted.s[larger.index(v + IVec3(3, 2, 1))] = whole.s[whole.grid.index(v)];
        shifted.tissue[larger.index(v + IVec3(3, 2, 1))] = whole.tissue[whole.grid.index(v)];
      }
  const auto one = recover_cut(specimen, whole), other = recover_cut(specimen, shifted);
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->hash(), other->hash());
}

TEST(RecoverCut, RefusesWhatIsNotOfTheSpecimen) {
  const auto specimen = bevelled_block();
  const VoxelVolume own = Volume(specimen).dense();
  VoxelVolume other = own;
  other.grid.voxel_mm = 0.11;
  EXPECT_EQ(recover_cut(specimen, other).error().code, RecoverError::other_voxel);
  other = own;
  other.grid.origin_mm.x += 0.04;
  EXPECT_EQ(recover_cut(specimen, other).error().code, RecoverError::other_frame);
  other = own;
  other.grid.origin_mm.x += 0.5;  // the block stands half a millimetre out of the specimen
  EXPECT_EQ(recover_cut(specimen, other).error().code, RecoverError::other_tissue);
}

TEST(RecoverCut, RefusesASurfaceThatIsKnownToAVoxelOnly) {
  const auto specimen = bevelled_block();
  const VoxelVolume own = Volume(specimen).dense();
  std::vector<Tissue> codes(own.s.size(), Tissue::empty);
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (own.s[i] >= kHalf) codes[i] = own.tissue[i];
  const VoxelVolume labels = volume_of_labels(own.grid, codes);
  EXPECT_EQ(recover_cut(specimen, labels).error().code, RecoverError::other_surface);
  // A filled specimen has no finer surface.
  EXPECT_TRUE(recover_cut(bevelled_block(Reading::filled), labels));
}

TEST(RecoverCut, RefusesTissueOutsideTheSpecimensGrid) {
  const auto specimen = bevelled_block();
  const VoxelVolume own = Volume(specimen).dense();
  const double own_mm3 = static_cast<double>(std::ranges::count_if(own.s, [](std::uint16_t s) { return s >= kHalf; })) * 1e-3;
  // A metre beside it, and so far that the voxels between cannot be counted: all of the file's tissue is foreign.
  for (const double off_mm : {-1e3, 1e3, 1e9, 1e300}) {
    VoxelVolume other = own;
    other.grid.origin_mm.x += off_mm;
    const auto refused = recover_cut(specimen, other);
    ASSERT_FALSE(refused) << off_mm;
    EXPECT_EQ(refused.error().code, RecoverError::other_tissue) << off_mm;
    EXPECT_NEAR(std::stod(refused.error().detail), own_mm3, 1e-6) << off_mm;  // six printed decimals
  }
}

TEST(RecoverCut, RefusesMoreCutsThanAVolumeKeeps) {
  // 27 x 27 x 24 bricks: 17,496, where a volume keeps 16,384. One voxel of each was cut.
  Grid grid;
  grid.size = IVec3(216, 216, 192);
  VoxelVolume whole(grid);
  std::ranges::fill(whole.s, kSolid);
  std::ranges::fill(whole.tissue, Tissue::plastic);
  const auto specimen = Specimen::build(whole, Reading::filled);
  IVec3 v;
  std::size_t cuts = 0;
  for (v.z = 4; v.z < grid.size.z; v.z += 8)
    for (v.y = 4; v.y < grid.size.y; v.y += 8)
      for (v.x = 4; v.x < grid.size.x; v.x += 8) {
        whole.s[grid.index(v)] = 0;
        ++cuts;
        if (cuts == kMostCutBricks) {
          EXPECT_TRUE(recover_cut(specimen, whole)) << "as many as it keeps";
        }
      }
  ASSERT_GT(cuts, kMostCutBricks);
  const auto refused = recover_cut(specimen, whole);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, RecoverError::too_much_cut);
}

}  // namespace
}  // namespace cusp::test
