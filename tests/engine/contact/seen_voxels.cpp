// SeenVoxels: a voxel is new once a pass, and where the room ends each time.
#include "engine/contact/features/seen_voxels.h"

#include <gtest/gtest.h>

namespace cusp::test {
namespace {

TEST(SeenVoxels, each_voxel_is_new_once_a_pass) {
  SeenVoxels seen;
  for (int pass = 0; pass < 3; ++pass) {
    seen.clear();
    for (int i = 0; i < 1000; ++i) EXPECT_TRUE(seen.add({i % 10, i / 10 % 10, i / 100}));
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(seen.add({i % 10, i / 10 % 10, i / 100}));
  }
}

TEST(SeenVoxels, axes_are_different) {
  SeenVoxels seen;
  seen.clear();
  EXPECT_TRUE(seen.add({1, 0, 0}));
  EXPECT_TRUE(seen.add({0, 1, 0}));
  EXPECT_TRUE(seen.add({0, 0, 1}));
  EXPECT_TRUE(seen.add({0, 0, 1023}));
}

TEST(SeenVoxels, where_the_room_ends_a_voxel_is_new_each_time_and_those_seen_stay_seen) {
  SeenVoxels seen;
  seen.clear();
  int first = 0, again = 0;
  for (int i = 0; i < 20000; ++i) first += seen.add({i % 100, i / 100, 7});
  for (int i = 0; i < 20000; ++i) again += seen.add({i % 100, i / 100, 7});
  EXPECT_EQ(first, 20000);
  EXPECT_LT(again, 20000);
  EXPECT_FALSE(seen.add({0, 0, 7}));
}

}  // namespace
}  // namespace cusp::test
