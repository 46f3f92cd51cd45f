// Baked patches on their way from the volume to the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/render/mesh_blob.h"
#include "ui/render/overlay_line.h"
#include "ui/render/patch_feed.h"
#include "ui/render/patch_store.h"
#include "ui/render/target_look.h"

namespace cusp::test {
namespace {

using test::ball;
using test::carve;

constexpr std::size_t kAll = ~std::size_t{0};

Volume sphere(double mm) { return Volume(Specimen::build(ball(mm), Reading::banded)); }

PatchStore store_of(PatchFeed& feed) {
  PatchStore out;
  for (BakedPatch& patch : feed.take(kAll).patches) out.put(std::move(patch));
  return out;
}

bool same_mesh(const BakedPatch& a, const BakedPatch& b) {
  if (a.level != b.level || a.indices != b.indices || a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (a.vertices[i].position_mm[k] != b.vertices[i].position_mm[k]) return false;
    }
    if (a.vertices[i].cut != b.vertices[i].cut || a.vertices[i].value != b.vertices[i].value) return false;
  }
  return true;
}

TEST(PatchStore, a_ray_at_a_ball_meets_it_where_the_closed_form_says) {
  const double r = 1.5;
  const Volume volume = sphere(r);
  PatchFeed feed({});
  feed.build_all(volume);
  const PatchStore store = store_of(feed);
  for (const Vec3 along : {Vec3(0, 0, -1), glm::normalize(Vec3(1, -0.3, -0.6)), glm::normalize(Vec3(-0.2, 1, 0.1))}) {
    const auto hit = store.pick({-10.0 * along, along});
    ASSERT_TRUE(hit);
    // A chord of 0.17 mm stands 2.5 µm under the arc; measured 2.1 µm.
    EXPECT_NEAR(hit->distance_mm, 10.0 - r, 0.004);
    EXPECT_GT(glm::dot(hit->normal, -along), 0.999);
    EXPECT_EQ(hit->tissue, Tissue::enamel);
  }
  EXPECT_FALSE(store.pick({{0, 0, 10}, glm::normalize(Vec3(1, 0, -0.5))}));
}

TEST(PatchStore, from_inside_no_face_is_met) {
  const Volume volume = sphere(1.5);
  PatchFeed feed({});
  feed.build_all(volume);
  EXPECT_FALSE(store_of(feed).pick({{0, 0, 0}, {0, 0, 1}}));
}

TEST(PatchFeed, following_cuts_gives_the_mesh_of_building_anew) {
  Volume volume = sphere(2.0);
  FeedSettings settings;
  settings.region = {Vec3(-0.5, -0.5, 1.0), Vec3(0.5, 0.5, 3.0)};
  settings.deviation = [](Vec3 p, SurfaceKind kind) { return Deviation{kind == SurfaceKind::cut ? static_cast<float>(p.z) : 0.0f, false}; };
  PatchFeed feed(settings);
  feed.build_all(volume);
  PatchStore followed = store_of(feed);
  for (int i = 0; i < 6; ++i) {
    const auto changed = carve(volume, Vec3(0.25 * i - 1.0, 0.1 * i, 1.9), 0.3);
    feed.update(volume, changed, static_cast<std::uint64_t>(i));
    for (BakedPatch& patch : feed.take(kAll).patches) followed.put(std::move(patch));
  }
  // A fresh feed may take more bricks for rough than the first did; those that were cut are fine in both.
  PatchFeed whole(settings);
  whole.build_all(volume);
  const PatchStore anew = store_of(whole);
  std::size_t compared = 0;
  for (const auto& [brick, patch] : anew.patches()) {
    const auto it = followed.patches().find(brick);
    ASSERT_NE(it, followed.patches().end()) << brick;
    if (patch.level != it->second.level || patch.level == kCoarsePatch) continue;
    EXPECT_TRUE(same_mesh(patch, it->second)) << brick;
    ++compared;
  }
  EXPECT_GT(compared, 10u);
  EXPECT_EQ(anew.patches().size(), followed.patches().size());
}

TEST(MeshBlob, reads_back_what_it_wrote_and_refuses_anything_else) {
  const Volume volume = sphere(1.0);
  const FeedSettings settings{{Vec3(-0.5, -0.5, 0.5), Vec3(0.5, 0.5, 3.0)}, {}};
  const WholeMesh mesh = PatchFeed::build_mesh(volume, settings);
  const auto bytes = mesh_bytes(mesh);
  const std::size_t bricks = mesh.level.size();
  auto back = mesh_from_bytes(bytes, bricks);
  ASSERT_TRUE(back);
  EXPECT_EQ(mesh_bytes(*back), bytes);
  PatchFeed read(settings), built(settings);
  read.begin(volume, std::move(*back));
  built.build_all(volume);
  const PatchStore a = store_of(read), b = store_of(built);
  ASSERT_EQ(a.patches().size(), b.patches().size());
  for (const auto& [brick, patch] : b.patches()) EXPECT_TRUE(same_mesh(patch, a.patches().at(brick))) << brick;
  EXPECT_FALSE(mesh_from_bytes(bytes, bricks + 1));
  EXPECT_FALSE(mesh_from_bytes(std::span(bytes).first(bytes.size() - 1), bricks));
  EXPECT_FALSE(mesh_from_bytes(std::span(bytes).first(bricks - 1), bricks));
  WholeMesh stray = mesh;
  stray.patches.front().indices.front() = static_cast<std::uint16_t>(stray.patches.front().vertices.size());
  EXPECT_FALSE(mesh_from_bytes(mesh_bytes(stray), bricks)) << "no such vertex";
  stray = mesh;
  stray.patches.back().brick = static_cast<int>(bricks);
  EXPECT_FALSE(mesh_from_bytes(mesh_bytes(stray), bricks)) << "no such brick";
}

TEST(PatchFeed, what_was_cut_is_fine_wherever_it_lies) {
  Volume volume = sphere(2.0);
  FeedSettings settings;
  settings.region = {Vec3(5.0), Vec3(6.0)};
  PatchFeed feed(settings);
  feed.build_all(volume);
  PatchStore store = store_of(feed);
  std::size_t coarse = 0;
  for (const auto& [brick, patch] : store.patches()) coarse += patch.level == kCoarsePatch ? 1u : 0u;
  EXPECT_GT(coarse, 20u);
  feed.update(volume, carve(volume, Vec3(0, 0, 2.0), 0.3), 1);
  for (BakedPatch& patch : feed.take(kAll).patches) store.put(std::move(patch));
  std::size_t fine = 0;
  for (const auto& [brick, patch] : store.patches()) {
    if (!volume.has_cut(brick)) continue;
    EXPECT_EQ(patch.level, kFinePatch) << brick;
    ++fine;
  }
  EXPECT_GT(fine, 0u);
}

TEST(PatchFeed, a_limit_of_bytes_spreads_a_mesh_over_several_takings_and_loses_nothing) {
  const Volume volume = sphere(1.5);
  PatchFeed feed({});
  feed.build_all(volume);
  PatchFeed other({});
  other.build_all(volume);
  const PatchStore whole = store_of(other);
  PatchStore store;
  int takings = 0;
  for (bool more = true; more; ++takings) {
    FedPatches fed = feed.take(20'000);
    std::size_t bytes = 0;
    for (BakedPatch& patch : fed.patches) {
      bytes += patch.bytes();
      store.put(std::move(patch));
    }
    EXPECT_LE(bytes, 20'000u);
    more = fed.more;
  }
  EXPECT_GT(takings, 3);
  EXPECT_EQ(store.triangles(), whole.triangles());
  EXPECT_TRUE(feed.empty());
}

TEST(PatchFeed, the_moments_of_changes_come_with_the_last_patch_that_shows_them) {
  Volume volume = sphere(1.5);
  PatchFeed feed({});
  feed.build_all(volume);
  feed.take(kAll);
  const auto now = std::chrono::steady_clock::now();
  feed.update(volume, carve(volume, Vec3(0, 0, 1.5), 0.4), 7, {now});
  FedPatches first = feed.take(1);
  EXPECT_TRUE(first.more);
  EXPECT_TRUE(first.changes.empty());
  const FedPatches rest = feed.take(kAll);
  ASSERT_EQ(rest.changes.size(), 1u);
  EXPECT_EQ(rest.changes[0], now);
  EXPECT_EQ(rest.tick, 7u);
}

TEST(Ambient, a_flat_place_is_lit_and_the_bottom_of_a_narrow_hole_is_dark) {
  Volume volume = sphere(2.0);
  SolidShares shares(volume);
  const auto at = [&](Vec3 mm) {
    return ambient_at(shares, Vec3f((mm - volume.grid().origin_mm) / kVoxel), {0, 0, 1}, static_cast<float>(kVoxel));
  };
  const float open = at({0, 0, 2.0});
  std::vector<std::int32_t> changed;
  for (int i = 0; i < 12; ++i)
    for (const std::int32_t brick : carve(volume, Vec3(0, 0, 2.2 - 0.15 * i), 0.3)) changed.push_back(brick);
  for (const std::int32_t brick : changed) shares.update(volume, brick);
  EXPECT_GT(open, 0.9f);
  EXPECT_LT(at({0, 0, 0.25}), 0.35f);
  EXPECT_EQ(at({0, 0, 0.25}), ambient_at(SolidShares(volume), Vec3f((Vec3(0, 0, 0.25) - volume.grid().origin_mm) / kVoxel),
                                         {0, 0, 1}, static_cast<float>(kVoxel)));
}

TEST(SolidShares, a_mean_counts_the_solid_voxels_of_its_cells) {
  const Volume volume = sphere(2.0);
  const SolidShares shares(volume);
  const auto voxel = [&](Vec3 mm) { return Vec3f((mm - volume.grid().origin_mm) / kVoxel); };
  for (const auto cell : {SolidShares::Cell::four, SolidShares::Cell::eight}) {
    EXPECT_NEAR(shares.at(cell, voxel({0, 0, 0})), 1.0f, 1e-3f);
    EXPECT_EQ(shares.at(cell, voxel({0, 0, 4.0})), 0.0f);
  }
  // On a face half of the neighbourhood is solid; a sphere curves away.
  EXPECT_NEAR(shares.at(SolidShares::Cell::four, voxel({0, 0, 2.0})), 0.48f, 0.08f);
  EXPECT_LT(shares.smooth_at(SolidShares::Cell::eight, voxel({0, 0, 2.0})), 0.45f);
}

TEST(JunctionDepth, is_the_distance_to_the_core_of_another_tissue) {
  const double core = 1.0;
  const auto specimen = Specimen::build(ball(2.0, core), Reading::banded);
  const JunctionDepth depth(*specimen);
  for (const Vec3 along : {Vec3(0, 0, 1), glm::normalize(Vec3(1, 1, 1)), glm::normalize(Vec3(1, -0.4, 0.2))})
    for (const double r : {1.2, 1.5, 1.9}) {
      const Vec3f voxel((r * along - specimen->grid().origin_mm) / kVoxel);
      // Cells of 0.4 mm; measured 0.14 to 0.20 mm more, 0.08 of it by blurring about so small a core.
      EXPECT_NEAR(depth.mm_at(voxel), r - core, 0.22) << r;
    }
  EXPECT_EQ(JunctionDepth(sphere(1.5).specimen()).mm_at({20, 20, 20}), JunctionDepth::kMostMm) << "enamel alone";
}

/// A ball of enamel about dentine, cut to the core: the wall is enamel, the bottom dentine.
TEST(VertexLook, a_cut_shows_enamel_then_dentine_and_its_margin_is_less_cut_than_its_wall) {
  Volume volume(Specimen::build(ball(2.0, 1.2), Reading::banded));
  carve(volume, {0, 0, 1.6}, 0.7);
  PatchFeed feed({});
  feed.build_all(volume);
  int walls = 0, bottoms = 0;
  std::uint8_t margin_cut = 0;
  for (const BakedPatch& patch : feed.take(kAll).patches)
    for (const PackedVertex& v : patch.vertices) {
      const Vec3f p(v.position_mm[0], v.position_mm[1], v.position_mm[2]);
      const float r = glm::length(p);
      margin_cut = r > 1.99f ? std::max(margin_cut, v.cut) : margin_cut;
      if (v.cut < 255) continue;
      if (r > 1.4f) {
        EXPECT_EQ(v.enamel, 255) << r;
        ++walls;
      } else if (r < 1.0f) {
        EXPECT_EQ(v.enamel, 0) << r;
        EXPECT_GT(v.colour[0], v.colour[2] + 60) << "dentine is yellow";
        ++bottoms;
      }
    }
  EXPECT_LT(margin_cut, 128);
  EXPECT_GT(walls, 50);
  EXPECT_GT(bottoms, 10);
}

TEST(VertexLook, deeper_enamel_is_whiter_and_less_yellow) {
  const Vec3f thin = enamel_colour(0.2f), thick = enamel_colour(2.0f);
  EXPECT_GT(thick.z, thin.z + 0.1f);
  EXPECT_LT(thick.x - thick.z, thin.x - thin.z);
}

TEST(ContourLines, a_level_of_height_on_a_ball_is_a_closed_circle) {
  const double r = 1.5, z = 0.9;
  const Volume volume = sphere(r);
  PatchFeed feed({});
  feed.build_all(volume);
  const PatchStore store = store_of(feed);
  std::vector<const BakedPatch*> patches;
  for (const auto& [brick, patch] : store.patches()) patches.push_back(&patch);
  const auto lines = contour_lines(patches, [](Vec3 p) { return p.z; }, z, -2.0, kTargetStyle);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points_mm.front(), lines[0].points_mm.back());
  double length = 0;
  for (std::size_t i = 0; i + 1 < lines[0].points_mm.size(); ++i)
    length += glm::length(Vec3(lines[0].points_mm[i + 1] - lines[0].points_mm[i]));
  // Measured 0.2 % short of the circle, as chords are.
  EXPECT_NEAR(length / (2 * std::numbers::pi * std::sqrt(r * r - z * z)), 1.0, 0.005);
}

TEST(TargetLook, deviation_counts_what_stands_and_what_went_too_far) {
  Outline target;
  target.shape = "channel";
  target.paths = {{{-2, 0, 0}, {2, 0, 0}}};
  target.width_mm = 1.0;
  target.depth_mm = 1.0;
  target.top_mm = 0.0;
  target.corner_radius_mm = 0.0;
  const TargetLook look(region_of(target), Leeway{0.3, 0.2}, nullptr);
  const DeviationAt at = look.deviation();
  EXPECT_NEAR(at({0, 0.9, -0.5}, SurfaceKind::cut).mm, 0.4, 1e-6);   // 0.4 mm beyond the wall at 0.5
  EXPECT_TRUE(at({0, 0.9, -0.5}, SurfaceKind::cut).beyond);
  EXPECT_FALSE(at({0, 0.6, -0.5}, SurfaceKind::cut).beyond);         // within the side's leeway of 0.2
  EXPECT_FALSE(at({0, 0, -1.25}, SurfaceKind::cut).beyond);          // within the floor's of 0.3
  EXPECT_TRUE(at({0, 0, -1.35}, SurfaceKind::cut).beyond);
  EXPECT_NEAR(at({0, 0, -0.8}, SurfaceKind::cut).mm, -0.2, 1e-6);    // 0.2 mm left over the floor
  EXPECT_NEAR(at({0, 0.4, 0}, SurfaceKind::original).mm, -0.1, 1e-6);    // never touched, inside
  EXPECT_EQ(at({0, 0.9, 0}, SurfaceKind::original).mm, 0.0f);            // never touched, outside: nothing was to be done
}

TEST(TargetLook, has_the_voxels_of_a_lesion_from_the_specimen) {
  VoxelVolume dense = ball(2.0);
  for (std::size_t i = 0; i < dense.tissue.size(); ++i) {
    const IVec3 v(static_cast<int>(i) % dense.grid.size.x, static_cast<int>(i) / dense.grid.size.x % dense.grid.size.y,
                  static_cast<int>(i) / (dense.grid.size.x * dense.grid.size.y));
    if (dense.tissue[i] != Tissue::empty && glm::length(dense.grid.centre_mm(v) - Vec3(0, 0, 2)) < 1.0) dense.tissue[i] = Tissue::carious_dentine;
  }
  const Volume whole(Specimen::build(dense, Reading::banded));
  Region lesion;
  lesion.kind = RegionKind::lesion;
  const TargetLook look(lesion, Leeway{0.3, 0.2}, whole.specimen_ptr());
  EXPECT_FALSE(look.empty());
  EXPECT_FALSE(look.lines(whole).empty());
  EXPECT_NEAR(look.shape().floor_mm(), 1.0, kVoxel);
  EXPECT_NEAR(look.deviation()({0, 0, 1.4}, SurfaceKind::cut).mm, -0.4, kVoxel) << "left over the lesion's bed";
  EXPECT_NEAR(look.deviation()({0, 0, 0.6}, SurfaceKind::cut).mm, 0.4, kVoxel) << "over-cut below it";
  const Box around = look.feed().region;
  EXPECT_LT(around.low.z, 0.8);
  EXPECT_TRUE(TargetLook(lesion, Leeway{0.3, 0.2}, nullptr).empty()) << "its voxels are not known";
}

TEST(TargetLook, without_a_target_everything_is_fine_and_nothing_is_drawn) {
  const TargetLook look(Region{}, Leeway{}, nullptr);
  EXPECT_TRUE(look.empty());
  EXPECT_FALSE(look.deviation());
  EXPECT_EQ(look.feed().region, Box{});
  EXPECT_TRUE(look.lines(sphere(1.0)).empty());
}

}  // namespace
}  // namespace cusp::test
