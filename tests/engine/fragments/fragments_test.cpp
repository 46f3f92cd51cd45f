// Severed fragments in the volume: what hangs together, what is found, and that nothing else goes.
#include "engine/volume/fragments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/volume/surface_cells.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

double box(Vec3 p, Vec3 middle, Vec3 half) {
  const Vec3 q = glm::abs(p - middle) - half;
  const Vec3 m = glm::max(q, Vec3(0.0));
  return std::sqrt(glm::dot(m, m)) + std::min(std::max(q.x, std::max(q.y, q.z)), 0.0);
}

/// A block of 32 x 24 x 24 voxels of 0.1 mm in a grid of 48 x 40 x 40.
constexpr Vec3 kHalf{1.6, 1.2, 1.2};
Grid grid() { return {IVec3(48, 40, 40), 0.1, Vec3(-2.35, -1.95, -1.95)}; }
std::shared_ptr<const Specimen> block(Reading reading) {
  return carved::specimen(
      grid(), reading, [](Vec3 p) { return box(p, Vec3(0.0), kHalf); }, [](Vec3) { return Tissue::dentine; });
}
std::vector<std::int32_t> bricks_of(const Volume& volume) {
  return {volume.cut_bricks().begin(), volume.cut_bricks().end()};
}
int occupied(const Volume& volume) {
  int count = 0;
  const IVec3 n = volume.specimen().brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) count += occupied_in(volume, b).count();
  return count;
}
/// Removes a named fragment as the step does, in at most so many ticks. Returns the number of ticks.
int remove_fragment(Volume& volume, std::uint32_t name, int most = 1000) {
  Occupancy occupancy(volume);
  FragmentRemoval leaving;
  leaving.receive(volume, static_cast<std::uint16_t>(0x8000u | name >> 15));
  leaving.receive(volume, static_cast<std::uint16_t>(name & 0x7fffu));
  int ticks = 0;
  for (; leaving.active() && ticks < most; ++ticks)
    leaving.advance(volume, [&](std::span<const IVec3> voxels) {
      if (volume.specimen().reading() == Reading::filled)
        remove_voxels(volume, occupancy, voxels);
      else
        remove_voxels(volume, voxels);
    });
  return ticks;
}

class EveryReading : public testing::TestWithParam<Reading> {};
INSTANTIATE_TEST_SUITE_P(Fragments, EveryReading, testing::Values(Reading::filled, Reading::banded),
                         [](const auto& i) { return i.param == Reading::filled ? "filled" : "banded"; });

TEST(Fragments, what_is_reached_in_a_brick_is_what_a_plain_search_reaches) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 50; ++round) {
    BrickVoxelSet within;
    for (std::uint64_t& s : within.slice) s = random() & random();  // a quarter: components of many sizes
    if (within.empty()) continue;
    BrickVoxelSet seed;
    seed.add(within.first());
    std::vector<int> plain{within.first()};
    BrickVoxelSet known = seed;
    for (std::size_t i = 0; i < plain.size(); ++i)
      for (int k = 0; k < 27; ++k) {
        const IVec3 v = IVec3(plain[i] & 7, plain[i] >> 3 & 7, plain[i] >> 6) + IVec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        if (v.x < 0 || v.y < 0 || v.z < 0 || v.x > 7 || v.y > 7 || v.z > 7) continue;
        const int o = brick_offset(v.x, v.y, v.z);
        if (!within.has(o) || known.has(o)) continue;
        known.add(o);
        plain.push_back(o);
      }
    EXPECT_EQ(reached(within, seed), known);
  }
}

TEST(Fragments, what_touches_from_a_neighbouring_brick_is_what_lies_within_a_voxel) {
  std::mt19937_64 random(2);
  BrickVoxelSet set;
  for (std::uint64_t& s : set.slice) s = random() & random() & random();
  for (int k = 0; k < 27; ++k) {
    if (k == 13) continue;
    const IVec3 step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    BrickVoxelSet plain;
    for (int o = 0; o < kBrickVoxels; ++o)
      for (int p = 0; p < kBrickVoxels && !plain.has(o); ++p) {
        const IVec3 apart = glm::abs(IVec3(o & 7, o >> 3 & 7, o >> 6) + step * 8 - IVec3(p & 7, p >> 3 & 7, p >> 6));
        if (set.has(p) && apart.x <= 1 && apart.y <= 1 && apart.z <= 1) plain.add(o);
      }
    EXPECT_EQ(touching(set, step), plain) << k;
  }
}

TEST_P(EveryReading, a_crumb_is_fewer_than_27_voxels) {
  for (const int size : {26, 27}) {
    // A row of voxels alone in the grid, one voxel across: s = 1 there, 0 elsewhere.
    VoxelVolume dense(grid());
    for (int x = 0; x < size; ++x) {
      dense.s[dense.grid.index({10 + x, 20, 20})] = kSolid;
      dense.tissue[dense.grid.index({10 + x, 20, 20})] = Tissue::bone;
    }
    const Volume volume(Specimen::build(dense, GetParam()));
    Crumb crumb;
    EXPECT_EQ(crumb_at(volume, {15, 20, 20}, crumb), size == 26);
    if (size == 26) {
      EXPECT_EQ(crumb.size, 26);
    }
    EXPECT_FALSE(crumb_at(volume, {15, 21, 20}, crumb)) << "nothing is there";
  }
}

TEST_P(EveryReading, a_block_cut_through_loses_its_smaller_part_and_no_more) {
  Volume volume(block(GetParam()));
  // A plane slot of 0.4 mm at x = 0.5: 0.9 mm of the block lie beyond it.
  carved::carve(volume, [](Vec3 p) { return box(p, Vec3(0.5, 0.0, 0.0), Vec3(0.2, 3.0, 3.0)); });
  const std::vector<std::uint32_t> names = find_severed_fragments(volume, bricks_of(volume));
  ASSERT_EQ(names.size(), 1u);
  const int before = occupied(volume);
  const int ticks = remove_fragment(volume, names[0]);
  EXPECT_LT(ticks, 70) << "bricks of 8 voxels: 9 x 24 x 24 lie in 2 x 4 x 4 of them, few twice";
  EXPECT_EQ(before - occupied(volume), 9 * 24 * 24);
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

TEST_P(EveryReading, what_a_neck_still_holds_is_no_fragment) {
  Volume volume(block(GetParam()));
  carved::carve(volume, [](Vec3 p) { return box(p, Vec3(0.5, 0.2, 0.0), Vec3(0.2, 1.2, 3.0)); });
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

TEST_P(EveryReading, solids_that_stood_apart_at_the_start_both_stay) {
  const auto two = [](Vec3 p) { return std::min(box(p, Vec3(-0.9, 0, 0), Vec3(0.7, 1.2, 1.2)), box(p, Vec3(0.5, 0, 0), Vec3(0.5, 1.2, 1.2))); };
  Volume volume(carved::specimen(grid(), GetParam(), two, [](Vec3) { return Tissue::dentine; }));
  // One hole into both, through the gap of 0.2 mm between them.
  carved::carve(volume, [](Vec3 p) { return std::sqrt(glm::dot(p - Vec3(-0.1, 0, 1.2), p - Vec3(-0.1, 0, 1.2))) - 0.5; });
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

/// Neighbouring teeth meet at a contact point, which an exercise may open.
TEST_P(EveryReading, a_part_as_large_as_a_tooth_stays_when_its_contact_is_cut) {
  const Grid wide{IVec3(200, 80, 80), 0.1, Vec3(-9.95, -3.95, -3.95)};
  const auto teeth = [](Vec3 p) {
    return std::min(std::min(box(p, Vec3(-4.0, 0, 0), Vec3(3.5, 3.0, 3.0)), box(p, Vec3(4.0, 0, 0), Vec3(3.5, 3.0, 3.0))),
                    box(p, Vec3(0.0), Vec3(0.6, 0.4, 0.4)));
  };
  Volume volume(carved::specimen(wide, GetParam(), teeth, [](Vec3) { return Tissue::enamel; }));
  carved::carve(volume, [](Vec3 p) { return box(p, Vec3(0.0), Vec3(0.2, 1.0, 1.0)); });
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

TEST_P(EveryReading, an_overhang_stays) {
  Volume volume(block(GetParam()));
  // Undercut from one side: a roof of 0.5 mm that hangs on the far side alone.
  carved::carve(volume, [](Vec3 p) { return box(p, Vec3(0.3, 0, 0.4), Vec3(1.6, 3.0, 0.3)); });
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

TEST(Fragments, what_went_leaves_no_surface_behind_and_its_neighbours_untouched) {
  // An islet of 2 x 2 x 3 voxels, 3 voxels before a wall: all of it goes, the wall keeps every value near its surface.
  VoxelVolume dense(grid());
  const auto solid = [](Vec3 p) { return std::min(box(p, Vec3(0.0, 0, 0), Vec3(0.1, 0.1, 0.15)), box(p, Vec3(1.2, 0, 0), Vec3(0.8, 1.2, 1.2))); };
  Volume volume(carved::specimen(grid(), Reading::banded, solid, [](Vec3) { return Tissue::bone; }));
  const Volume was = volume;
  Crumb crumb;
  const IVec3 middle(23, 19, 19);
  ASSERT_TRUE(crumb_at(volume, middle, crumb));
  const ChangedBox changed = remove_voxels(volume, crumb.voxels());
  ASSERT_TRUE(changed.any);
  EXPECT_FALSE(changed.overflow);
  IVec3 v;
  for (v.z = 0; v.z < 40; ++v.z)
    for (v.y = 0; v.y < 40; ++v.y)
      for (v.x = 0; v.x < 48; ++v.x) {
        if (v.x < 28) {
          SurfacePoint point;
          EXPECT_FALSE(v.x < 26 && surface_point(volume, v, point)) << v.x << ' ' << v.y << ' ' << v.z;
        } else {
          EXPECT_EQ(volume.s(v), was.s(v));
        }
        if (volume.cut(v) == kSolid) continue;
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(v[i] >= changed.low[i] && v[i] <= changed.high[i]);
      }
}

TEST(Fragments, a_voxel_keeps_the_id_of_its_sweep_where_a_crumb_that_goes_lowers_nothing) {
  // An islet of 2 x 2 x 3 voxels is left in a hole, one voxel from its wall.
  Volume volume(block(Reading::banded));
  volume.keep_sweeps();
  const Vec3 middle(1.4, 0.0, 0.0);
  carved::carve(volume, [&](Vec3 p) { return std::max(box(p, middle, Vec3(0.2, 0.2, 0.25)), -box(p, middle, Vec3(0.1, 0.1, 0.15))); });
  for (const std::int32_t brick : volume.cut_bricks()) std::fill_n(volume.sweeps_for_writing(brick), kBrickVoxels, 7);
  const Volume was = volume;
  Crumb crumb;
  ASSERT_TRUE(crumb_at(volume, {37, 19, 19}, crumb));
  const ChangedBox changed = remove_voxels(volume, crumb.voxels());
  ASSERT_TRUE(changed.any);
  int kept = 0;
  IVec3 v;
  for (v.z = changed.low.z - 2; v.z <= changed.high.z + 2; ++v.z)
    for (v.y = changed.low.y - 2; v.y <= changed.high.y + 2; ++v.y)
      for (v.x = changed.low.x - 2; v.x <= changed.high.x + 2; ++v.x) {
        const int brick = volume.specimen().brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
        if (!was.has_cut(brick)) continue;
        const bool same = volume.cut(v) == was.cut(v);
        kept += same ? 1 : 0;
        EXPECT_EQ(volume.sweeps_of(brick)[brick_offset(v.x & 7, v.y & 7, v.z & 7)], same ? 7 : Volume::kNoSweep)
            << v.x << ' ' << v.y << ' ' << v.z;
      }
  EXPECT_GT(kept, 100);
}

TEST_P(EveryReading, a_fragment_is_removed_alike_from_a_saved_state) {
  Volume one(block(GetParam()));
  carved::carve(one, [](Vec3 p) { return box(p, Vec3(0.5, 0.0, 0.0), Vec3(0.2, 3.0, 3.0)); });
  const std::uint32_t name = find_severed_fragments(one, bricks_of(one)).at(0);
  Volume other = one;
  remove_fragment(one, name);

  // The other one is saved and loaded after five ticks.
  Occupancy occupancy(other);
  FragmentRemoval first, second;
  first.receive(other, static_cast<std::uint16_t>(0x8000u | name >> 15));
  FragmentRemoval::Entry none[1];
  ASSERT_TRUE(second.load(first.half(), {none, 0}, 1000));
  second.receive(other, static_cast<std::uint16_t>(name & 0x7fffu));
  const auto gone = [&](std::span<const IVec3> voxels) {
    if (GetParam() == Reading::filled)
      remove_voxels(other, occupancy, voxels);
    else
      remove_voxels(other, voxels);
  };
  for (int k = 0; k < 5; ++k) second.advance(other, gone);
  FragmentRemoval third;
  ASSERT_TRUE(third.load(second.half(), second.entries(), 1000));
  while (third.active()) third.advance(other, gone);
  EXPECT_EQ(one.hash(), other.hash());
}

TEST_P(EveryReading, a_full_brick_goes_in_parts) {
  Volume volume(block(GetParam()));
  carved::carve(volume, [](Vec3 p) { return box(p, Vec3(0.5, 0.0, 0.0), Vec3(0.2, 3.0, 3.0)); });
  const std::uint32_t name = find_severed_fragments(volume, bricks_of(volume)).at(0);
  Occupancy occupancy(volume);
  FragmentRemoval leaving;
  leaving.receive(volume, static_cast<std::uint16_t>(0x8000u | name >> 15));
  leaving.receive(volume, static_cast<std::uint16_t>(name & 0x7fffu));
  std::size_t most = 0;
  while (leaving.active())
    leaving.advance(volume, [&](std::span<const IVec3> voxels) {
      most = std::max(most, voxels.size());
      if (GetParam() == Reading::filled)
        remove_voxels(volume, occupancy, voxels);
      else
        remove_voxels(volume, voxels);
    });
  // A slice of 64 at most beyond what is enough; a brick whole would be 512.
  EXPECT_GE(most, 128u);
  EXPECT_LT(most, static_cast<std::size_t>(FragmentRemoval::kVoxelsPerTick) + 64u);
  EXPECT_TRUE(find_severed_fragments(volume, bricks_of(volume)).empty());
}

TEST(Fragments, a_name_that_names_nothing_does_nothing) {
  Volume volume(block(Reading::banded));
  FragmentRemoval leaving;
  leaving.receive(volume, 0x1234);  // a second half without a first
  EXPECT_FALSE(leaving.active());
  leaving.receive(volume, 0xffff);
  leaving.receive(volume, 0x7fff);  // a brick far beyond the last
  EXPECT_FALSE(leaving.active());
  leaving.receive(volume, 0x8000);
  leaving.receive(volume, 0x0001);  // an empty voxel
  int calls = 0;
  while (leaving.active()) leaving.advance(volume, [&](std::span<const IVec3>) { ++calls; });
  EXPECT_EQ(calls, 0);
  const FragmentRemoval::Entry outside{100000, {}};
  EXPECT_FALSE(leaving.load(0, {&outside, 1}, 1000));
}

}  // namespace
}  // namespace cusp::test
