// FieldReaders: against the definition of what a cell's field reads, cell by cell.
#include "engine/contact/features/field_readers.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/modules.h"

namespace cusp::test {
namespace {

/// True if the field of a cell reads the voxel that lies `off` from the cell's lower corner, -1 to 2 along each axis.
bool reads(IVec3 off) {
  int beyond = 0;
  for (int axis = 0; axis < 3; ++axis) beyond += off[axis] == -1 || off[axis] == 2;
  return beyond <= 1;
}

/// Fails for each cell of the brick and its 26 neighbours that the readers have and should not, or the other way round.
void expect_readers(const ChangedVoxels& voxels) {
  bool read[24][24][24] = {};
  for (int o = 0; o < kBrickVoxels; ++o) {
    if ((voxels.slice[o >> 6] >> (o & 63) & 1) == 0) continue;
    for (int i = 0; i < 64; ++i) {
      const IVec3 off = IVec3(i & 3, i >> 2 & 3, i >> 4) - 1, cell = IVec3(o & 7, o >> 3 & 7, o >> 6) - off + 8;
      if (reads(off)) read[cell.z][cell.y][cell.x] = true;
    }
  }
  const FieldReaders readers(voxels);
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const IVec3 shift = (IVec3(x, y, z) >> 3) * 8 - 8;
        ASSERT_EQ((readers.in(shift, z & 7) >> ((x & 7) | (y & 7) << 3) & 1) != 0, read[z][y][x]) << x - 8 << ' ' << y - 8 << ' ' << z - 8;
      }
}

TEST(FieldReaders, of_one_voxel_are_the_cells_that_read_it_at_every_place_of_a_brick) {
  for (int o = 0; o < kBrickVoxels; ++o) {
    ChangedVoxels voxels;
    voxels.add_row(o >> 3 & 7, o >> 6, 1u << (o & 7));
    expect_readers(voxels);
  }
}

TEST(FieldReaders, of_many_voxels_are_those_of_each) {
  std::mt19937 random(41);
  for (int round = 0; round < 30; ++round) {
    ChangedVoxels voxels;
    for (int k = 0; k < 1 + round * round; ++k) {
      const auto o = static_cast<int>(random() % kBrickVoxels);
      voxels.add_row(o >> 3 & 7, o >> 6, 1u << (o & 7));
    }
    expect_readers(voxels);
  }
}

TEST(ChangedVoxels, have_the_box_about_what_was_added) {
  ChangedVoxels voxels;
  EXPECT_FALSE(voxels.close({8, 16, 24})) << "nothing was added";
  voxels.add_row(2, 1, 0b00010000);
  voxels.add_row(5, 6, 0b00100010);
  ASSERT_TRUE(voxels.close({8, 16, 24}));
  EXPECT_EQ(voxels.low, IVec3(9, 18, 25));
  EXPECT_EQ(voxels.high, IVec3(13, 21, 30));
}

TEST(ChangedVoxels, of_a_box_are_brick_by_brick_all_its_voxels) {
  const IVec3 low(5, 8, 7), high(16, 9, 8);
  int count = 0, bricks = 0;
  for_bricks_of(low, high, [&](const ChangedVoxels& voxels) {
    ++bricks;
    EXPECT_EQ(voxels.low >> 3, voxels.high >> 3);
    for (int o = 0; o < kBrickVoxels; ++o) {
      if ((voxels.slice[o >> 6] >> (o & 63) & 1) == 0) continue;
      const IVec3 voxel = (voxels.low >> 3) * 8 + IVec3(o & 7, o >> 3 & 7, o >> 6);
      EXPECT_TRUE(glm::all(glm::lessThanEqual(low, voxel)) && glm::all(glm::lessThanEqual(voxel, high)));
      ++count;
    }
  });
  EXPECT_EQ(count, 12 * 2 * 2);
  EXPECT_EQ(bricks, 6);
}

}  // namespace
}  // namespace cusp::test
