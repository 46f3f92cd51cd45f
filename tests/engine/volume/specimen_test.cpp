// Specimens built brick by brick: the same as from the dense form, in room that grows with the surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/volume/volume.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A ball under a slab, tissues mixed where they meet; sizes that no brick divides.
VoxelVolume mixed_volume() {
  VoxelVolume out(Grid{IVec3(45, 38, 51), 0.1, Vec3(-2.0, -1.9, -2.5)});
  IVec3 v;
  for (v.z = 0; v.z < out.grid.size.z; ++v.z)
    for (v.y = 0; v.y < out.grid.size.y; ++v.y)
      for (v.x = 0; v.x < out.grid.size.x; ++v.x) {
        const Vec3 p = out.grid.centre_mm(v);
        const double d = std::min(glm::length(p) - 1.5, std::max(std::fabs(p.z - 1.8) - 0.5, std::fabs(p.x) - 1.2));
        const std::size_t i = out.grid.index(v);
        const IVec3 last = out.grid.size - 1;
        if (v.x == 0 || v.y == 0 || v.z == 0 || v.x == last.x || v.y == last.y || v.z == last.z) continue;  // room
        out.s[i] = solid_from_distance(d / 0.1);
        if (out.s[i] > 0) out.tissue[i] = p.z > 1.3 ? Tissue::enamel : p.x > 0.4 ? Tissue::pulp : Tissue::dentine;
      }
  return out;
}

/// What the dense form holds of a brick, with rubbish beyond the grid: nothing of it may be read.
BrickSource bricks_of(const VoxelVolume& dense) {
  return [&dense](IVec3 brick, BrickVoxels& voxels) -> std::optional<Tissue> {
    bool alike = true;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = brick * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6);
      const auto at = static_cast<std::size_t>(o);
      voxels.s[at] = dense.grid.contains(v) ? dense.s[dense.grid.index(v)] : std::uint16_t{777};
      voxels.tissue[at] = dense.grid.contains(v) ? dense.tissue[dense.grid.index(v)] : Tissue::amalgam;
      alike = alike && (voxels.s[at] == 0 || voxels.s[at] == kSolid) && voxels.s[at] == voxels.s[0] &&
              voxels.tissue[at] == voxels.tissue[0];
    }
    if (alike) return voxels.tissue[0];
    return std::nullopt;
  };
}

/// A solid block with four empty voxels round it and its band, given brick by brick as by a generator.
std::shared_ptr<const Specimen> solid_block(int edge, Reading reading) {
  const Grid grid{IVec3(edge), 0.1, Vec3(0.0)};
  return Specimen::build(grid, reading, [edge](IVec3 brick, BrickVoxels& voxels) -> std::optional<Tissue> {
    const IVec3 corner = brick * kBrickEdge;
    bool inner = true;
    for (int i = 0; i < 3; ++i) inner = inner && corner[i] >= 8 && corner[i] + 8 <= edge - 8;
    if (inner) return Tissue::dentine;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const Vec3 p(corner + IVec3(o & 7, o >> 3 & 7, o >> 6));
      double d = -100.0;
      for (int i = 0; i < 3; ++i) d = std::max(d, std::max(3.5 - p[i], p[i] - (edge - 4.5)));
      const auto at = static_cast<std::size_t>(o);
      voxels.s[at] = solid_from_distance(d);
      voxels.tissue[at] = voxels.s[at] > 0 ? Tissue::dentine : Tissue::empty;
    }
    return std::nullopt;
  });
}

class BothReadings : public testing::TestWithParam<Reading> {};
INSTANTIATE_TEST_SUITE_P(Readings, BothReadings, testing::Values(Reading::filled, Reading::banded),
                         [](const auto& i) { return i.param == Reading::filled ? "filled" : "banded"; });

TEST_P(BothReadings, a_build_brick_by_brick_equals_the_one_from_the_dense_form_bit_for_bit) {
  const VoxelVolume dense = mixed_volume();
  const auto a = Specimen::build(dense, GetParam());
  const auto b = Specimen::build(dense.grid, GetParam(), bricks_of(dense));
  EXPECT_EQ(a->hash(), b->hash());
  EXPECT_EQ(a->bytes(), b->bytes());
  EXPECT_EQ(a->dense().s, b->dense().s);
  EXPECT_EQ(a->dense().tissue, b->dense().tissue);
}

TEST_P(BothReadings, every_voxel_reads_as_in_the_dense_form) {
  const VoxelVolume dense = mixed_volume();
  const auto specimen = Specimen::build(dense, GetParam());
  IVec3 v;
  for (v.z = -1; v.z <= dense.grid.size.z; ++v.z)
    for (v.y = -1; v.y <= dense.grid.size.y; ++v.y)
      for (v.x = -1; v.x <= dense.grid.size.x; ++v.x) {
        std::uint16_t s = 0;
        if (dense.grid.contains(v)) s = dense.s[dense.grid.index(v)];
        if (GetParam() == Reading::filled) s = s >= kHalf ? kSolid : std::uint16_t{0};
        ASSERT_EQ(specimen->s(v), s);
        ASSERT_EQ(specimen->tissue(v), s > 0 ? dense.tissue[dense.grid.index(v)] : Tissue::empty);
      }
}

// Pinned when every brick kept its own tissues: what a specimen saves in memory may not change what it is.
TEST(Specimen, has_the_hash_that_recorded_sessions_hold) {
  EXPECT_EQ(Specimen::build(mixed_volume(), Reading::banded)->hash(), 10735087213623980392ull);
  EXPECT_EQ(Specimen::build(mixed_volume(), Reading::filled)->hash(), 3319078272277929455ull);
}

TEST_P(BothReadings, a_brick_names_its_only_tissue_and_none_where_tissues_mix) {
  const auto specimen = Specimen::build(mixed_volume(), GetParam());
  const IVec3 n = specimen->brick_count();
  int one = 0, mixed = 0;
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    Tissue only = Tissue::empty;
    bool several = false;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const Tissue t = specimen->tissue_in(b, o);
      ASSERT_EQ(t == Tissue::empty, specimen->s_in(b, o) == 0);
      if (t == Tissue::empty) continue;
      several = several || (only != Tissue::empty && t != only);
      only = t;
    }
    EXPECT_EQ(specimen->only_tissue(b), several ? Tissue::empty : only);
    one += !several && only != Tissue::empty;
    mixed += several;
  }
  EXPECT_GT(one, 10);
  EXPECT_GT(mixed, 10);
}

TEST_P(BothReadings, a_solid_brick_at_the_grid_s_edge_ends_with_the_grid) {
  const Grid grid{IVec3(12, 16, 8), 0.1, Vec3(0.0)};
  const auto specimen =
      Specimen::build(grid, GetParam(), [](IVec3, BrickVoxels&) { return std::optional(Tissue::bone); });
  VoxelVolume dense(grid);
  std::ranges::fill(dense.s, kSolid);
  std::ranges::fill(dense.tissue, Tissue::bone);
  if (GetParam() == Reading::filled) {
    EXPECT_EQ(specimen->hash(), Specimen::build(dense, GetParam())->hash());
  }
  EXPECT_TRUE(specimen->uniform(specimen->brick_index({0, 0, 0})));
  EXPECT_FALSE(specimen->uniform(specimen->brick_index({1, 0, 0})));
  EXPECT_EQ(specimen->s({12, 0, 0}), 0);
  EXPECT_EQ(specimen->only_tissue(specimen->brick_index({1, 0, 0})), Tissue::bone);
}

// A block's crossed bricks are those of its faces: 6 (n/8)^2 less the edges. Twice the edge is four times as many, and
// a little more because the edges count for less (measured 4.6 from 64 to 128, 4.3 from 128 to 256); eight would be the
// box.
TEST_P(BothReadings, the_memory_of_a_solid_block_grows_with_its_surface) {
  const auto bytes = [](int edge) {
    const auto block = solid_block(edge, GetParam());
    return static_cast<double>(block->bytes());
  };
  const double small = bytes(64), middle = bytes(128), large = bytes(256);
  RecordProperty("ratio_128_to_64", std::to_string(middle / small));
  RecordProperty("ratio_256_to_128", std::to_string(large / middle));
  EXPECT_LT(middle / small, 5.0);
  EXPECT_LT(large / middle, 4.5);
}

TEST_P(BothReadings, cut_room_is_bounded_whatever_the_specimen_s_size) {
  const auto small = solid_block(64, GetParam());
  EXPECT_EQ(Volume(small).cut_capacity(), 512u);  // all of 8^3 bricks hold tissue or touch one
  const auto large = solid_block(264, GetParam());
  Volume volume(large);
  EXPECT_EQ(volume.cut_capacity(), kMostCutBricks);  // of 33^3 = 35,937
  EXPECT_LT(volume.bytes(), 20u << 20);
}

TEST(Volume, refuses_to_write_beyond_its_room_and_keeps_what_it_has) {
  Volume volume(solid_block(264, Reading::banded));
  const IVec3 n = volume.specimen().brick_count();
  std::size_t got = 0;
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    std::uint16_t* values = volume.cut_for_writing(b);
    if (values == nullptr) continue;
    values[0] = 7;
    volume.touched(b);
    ++got;
  }
  EXPECT_EQ(got, kMostCutBricks);
  EXPECT_EQ(volume.cut_in(0, 0), 7);
  EXPECT_EQ(volume.cut_slot(n.x * n.y * n.z - 1), -1);
  EXPECT_EQ(volume.cut_in(n.x * n.y * n.z - 1, 0), kSolid);
}

TEST(Volume, a_brick_s_revision_rises_with_every_change_and_with_loading) {
  Volume volume(Specimen::build(mixed_volume(), Reading::banded));
  int brick = 0;
  while (!volume.cuttable(brick)) ++brick;
  int other = brick + 1;
  while (!volume.cuttable(other)) ++other;
  EXPECT_EQ(volume.revision(brick), 0u);
  volume.cut_for_writing(brick)[5] = 9;
  volume.touched(brick);
  volume.touched(brick);
  EXPECT_EQ(volume.revision(brick), 2u);
  EXPECT_EQ(volume.revision(other), 0u);
  const auto bytes = volume.save_cuts();
  ASSERT_TRUE(volume.load_cuts(bytes));
  EXPECT_GT(volume.revision(brick), 2u);
  EXPECT_GT(volume.revision(other), 0u);
  EXPECT_EQ(volume.cut_in(brick, 5), 9);
  const std::uint32_t before = volume.revision(brick);
  volume.touched(brick);
  EXPECT_EQ(volume.revision(brick), before + 1);
}

TEST(Volume, refuses_cuts_where_no_tissue_is_near) {
  VoxelVolume dense(Grid{IVec3(40), 0.1, Vec3(0.0)});
  dense.s[0] = kSolid;
  dense.tissue[0] = Tissue::enamel;
  const auto specimen = Specimen::build(dense, Reading::banded);
  Volume volume(specimen);
  const int far = specimen->brick_index({4, 4, 4});
  ASSERT_FALSE(volume.cuttable(far));
  volume.cut_for_writing(0)[3] = 1;
  std::vector<std::byte> bytes = volume.save_cuts();
  const std::uint64_t before = volume.hash();
  bytes[4] = static_cast<std::byte>(far);  // the brick's index, little-endian
  EXPECT_FALSE(volume.load_cuts(bytes));
  EXPECT_EQ(volume.hash(), before);
}

TEST(Specimen, tissue_that_reaches_the_edge_of_its_volume_gets_a_face_there) {
  VoxelVolume full(Grid{IVec3(20), 0.1, Vec3(-0.95)});
  std::ranges::fill(full.s, kSolid);
  std::ranges::fill(full.tissue, Tissue::dentine);
  const auto banded = Specimen::build(full, Reading::banded);
  EXPECT_EQ(banded->grid().size, IVec3(20 + 2 * Specimen::kRoomVoxels));
  // The cube's faces stand at 1 mm: points of all six, and of its corners, which are rounded.
  int faces[6] = {}, elsewhere = 0;
  const IVec3 n = banded->brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const BasePoints points = banded->surface().in(b);
    for (int i = 0; i < points.count; ++i) {
      const Vec3 p = banded->grid().origin_mm +
                     0.1 * (Vec3(banded->brick_at(b) * kBrickEdge) + Vec3(points.x[i], points.y[i], points.z[i]));
      double off = 1e300;
      int face = -1;
      for (int k = 0; k < 6; ++k) {
        const double d = std::fabs(p[k / 2] - (k % 2 ? 1.0 : -1.0));
        if (d < off) {
          off = d;
          face = k;
        }
      }
      if (off < 1e-4) ++faces[face];
      else ++elsewhere;
    }
  }
  for (const int count : faces) EXPECT_GT(count, 300);  // 20 by 20 cells each
  EXPECT_LE(elsewhere, 8);
  // With room enough nothing is added, so that a stored specimen comes back as it was.
  EXPECT_EQ(Specimen::build(banded->dense(), Reading::banded)->hash(), banded->hash());
  EXPECT_EQ(Specimen::build(full, Reading::filled)->grid().size, IVec3(20));
}

}  // namespace
}  // namespace cusp::test
