#include "tests/engine/random/random_shards.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace cusp::test {
namespace {

TEST(SeedShards, hold_each_seed_once) {
  const Seeds all{1, 50};
  for (const int shards : {1, 3, 8, 50, 70}) {
    std::uint64_t next = 1;
    for (int p = 1; p <= shards; ++p) {
      const auto shard = shard_of(all, std::to_string(p) + "/" + std::to_string(shards));
      ASSERT_TRUE(shard);
      EXPECT_EQ(shard->first, next);
      next += shard->count();
    }
    EXPECT_EQ(next, 51u) << shards;
  }
  for (const char* none : {"", "3", "0/4", "5/4", "a/b", "1/4x", "-1/4", "1/0"})
    EXPECT_FALSE(shard_of(all, none)) << none;
}

std::string folder_of(const char* name) {
  const auto folder = (std::filesystem::path(testing::TempDir()) / name).string();
  std::filesystem::remove_all(folder);
  return folder;
}

TEST(SeedShards, that_are_done_are_remembered_and_half_a_line_is_not) {
  const auto folder = folder_of("cusp_random_shards");
  Counts counts;
  counts.ticks = kTicksOfASeed;
  counts.contacts = 7;
  counts.overheated = 3;
  Done first(folder, "surface", "one");
  first.add(4, counts);
  std::ofstream(folder + "/surface.txt", std::ios::app) << "5 20000 1";  // stopped in the middle
  Done second(folder, "surface", "one");
  EXPECT_TRUE(second.has(4));
  EXPECT_FALSE(second.has(5));
  second.add(5, counts);
  second.add(9, counts);
  const Done third(folder, "surface", "one");
  EXPECT_EQ(third.count({1, 8}), 2u);
  EXPECT_EQ(third.sum({1, 9}).ticks, 3u * kTicksOfASeed);
  EXPECT_EQ(third.sum({4, 4}).contacts, 7u);
  EXPECT_EQ(third.sum({4, 4}).overheated, 3u);
  EXPECT_EQ(Done(folder, "ray", "one").count({1, 9}), 0u);
  std::filesystem::remove_all(folder);
}

TEST(SeedShards, of_another_engine_are_not_gone_on_with) {
  const auto folder = folder_of("cusp_random_engine");
  Done(folder, "surface", "one").add(4, Counts{});
  const Done other(folder, "surface", "two");
  EXPECT_EQ(other.other_engine(), "one");
  EXPECT_EQ(other.count({1, 9}), 0u);
  EXPECT_EQ(Done(folder, "ray", "two").other_engine(), "one");
  EXPECT_EQ(Done(folder, "surface", "one").other_engine(), "");
  EXPECT_EQ(Done(folder, "surface", "one").count({1, 9}), 1u);
  // Seeds without an engine's name.
  std::filesystem::remove(folder + "/engine.txt");
  EXPECT_EQ(Done(folder, "surface", "one").other_engine(), "an unnamed engine");
  EXPECT_EQ(Done("", "surface", "two").other_engine(), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cusp::test
