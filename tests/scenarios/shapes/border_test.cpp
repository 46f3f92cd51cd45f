// Where a tissue of voxels ends, against bodies of known shape.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "scenarios/shapes/border_surface.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using Body = std::function<double(Vec3)>;  // mm, negative inside

constexpr TissueSet pulp_alone() {
  TissueSet out{};
  out[index_of(Tissue::pulp)] = true;
  return out;
}

/// 4 mm of dentine about a body of pulp.
std::shared_ptr<const Specimen> dentine_about(const Body& pulp, double voxel_mm, Vec3 phase) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  grid.size = IVec3(8 * static_cast<int>(std::ceil(0.5 / voxel_mm)));
  grid.origin_mm = -0.5 * voxel_mm * Vec3(grid.size) + voxel_mm * phase;
  return carved::specimen(
      grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0.0), Vec3(1.8)); },
      [&](Vec3 p) { return pulp(p) < 0.0 ? Tissue::pulp : Tissue::dentine; });
}

struct Errors {
  std::vector<double> voxels;  // measured - true
  double mean() const {
    double sum = 0;
    for (const double e : voxels) sum += e;
    return sum / static_cast<double>(voxels.size());
  }
  double share_within(double bound) const {
    return static_cast<double>(std::ranges::count_if(voxels, [=](double e) { return std::fabs(e) <= bound; })) / static_cast<double>(voxels.size());
  }
};

/// Errors from places 0.3 to 0.9 mm off bodies in any pose. make_body: a body about a centre and a direction out of it.
template <class MakeBody>
Errors errors_beside(double voxel_mm, MakeBody make_body) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Errors out;
  for (int pose = 0; pose < 16; ++pose) {
    const Vec3 direction = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    const Body body = make_body(direction, 0.3 + 0.5 * share(random));
    const auto specimen = dentine_about(body, voxel_mm, {share(random), share(random), share(random)});
    const BorderSurface surface(specimen, pulp_alone());
    for (int place = 0; place < 25; ++place) {
      const Vec3 at = (1.2 + 0.3 * share(random)) * glm::normalize(direction + 0.2 * Vec3(normal(random), normal(random), normal(random)));
      out.voxels.push_back((surface.distance_mm(at, 5.0) - body(at)) / voxel_mm);
    }
  }
  std::printf("voxel %.3f: mean error %+.3f voxel, within 0.25, 0.35, 0.5 voxel %.1f, %.1f, %.1f %%\n", voxel_mm, out.mean(),
              100.0 * out.share_within(0.25), 100.0 * out.share_within(0.35), 100.0 * out.share_within(0.5));
  return out;
}

Errors beside_balls(double voxel_mm) {
  return errors_beside(voxel_mm, [](Vec3, double radius) -> Body { return [=](Vec3 p) { return glm::length(p) - radius; }; });
}
/// A pulp horn: a cone's rounded end.
Errors beside_horns(double voxel_mm) {
  return errors_beside(voxel_mm, [](Vec3 out, double radius) -> Body {
    const Vec3 tip = (0.8 - 0.5 * radius) * out;
    return [=](Vec3 p) { return capsule_distance(p, Vec3(0.0), tip, 0.5 * radius); };
  });
}
Errors beside_planes(double voxel_mm) {
  return errors_beside(voxel_mm, [](Vec3 out, double height) -> Body { return [=](Vec3 p) { return glm::dot(p, out) - height; }; });
}

TEST(BorderSurface, LiesOnTheBorderInTheMeanWhereThatIsFlat) {
  const Errors errors = beside_planes(0.1);
  EXPECT_LT(std::fabs(errors.mean()), 0.1);
  EXPECT_GE(errors.share_within(0.5), 0.95);
}

TEST(BorderSurface, LiesOnTheBorderInTheMeanWhereThatIsRound) {
  for (const double voxel_mm : {0.05, 0.1}) {
    const Errors errors = beside_balls(voxel_mm);
    EXPECT_LT(std::fabs(errors.mean()), 0.15) << voxel_mm;
    EXPECT_GE(errors.share_within(0.5), 0.95) << voxel_mm;
  }
}

TEST(BorderSurface, LiesOnAHornOfThreeVoxels) {
  for (const double voxel_mm : {0.05, 0.1}) {
    const Errors errors = beside_horns(voxel_mm);
    EXPECT_LT(std::fabs(errors.mean()), 0.3) << voxel_mm;
    EXPECT_GE(errors.share_within(0.5), 0.95) << voxel_mm;
  }
}

TEST(BorderSurface, IsNoDistanceOffJustWithin) {
  const auto specimen = dentine_about([](Vec3 p) { return glm::length(p) - 0.6; }, 0.1, Vec3(0.0));
  const BorderSurface surface(specimen, pulp_alone());
  EXPECT_EQ(surface.distance_mm(Vec3(0.52, 0.0, 0.0), 5.0), 0.0);
  EXPECT_LT(surface.distance_mm(Vec3(0.3, 0.3, 0.32), 5.0), 0.01) << "between discs: a tenth of a voxel";
  EXPECT_EQ(surface.distance_mm(Vec3(0.0, 0.0, 1.5), 0.4), 0.4) << "no further than asked";
}

TEST(BorderSurface, OfALoneVoxelIsABall) {
  const auto specimen = dentine_about([](Vec3 p) { return box_distance(p, Vec3(0.0), Vec3(0.06)); }, 0.1, Vec3(0.0));
  const BorderSurface surface(specimen, pulp_alone());
  ASSERT_EQ(surface.voxels().size(), 1u);
  EXPECT_NEAR(surface.distance_mm(Vec3(0.0, 0.0, 1.0), 5.0), 0.95, 1e-9);
}

TEST(BorderSurface, OfATissueThatIsNotThereIsEmpty) {
  const auto specimen = dentine_about([](Vec3) { return 1.0; }, 0.1, Vec3(0.0));
  const BorderSurface surface(specimen, pulp_alone());
  EXPECT_TRUE(surface.empty());
  EXPECT_EQ(surface.distance_mm(Vec3(0.0), 2.5), 2.5);
}

}  // namespace
}  // namespace cusp::test
