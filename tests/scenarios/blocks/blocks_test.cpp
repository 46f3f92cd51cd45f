#include "scenarios/blocks/blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/volume/specimen.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

std::map<Tissue, std::size_t> occupied(const VoxelVolume& volume) {
  std::map<Tissue, std::size_t> out;
  for (std::size_t i = 0; i < volume.s.size(); ++i)
    if (volume.s[i] >= kHalf) ++out[volume.tissue[i]];
  return out;
}

/// Distance to a box by clamping to it, or to its nearest face from inside: another way than the generator's.
double box_distance(Vec3 at, Vec3 low, Vec3 high) {
  const Vec3 nearest = glm::clamp(at, low, high);
  if (nearest != at) return glm::length(at - nearest);
  double least = 1e9;
  for (int i = 0; i < 3; ++i) least = std::min({least, at[i] - low[i], high[i] - at[i]});
  return -least;
}

void expect_distances(const VoxelVolume& volume, Vec3 low, Vec3 high) {
  // One step of s: the band is 5.5 voxels in 65535.
  const double step = 2.0 * kBandVoxels / 65535.0;
  IVec3 v;
  std::size_t wrong = 0;
  for (v.z = 0; v.z < volume.grid.size.z; ++v.z)
    for (v.y = 0; v.y < volume.grid.size.y; ++v.y)
      for (v.x = 0; v.x < volume.grid.size.x; ++v.x) {
        const double d = box_distance(volume.grid.centre_mm(v), low, high) / volume.grid.voxel_mm;
        const double expected = std::clamp(d, -kBandVoxels, kBandVoxels);
        const std::size_t i = volume.grid.index(v);
        if (std::abs(distance_from_solid(volume.s[i]) - expected) > step) ++wrong;
        if ((volume.tissue[i] != Tissue::empty) != (volume.s[i] > 0)) ++wrong;
      }
  EXPECT_EQ(wrong, 0u);
}

TEST(PaperBlock, HasTheVoxelsOfThePaper) {
  const VoxelVolume block = paper_block();
  EXPECT_EQ(block.grid.size, IVec3(136));              // 128 and four of padding on each side
  EXPECT_DOUBLE_EQ(block.grid.voxel_mm, 0.078125);     // paper, section 4: 10 mm / 128
  std::size_t all = 0;
  for (const auto& [tissue, n] : occupied(block)) all += n;
  EXPECT_EQ(all, 128u * 128u * 128u);
}

TEST(PaperBlock, StacksDentineOnBoneOnEnamelInThirds) {
  const auto n = occupied(paper_block());
  // 3.33 mm are 42.67 voxels: voxel centres n + 1/2 below 42.67, then below 85.33: 43, 42 and 43 layers.
  EXPECT_EQ(n.at(Tissue::dentine), 43u * 128u * 128u);
  EXPECT_EQ(n.at(Tissue::bone), 42u * 128u * 128u);
  EXPECT_EQ(n.at(Tissue::enamel), 43u * 128u * 128u);
  const VoxelVolume block = paper_block();
  EXPECT_EQ(block.tissue[block.grid.index({68, 68, 131})], Tissue::dentine);  // the uppermost layer
  EXPECT_EQ(block.tissue[block.grid.index({68, 68, 4})], Tissue::enamel);     // the lowest
}

TEST(PaperBlock, IsTheExactDistanceOfItsBox) {
  expect_distances(paper_block(), Vec3(-5.0, -5.0, -10.0), Vec3(5.0, 5.0, 0.0));
}

TEST(PaperBlock, BeginsWithTheSameVoxelsInBothReadings) {
  const VoxelVolume block = paper_block();
  const auto filled = Specimen::build(block, Reading::filled), banded = Specimen::build(block, Reading::banded);
  std::size_t differing = 0;
  IVec3 v;
  for (v.z = 0; v.z < 136; ++v.z)
    for (v.y = 0; v.y < 136; ++v.y)
      for (v.x = 0; v.x < 136; ++v.x) differing += (filled->s(v) > 0) != (banded->s(v) >= kHalf);
  EXPECT_EQ(differing, 0u);
}

TEST(DexterityBlock, IsPlasticWithItsTopAtZero) {
  const VoxelVolume block = dexterity_block();
  EXPECT_EQ(block.grid.size, IVec3(208, 208, 108));
  const auto n = occupied(block);
  ASSERT_EQ(n.size(), 1u);
  EXPECT_EQ(n.at(Tissue::plastic), 200u * 200u * 100u);
  expect_distances(block, Vec3(-10.0, -10.0, -10.0), Vec3(10.0, 10.0, 0.0));
}

TEST(DexterityBlock, KeepsItsFacesWhenTheVoxelDoesNotDivideThem) {
  for (const double voxel_mm : {0.17, 0.3, 1.0}) {
    const VoxelVolume block = dexterity_block(voxel_mm);
    expect_distances(block, Vec3(-10.0, -10.0, -10.0), Vec3(10.0, 10.0, 0.0));
    // Nothing of the band is cut off by the grid.
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.grid.size.x) * static_cast<std::size_t>(block.grid.size.y); ++i)
      ASSERT_EQ(block.s[i] | block.s[block.s.size() - 1 - i], 0);
  }
}

TEST(LayeredBlock, IsTheDexterityBlockWithAHardLayerOfAMillimetre) {
  const double h = 0.25;
  const VoxelVolume plain = dexterity_block(h), layered = layered_block(h);
  EXPECT_EQ(plain.grid, layered.grid);
  EXPECT_EQ(plain.s, layered.s);
  auto count = occupied(layered);
  // 80 x 80 voxels in a layer, four layers of 0.25 mm above, thirty-six below.
  EXPECT_EQ(count[Tissue::composite], 80u * 80u * 4u);
  EXPECT_EQ(count[Tissue::plastic], 80u * 80u * 36u);
}

}  // namespace
}  // namespace cusp::test
