// The occupancy map against its definition: a boundary voxel is occupied and has an external one among its 26
// neighbours.
#include "engine/volume/occupancy.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <random>

namespace cusp::test {
namespace {

constexpr IVec3 kSize(45, 38, 33);

std::shared_ptr<const Specimen> block_with_hollow() {
  VoxelVolume dense(Grid{kSize, 0.1, Vec3(0.0)});
  IVec3 v;
  for (v.z = 0; v.z < kSize.z; ++v.z)
    for (v.y = 0; v.y < kSize.y; ++v.y)
      for (v.x = 0; v.x < kSize.x; ++v.x) {
        // Brick by brick at x = 8 and y = 32, off the bricks elsewhere, up to the box's edge at z = 32.
        const bool block = v.x >= 8 && v.y < 32 && v.z >= 3;
        const bool hollow = glm::length(Vec3(v) - Vec3(27.0, 15.0, 20.0)) < 6.2;
        if (!block || hollow) continue;
        dense.s[dense.grid.index(v)] = kSolid;
        dense.tissue[dense.grid.index(v)] = Tissue::dentine;
      }
  return Specimen::build(dense, Reading::filled);
}

VoxelClass by_definition(const Volume& volume, IVec3 v) {
  if (!volume.occupied(v)) return VoxelClass::external;
  for (int i = 0; i < 27; ++i)
    if (!volume.occupied(v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1))) return VoxelClass::boundary;
  return VoxelClass::internal;
}

void expect_as_defined(const Occupancy& map, const Volume& volume) {
  int count[3] = {0, 0, 0};
  IVec3 v;
  for (v.z = -1; v.z <= kSize.z; ++v.z)
    for (v.y = -1; v.y <= kSize.y; ++v.y)
      for (v.x = -1; v.x <= kSize.x; ++v.x) {
        const VoxelClass expected = by_definition(volume, v);
        ASSERT_EQ(map.of(v), expected) << v.x << ' ' << v.y << ' ' << v.z;
        ASSERT_EQ(map.occupied(v), expected != VoxelClass::external);
        ++count[static_cast<int>(expected)];
      }
  for (const int n : count) EXPECT_GT(n, 100);
}

void wear_away(Volume& volume, Occupancy& map, IVec3 v) {
  const int brick = volume.specimen().brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
  std::uint16_t* values = volume.cut_for_writing(brick);
  ASSERT_NE(values, nullptr);
  values[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = 0;
  volume.touched(brick);
  map.vanish(v);
}

TEST(Occupancy, begins_as_defined) {
  const Volume volume(block_with_hollow());
  expect_as_defined(Occupancy(volume), volume);
}

TEST(Occupancy, stays_as_defined_while_voxels_vanish_anywhere) {
  Volume volume(block_with_hollow());
  Occupancy map(volume);
  std::mt19937 random(7);
  for (int round = 0; round < 4; ++round) {
    for (int k = 0; k < 300; ++k) {
      const IVec3 v(8 + static_cast<int>(random() % 37), static_cast<int>(random() % 32),
                    3 + static_cast<int>(random() % 30));
      if (volume.occupied(v)) wear_away(volume, map, v);
    }
    expect_as_defined(map, volume);
  }
  expect_as_defined(Occupancy(volume), volume);  // as it would be after loading
}

TEST(Occupancy, stays_as_defined_along_a_tunnel_through_bricks_that_were_whole) {
  Volume volume(block_with_hollow());
  Occupancy map(volume);
  for (int x = 8; x < kSize.x; ++x)
    for (int y = 14; y < 18; ++y)
      for (int z = 6; z < 10; ++z)
        if (volume.occupied({x, y, z})) wear_away(volume, map, {x, y, z});
  expect_as_defined(map, volume);
}

TEST(Occupancy, keeps_bits_for_the_surface_and_for_as_many_bricks_as_can_be_cut) {
  const auto bytes = [](int edge) {
    const Grid grid{IVec3(edge), 0.1, Vec3(0.0)};
    const Volume volume(
        Specimen::build(grid, Reading::filled, [](IVec3, BrickVoxels&) { return std::optional(Tissue::bone); }));
    return Occupancy(volume).bytes();
  };
  // Without cuts all bricks are whole: 4 bytes each, and 128 for each that can be cut.
  EXPECT_EQ(bytes(64), 512u * 4 + (2 + 512) * 128);
  EXPECT_EQ(bytes(320), 64000u * 4 + (2 + kMostCutBricks) * 128);
}

}  // namespace
}  // namespace cusp::test
