// Leaves of the specimen's voxels: a tissue, its offset, and a lesion.

#include "scenarios/shapes/tissue_shape.h"

#include <gtest/gtest.h>

#include <random>

#include "scenarios/shapes/distance.h"
#include "scenarios/shapes/target.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

/// A block of dentine with a ball of pulp and a lesion: soft within 0.6 mm, firm to 0.9, carious enamel above z = 1.5.
constexpr Vec3 kPulp(0, 0, -1.2), kLesion(0.2, 0, 1.1);
Tissue tissue_at(Vec3 p) {
  if (ball_distance(p, kPulp, 0.8) < 0.0) return Tissue::pulp;
  const double d = ball_distance(p, kLesion, 0.6);
  if (d > 0.3) return p.z > 1.5 ? Tissue::enamel : Tissue::dentine;
  return p.z > 1.5 ? Tissue::carious_enamel : d > 0.0 ? kFirmCariousDentine : Tissue::carious_dentine;
}
std::shared_ptr<const Specimen> block(Reading reading = Reading::banded) {
  Grid grid;
  grid.size = IVec3(52, 52, 60);
  grid.origin_mm = Vec3(-2.53, -2.57, -2.91);
  return carved::specimen(grid, reading, [](Vec3 p) { return box_distance(p, Vec3(0), Vec3(2, 2, 2.3)); }, tissue_at);
}

Region tissue(Tissue of) {
  Region out;
  out.kind = RegionKind::tissue;
  out.tissue = of;
  return out;
}
Region lesion(Hardness down_to) {
  Region out;
  out.kind = RegionKind::lesion;
  out.down_to = down_to;
  return out;
}

Vec3 random_place(std::mt19937_64& random) {
  std::uniform_real_distribution<double> x(-2.4, 2.4), z(-2.8, 2.8);
  const double a = x(random), b = x(random), c = z(random);
  return {a, b, c};
}

TEST(TissueLeaf, ItsSignIsThatOfTheVoxelsTissue) {
  for (const Reading reading : {Reading::banded, Reading::filled}) {
    const auto specimen = block(reading);
    const Grid& grid = specimen->grid();
    const RegionShape dentine(tissue(Tissue::dentine), specimen), soft(lesion(Hardness::soft), specimen), firm(lesion(Hardness::firm), specimen);
    IVec3 v;
    for (v.z = 0; v.z < grid.size.z; v.z += 3)
      for (v.y = 0; v.y < grid.size.y; v.y += 3)
        for (v.x = 0; v.x < grid.size.x; v.x += 3) {
          const Tissue t = was_solid(*specimen, v) ? specimen->tissue(v) : Tissue::empty;
          const Vec3 p = grid.centre_mm(v) + Vec3(0.04, -0.03, 0.045);
          EXPECT_EQ(dentine.near(p).distance_mm < 0.0, t == Tissue::dentine);
          const bool is_soft = t == Tissue::carious_dentine || t == Tissue::carious_enamel;
          EXPECT_EQ(soft.near(p).distance_mm < 0.0, is_soft);
          EXPECT_EQ(firm.near(p).distance_mm < 0.0, is_soft || t == kFirmCariousDentine);
        }
  }
}

TEST(TissueLeaf, ItsDistanceChangesByNoMoreThanItsPlace) {
  constexpr std::uint64_t kSeed = 51;
  std::mt19937_64 random(kSeed);
  const auto specimen = block();
  for (const Region& region : {tissue(Tissue::pulp), tissue(Tissue::dentine), lesion(Hardness::firm), node(RegionKind::offset, {tissue(Tissue::pulp)}, 0.5)}) {
    const RegionShape shape(region, specimen);
    std::uniform_real_distribution<double> step(-0.05, 0.05);
    for (int i = 0; i < 4000; ++i) {
      const Vec3 a = random_place(random);
      const double x = step(random), y = step(random), z = step(random);
      const Vec3 b = a + Vec3(x, y, z);
      EXPECT_LE(std::fabs(shape.near(a).distance_mm - shape.near(b).distance_mm), glm::length(a - b) + 1e-12) << "seed " << kSeed;
    }
  }
}

TEST(TissueLeaf, ItsDistanceIsThatToTheBall) {
  std::mt19937_64 random(52);
  const RegionShape pulp(tissue(Tissue::pulp), block());
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_place(random);
    // The cubes stand out of the ball, or short of it, by half their diagonal at most.
    EXPECT_NEAR(pulp.near(p).distance_mm, ball_distance(p, kPulp, 0.8), 0.0867);
  }
}

TEST(TissueLeaf, ItsDistanceIsThatToTheNearestCube) {
  constexpr std::uint64_t kSeed = 53;
  std::mt19937_64 random(kSeed);
  const auto specimen = block();
  const Grid& grid = specimen->grid();
  std::vector<Vec3> pulp, other;  // centres
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x)
        (was_solid(*specimen, v) && specimen->tissue(v) == Tissue::pulp ? pulp : other).push_back(grid.centre_mm(v));
  const auto nearest = [&](Vec3 p, const std::vector<Vec3>& centres) {
    double out = 1e9;
    for (const Vec3& c : centres) out = std::min(out, glm::length(glm::max(glm::abs(p - c) - 0.5 * grid.voxel_mm, Vec3(0.0))));
    return out;
  };
  const RegionShape shape(tissue(Tissue::pulp), specimen);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = 0.6 * random_place(random) + Vec3(0, 0, -0.6);
    const double to_pulp = nearest(p, pulp);
    EXPECT_NEAR(shape.near(p).distance_mm, to_pulp > 0.0 ? to_pulp : -nearest(p, other), 1e-12) << "seed " << kSeed;
  }
}

TEST(TissueLeaf, InAUnionItIsAskedWhereverItMatters) {
  constexpr std::uint64_t kSeed = 54;
  std::mt19937_64 random(kSeed);
  const auto specimen = block();
  const RegionShape pulp(tissue(Tissue::pulp), specimen), ball(sphere({0, 0, 0.4}, 1)),
      both(node(RegionKind::joined, {sphere({0, 0, 0.4}, 1), tissue(Tissue::pulp)}, 0.3), specimen);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_place(random);
    const double want = -blended_max(-ball.near(p).distance_mm, -pulp.near(p).distance_mm, 0.3);
    EXPECT_EQ(both.near(p).distance_mm, want) << "seed " << kSeed;
  }
}

TEST(TissueLeaf, AnOffsetIsSoFarIntoItOrAboutIt) {
  const auto specimen = block();
  const RegionShape about(node(RegionKind::offset, {tissue(Tissue::pulp)}, 1.0), specimen);
  EXPECT_LT(about.near(kPulp + Vec3(1.6, 0, 0)).distance_mm, 0.0) << "0.8 mm off the pulp";
  EXPECT_GT(about.near(kPulp + Vec3(1.95, 0, 0)).distance_mm, 0.0) << "1.15 mm off it";
  const RegionShape into(node(RegionKind::offset, {tissue(Tissue::dentine)}, -0.5), specimen);
  EXPECT_GT(into.near({1.8, 1.8, 0}).distance_mm, 0.0) << "0.2 mm into dentine";
  EXPECT_LT(into.near({1.3, 1.3, 0}).distance_mm, 0.0) << "0.7 mm into it";
}

TEST(TissueLeaf, HasABoxAboutItAndAFaceThatFacesOutwards) {
  const auto specimen = block();
  Region named = tissue(Tissue::pulp);
  named.faces = {{"surface", FaceName::axial_wall}};
  const RegionShape pulp(named, specimen);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(pulp.bounds().low[axis], kPulp[axis] - 0.8, 0.11);
    EXPECT_NEAR(pulp.bounds().high[axis], kPulp[axis] + 0.8, 0.11);
  }
  EXPECT_EQ(pulp.near(kPulp).face, FaceName::axial_wall);
  const auto facing = pulp.facing(kPulp + Vec3(0.9, 0, 0), {-1, 0, 0});
  ASSERT_TRUE(facing);
  EXPECT_NEAR(facing->beyond_mm, 0.1, 0.0867);
}

TEST(TissueLeaf, WithoutASpecimenTheTargetIsEmpty) {
  for (const Region& region : {tissue(Tissue::pulp), node(RegionKind::joined, {sphere({0, 0, 0}, 1), lesion(Hardness::soft)})}) {
    const TargetShape shape(region);
    EXPECT_TRUE(shape.empty());
    EXPECT_GT(shape.near({5, 5, 5}).distance_mm, 0.0);
    EXPECT_FALSE(TargetShape(region, block()).empty());
  }
  EXPECT_GT(RegionShape(tissue(Tissue::amalgam), block()).near({0, 0, 0}).distance_mm, 10.0) << "a tissue that is not there";
}

}  // namespace
}  // namespace cusp::test
