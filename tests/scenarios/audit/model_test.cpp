// What a model's choices make of a volume.

#include "scenarios/audit/model.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A cube of enamel over dentine with a core of pulp in the dentine, 12 voxels each way.
VoxelVolume layers() {
  Grid grid;
  grid.size = {12, 12, 12};
  VoxelVolume v(grid);
  std::size_t at = 0;
  for (int z = 0; z < 12; ++z)
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x, ++at) {
        const bool core = x >= 4 && x < 8 && y >= 4 && y < 8 && z >= 2 && z < 5;
        v.tissue[at] = z >= 8 ? Tissue::enamel : core ? Tissue::pulp : Tissue::dentine;
        v.s[at] = kSolid;
      }
  return v;
}

std::ptrdiff_t count(const VoxelVolume& v, Tissue t) { return std::ranges::count(v.tissue, t); }

TEST(LeftOut, ATissueBecomesWhatItTouchesMost) {
  const VoxelVolume v = layers();
  Model m;
  m.left_out = {Tissue::pulp};
  const VoxelVolume out = prepared(v, m);
  EXPECT_EQ(count(out, Tissue::pulp), 0);
  EXPECT_EQ(count(out, Tissue::dentine), 12 * 12 * 8);  // all below the enamel
  EXPECT_EQ(count(out, Tissue::enamel), 12 * 12 * 4);
  m.left_out = {Tissue::enamel};
  EXPECT_EQ(count(prepared(v, m), Tissue::dentine), 12 * 12 * 12 - 4 * 4 * 3);
}

TEST(LeftOut, TheOnlyTissueStays) {
  VoxelVolume v = layers();
  std::ranges::fill(v.tissue, Tissue::plastic);
  Model m;
  m.left_out = {Tissue::plastic};
  EXPECT_EQ(count(prepared(v, m), Tissue::plastic), 12 * 12 * 12);
}

TEST(Band, ANarrowerOneKeepsTheSurfaceAndKnowsLessAboutIt) {
  Grid grid;
  grid.size = {8, 1, 1};
  VoxelVolume v(grid);
  for (int x = 0; x < 8; ++x) {
    v.s[static_cast<std::size_t>(x)] = solid_from_distance(x - 3.25);
    v.tissue[static_cast<std::size_t>(x)] = v.s[static_cast<std::size_t>(x)] > 0 ? Tissue::plastic : Tissue::empty;
  }
  Model m;
  m.band_voxels = kBandVoxels / 2;  // 1.375: places 2 to 4 lie within it
  const VoxelVolume out = prepared(v, m);
  for (const int x : {0, 1}) EXPECT_EQ(out.s[static_cast<std::size_t>(x)], kSolid) << x;
  for (const int x : {2, 3, 4}) EXPECT_EQ(out.s[static_cast<std::size_t>(x)], v.s[static_cast<std::size_t>(x)]) << x;
  for (const int x : {5, 6, 7}) {
    EXPECT_EQ(out.s[static_cast<std::size_t>(x)], 0) << x;
    EXPECT_EQ(out.tissue[static_cast<std::size_t>(x)], Tissue::empty) << x;
  }
}

TEST(Region, KeepsWhatLiesNearTheTargetAndWhereItLies) {
  Scenario s = *load_builtin("line-1");
  s.specimen.voxel_mm = 0.4;
  const VoxelVolume whole = *make_specimen(s.specimen, {});
  Model m{s};
  m.near_target_only = true;
  const VoxelVolume near = prepared(whole, m);
  EXPECT_LT(near.grid.voxels(), whole.grid.voxels() / 3);
  // A voxel of the crop is the voxel of the whole at the same place.
  const IVec3 at(near.grid.size.x / 2, near.grid.size.y / 2, near.grid.size.z / 2);
  const Vec3 place = near.grid.centre_mm(at);
  const Vec3 in_whole = (place - whole.grid.origin_mm) / whole.grid.voxel_mm;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(in_whole[i], std::round(in_whole[i]), 1e-9);
  const IVec3 there(in_whole + Vec3(0.5));
  EXPECT_EQ(near.s[near.grid.index(at)], whole.s[whole.grid.index(there)]);
}

/// The target follows the lesion: it has a place only in the specimen's voxels.
TEST(Region, IsCroppedToATargetThatFollowsALesion) {
  Scenario s = *load_builtin("caries-26");
  s.specimen.voxel_mm = 0.4;
  const VoxelVolume whole = *make_specimen(s.specimen, {});
  Model m{s};
  m.near_target_only = true;
  EXPECT_LT(prepared(whole, m).grid.voxels(), whole.grid.voxels() * 3 / 4);
}

TEST(With, TakingTheSpindleAwayTakesWhatNeedsIt) {
  Model m;
  m.scenario.phenomena = {"friction", "spindle-slow", "vibration", "sound", "heat"};
  EXPECT_EQ(with(m, {Aspect::spindle, "spindle-slow", 1, 0}).scenario.phenomena, (std::vector<std::string>{"friction", "heat"}));
  EXPECT_EQ(with(m, {Aspect::vibration, {}, 1, 0}).scenario.phenomena.size(), 4u);
}

}  // namespace
}  // namespace cusp::test
