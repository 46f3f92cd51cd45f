#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "scenarios/shapes/outline_size.h"
#include "scenarios/shapes/place.h"
#include "scenarios/shapes/target.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

Outline channel() {
  Outline t;
  t.shape = "channel";
  t.paths = {{Vec3(-3, 0.5, 0), Vec3(2, -0.5, 0)}};
  t.width_mm = 1.6;
  t.depth_mm = 2.0;
  t.top_mm = 0.0;
  t.corner_radius_mm = 0.5;
  return t;
}
Outline fissures() {
  Outline t = channel();
  t.shape = "outline";
  t.paths = {{Vec3(-3, 0, 0), Vec3(-1, 0.6, 0), Vec3(1, 0, 0), Vec3(3, 0.4, 0)}, {Vec3(1, 0, 0), Vec3(1.2, 1.5, 0)}};
  return t;
}
Outline box() {
  Outline t = channel();
  t.shape = "box";
  t.paths = {{Vec3(0.3, -0.2, 0)}};
  t.box_size_mm = {4.0, 2.5, 0.0};
  return t;
}

/// The same solid by definition, without any distance: a place is in the target when a ball of the corner's radius, its
/// centre within the outline inset by that radius and above the floor by it, holds it, or when it is above that height.
bool inside_by_definition(const Outline& t, Vec3 p) {
  const OutlineShape shape(t);
  const double r = shape.corner_mm();
  const double u = shape.outline_mm({p.x, p.y});
  const double z = p.z - shape.floor_mm();
  if (u > 0.0 || z < 0.0) return false;
  if (z >= r || u <= -r) return true;
  return (u + r) * (u + r) + (r - z) * (r - z) <= r * r;
}

/// Sizes that a formula gives, to the raster's 2 %.
TEST(OutlineSize, IsFloorAndWallOfTheOutlineByItself) {
  const double length = std::hypot(5.0, 1.0), width = 1.6, round = std::numbers::pi * width;
  const OutlineSize slot = size_of(channel());
  EXPECT_NEAR(slot.floor_mm2, length * width + 0.25 * round * width, 0.02 * slot.floor_mm2);
  EXPECT_NEAR(slot.wall_mm2, 2.0 * (2.0 * length + round), 0.02 * slot.wall_mm2);
  const OutlineSize rectangle = size_of(box());
  EXPECT_NEAR(rectangle.floor_mm2, 10.0, 0.2);
  EXPECT_NEAR(rectangle.wall_mm2, 26.0, 0.52);
  Outline twice = channel();
  twice.shape = "outline";
  twice.paths.push_back(twice.paths.front());
  EXPECT_NEAR(size_of(twice).floor_mm2, slot.floor_mm2, 1e-9) << "what two slots share counts once";
  Outline leaning = channel();
  leaning.taper_deg = {10, 10, 10, 10};
  EXPECT_EQ(size_of(leaning).floor_mm2, slot.floor_mm2) << "where it is narrowest";
  Outline none = channel();
  none.paths.clear();
  EXPECT_EQ(size_of(none).floor_mm2, 0.0);
}

TEST(OutlineShape, TheSignIsTheDefinitionOfTheShape) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-5, 5), z(-3.5, 2);
  for (const Outline& t : {channel(), fissures(), box()}) {
    const OutlineShape shape(t);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p(x(random), x(random), z(random));
      const double d = shape.distance_mm(p);
      if (std::fabs(d) <= 1e-9) continue;
      EXPECT_EQ(d < 0.0, inside_by_definition(t, p)) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(OutlineShape, OutsideTheDistanceIsThatOfTheNearestSurfacePointButBesideARectanglesRoundedCorners) {
  // Brute force: points of the shape's surface, found by marching along rays, 0.02 mm apart at most.
  for (const Outline& t : {channel(), fissures(), box()}) {
    const OutlineShape shape(t);
    std::vector<Vec3> surface;
    const double step = 0.02;
    for (double px = shape.low().x - 0.1; px < shape.high().x + 0.1; px += step)
      for (double py = shape.low().y - 0.1; py < shape.high().y + 0.1; py += step) {
        const double u = shape.outline_mm({px, py});
        const double r = shape.corner_mm();
        if (u > 0.0) continue;
        // Height of the floor under this place, from the definition.
        const double lift = u > -r ? r - std::sqrt(std::max(0.0, r * r - (u + r) * (u + r))) : 0.0;
        surface.push_back({px, py, shape.floor_mm() + lift});
        if (u > -step)
          for (double z = shape.floor_mm() + lift; z < 1.0; z += step) surface.push_back({px, py, z});
      }
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(-5, 5), z(-3.5, 0.5);
    int checked = 0;
    for (int i = 0; i < 400; ++i) {
      const Vec3 p(x(random), x(random), z(random));
      const double d = shape.distance_mm(p);
      if (d <= 0.05) continue;
      double nearest = 1e9;
      for (const Vec3& q : surface) nearest = std::min(nearest, glm::length(p - q));
      constexpr double kSpacing = 0.035;
      EXPECT_LE(d, nearest + kSpacing) << t.shape << " at " << p.x << " " << p.y << " " << p.z;
      // Measured 0.0448 of 0.5 mm along the edge's normals: the formula takes the distance in the plane for that from the inset outline.
      const double falls_short = t.shape == "box" ? 0.09 * shape.corner_mm() : 0.0;
      EXPECT_GE(d, nearest - kSpacing - falls_short) << t.shape << " at " << p.x << " " << p.y << " " << p.z;
      ++checked;
    }
    EXPECT_GT(checked, 100);
  }
}

TEST(OutlineShape, WhatStandsAboveTheReferencePlaneWithinTheOutlineIsToGoToo) {
  const OutlineShape shape(channel());
  EXPECT_LT(shape.distance_mm({-0.5, 0.0, 3.0}), 0.0);
  EXPECT_GT(shape.distance_mm({-0.5, 2.0, 3.0}), 0.0);
}

TEST(OutlineShape, ACornerRadiusThatDoesNotFitIsCutToHalfTheWidth) {
  Outline t = channel();
  t.corner_radius_mm = 5.0;
  EXPECT_DOUBLE_EQ(OutlineShape(t).corner_mm(), 0.8);
  t.depth_mm = 0.3;
  EXPECT_DOUBLE_EQ(OutlineShape(t).corner_mm(), 0.3);
}

TEST(OutlineShape, WithoutAPathItIsEmpty) {
  Outline t = channel();
  t.paths.clear();
  EXPECT_TRUE(OutlineShape(t).empty());
  t.shape = "box";
  EXPECT_TRUE(OutlineShape(t).empty());
  t.shape = "outline";
  t.paths = {{}};
  EXPECT_TRUE(OutlineShape(t).empty());
}

TEST(OutlineShape, APathOfOnePointIsARoundHole) {
  Outline t = channel();
  t.paths = {{Vec3(1, 2, 0)}};
  const OutlineShape shape(t);
  EXPECT_NEAR(shape.outline_mm({1.0, 3.0}), 1.0 - 0.8, 1e-12);
  EXPECT_NEAR(shape.outline_mm({1.0, 2.0}), -0.8, 1e-12);
}

TEST(Place, APlaceBelongsToTheFaceThatItIsNearestTo) {
  Outline t = channel();
  t.paths = {{Vec3(-3, 0, 0), Vec3(3, 0, 0)}};  // walls at y = ±0.8, floor at z = -2, corner 0.5
  const TargetShape shape(region_of(t));
  Leeway leeway;
  leeway.floor_mm = 0.3;
  leeway.side_mm = 0.2;
  EXPECT_EQ(place_of(shape, leeway, {0, 0, -1}), Place::target);
  EXPECT_EQ(place_of(shape, leeway, {0, 0, -2.25}), Place::tolerated_floor);
  EXPECT_EQ(place_of(shape, leeway, {0, 0, -2.35}), Place::beyond_floor);
  EXPECT_EQ(place_of(shape, leeway, {0, 0.95, -1}), Place::tolerated_side);
  EXPECT_EQ(place_of(shape, leeway, {0, 1.05, -1}), Place::beyond_side);
  EXPECT_EQ(place_of(shape, leeway, {0, 0.95, 5}), Place::tolerated_side);
  // Off the rounded edge, centre of curvature (y 0.3, z -1.5): 0.25 beyond it, either side of the bisector.
  const auto off = [](double degrees) {
    const double a = degrees * 3.14159265358979 / 180.0;
    return Vec3(0, 0.3 + 0.75 * std::cos(a), -1.5 - 0.75 * std::sin(a));
  };
  EXPECT_EQ(place_of(shape, leeway, off(50)), Place::tolerated_floor);
  EXPECT_EQ(place_of(shape, leeway, off(40)), Place::beyond_side);
}

}  // namespace
}  // namespace cusp::test
