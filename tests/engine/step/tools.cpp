// What the contact methods are made of: the voxelised bur by rows, its point shell, the plain field.
#include <gtest/gtest.h>

#include "engine/contact/methods/point_shell.h"
#include "engine/contact/methods/tool_overlap.h"
#include "engine/contact/methods/trilinear_field.h"
#include "engine/removal/carve.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


/// Lumps and holes, so that every part of a tool meets something somewhere.
double lumps(Vec3 p) {
  const auto wave = [](double x) { return std::fabs(x - 1.3 * std::floor(x / 1.3) - 0.65) - 0.3; };
  return std::max(box_distance(p, Vec3(1.6)), -std::min(wave(p.x), std::min(wave(p.y), wave(p.z))));
}

TEST(ToolOverlap, agrees_with_the_tool_voxel_by_voxel) {
  auto scene = scene_of(from_distance(4.0, 0.1, lumps), Method::ray, 0.3);
  scene->burs[0].neck_length_mm = 0.8;
  scene->burs[0].shank_radius_mm = 0.45;
  scene->burs[0].shank_length_mm = 0.7;
  scene->tool_axis = Vec3(0.36, 0.48, 0.8);
  const Volume volume(scene->specimen);
  const ToolOverlap overlap(*scene, volume);
  const VoxelTool tool = voxelise(scene->burs[0], scene->tool_axis, 0.1);
  const IVec3 size = volume.grid().size;
  int free = 0, hit = 0;
  for (int z = -6; z < size.z + 6; z += 2)
    for (int y = -6; y < size.y + 6; ++y)
      for (int x = -6; x < size.x + 6; ++x) {
        const IVec3 pivot(x, y, z);
        bool expected = !volume.occupied(pivot);
        for (const IVec3& o : tool.cutting) expected = expected && !volume.occupied(pivot + o);
        for (const IVec3& o : tool.holder) expected = expected && !volume.occupied(pivot + o);
        ASSERT_EQ(overlap.free(0, pivot), expected) << x << " " << y << " " << z;
        ++(expected ? free : hit);
      }
  EXPECT_GT(free, 1000);
  EXPECT_GT(hit, 1000);
}

TEST(ToolOverlap, by_the_pivot_alone_only_the_pivot_counts) {
  const auto scene = scene_of(from_distance(4.0, 0.1, lumps), Method::occupancy_pivot, 0.3);
  const Volume volume(scene->specimen);
  const ToolOverlap overlap(*scene, volume);
  for (int x = 0; x < volume.grid().size.x; ++x) EXPECT_EQ(overlap.free(0, {x, 20, 21}), !volume.occupied({x, 20, 21}));
}

TEST(PointShell, covers_the_sphere_evenly) {
  Bur bur;
  bur.radius_mm = 0.5;
  const PointShell shell = shell_of(bur, Vec3(0, 0, 1), 0.078, 0.2);
  // A point a voxel: 4 pi r^2 / h^2 = 516; a cube's faces in whole numbers make it 600 or 486.
  EXPECT_NEAR(static_cast<double>(shell.head.size()), 516.0, 100.0);
  double sum = 0.0;
  Vec3 mean(0.0);
  glm::dmat3 second(0.0);
  for (const PointShell::HeadPoint& p : shell.head) {
    EXPECT_NEAR(length(p.out), 1.0, 1e-12);
    sum += p.share;
    mean += p.out * p.share;
    second += glm::outerProduct(p.out, p.out) * p.share;
  }
  // Of a whole sphere: 1, nothing, a third of unity.
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_LT(length(mean), 1e-12);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(second[i][j], i == j ? 1.0 / 3.0 : 0.0, 1e-12);
}

TEST(PointShell, puts_neck_and_shank_on_their_radii_and_none_inside_the_ball) {
  Bur bur;
  bur.radius_mm = 0.5;
  const Vec3 axis = Vec3(0.36, 0.48, 0.8);
  const PointShell shell = shell_of(bur, axis, 0.1, 0.25);
  double before = 0.0;
  ASSERT_FALSE(shell.holder.empty());
  for (const PointShell::HolderPoint& p : shell.holder) {
    const double along = glm::dot(p.offset_mm, axis);
    const double radius = length(p.offset_mm - axis * along);
    EXPECT_NEAR(along, p.along_mm, 1e-12);
    EXPECT_GE(along, before - 1e-12) << "in order";
    before = along;
    EXPECT_GT(length(p.offset_mm), bur.radius_mm);
    EXPECT_NEAR(length(p.out), 1.0, 1e-12);
    const bool on_neck = std::fabs(radius - bur.neck_radius_mm) < 1e-9 && along <= bur.neck_length_mm + 1e-9;
    const bool on_shank = std::fabs(radius - bur.shank_radius_mm) < 1e-9 && along >= bur.neck_length_mm - 1e-9;
    const bool on_shoulder = std::fabs(along - bur.neck_length_mm) < 1e-9;
    EXPECT_TRUE(on_neck || on_shank || on_shoulder) << along << " " << radius;
  }
  EXPECT_NEAR(before, bur.neck_length_mm + bur.shank_length_mm, 1e-9);
}

TEST(TrilinearField, follows_its_eight_samples_across_bricks_and_cuts) {
  Volume volume(Specimen::build(from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.2; }), Reading::banded));
  carve_sweep(volume, {0.3, 0.2, 1.3}, {0.1, -0.1, 0.2}, 0.35);
  const TrilinearField field(volume);
  const Grid& grid = volume.grid();
  std::uint64_t seed = 5;
  const auto random = [&seed] {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 2147483648.0 - 1.0;
  };
  for (int round = 0; round < 20000; ++round) {
    const Vec3 p = 2.2 * Vec3(random(), random(), random());  // beyond the box too
    const Vec3 x = (p - grid.origin_mm) / grid.voxel_mm;
    const Vec3 low = glm::floor(x);
    const Vec3 f = x - low;
    double s = 0.0;
    for (int i = 0; i < 8; ++i) {
      const IVec3 o(i & 1, i >> 1 & 1, i >> 2);
      const double w = (o.x ? f.x : 1 - f.x) * (o.y ? f.y : 1 - f.y) * (o.z ? f.z : 1 - f.z);
      s += w * volume.s(IVec3(low) + o);
    }
    const double expected = (kBandVoxels - s * 2.0 * kBandVoxels / 65535.0) * grid.voxel_mm;
    ASSERT_NEAR(field.at(p), expected, 1e-12) << p.x << " " << p.y << " " << p.z;
  }
}

}  // namespace
}  // namespace cusp::test
