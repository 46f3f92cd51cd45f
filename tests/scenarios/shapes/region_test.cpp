#include "scenarios/shapes/region.h"

#include <gtest/gtest.h>

#include <numbers>

#include <random>

#include "scenarios/shapes/place.h"
#include "tests/modules.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

Outline slot(double taper_deg) {
  Outline out;
  out.paths = {{Vec3(-2, 0, -2), Vec3(2, 0.5, -2)}};
  out.width_mm = 1.0;
  out.corner_radius_mm = 0.3;
  out.taper_deg = {taper_deg, taper_deg, taper_deg, 0.5 * taper_deg};
  return out;
}
Region turned_box() {
  Region out = box_region({0.3, 0, -1}, {2, 1, 1.5});
  out.x_axis = {3, 1, 0};  // of any length, and not at a right angle to the other
  out.z_axis = {0.2, 0, 2};
  return out;
}

struct Named {
  const char* name;
  Region region;
  bool (*inside)(Vec3);  // by definition, without a distance
};

std::vector<Named> leaves() {
  Region ellipsoid = box_region({0, 0, -1}, {3, 2, 1});
  ellipsoid.kind = RegionKind::ellipsoid;
  return {
      {"box", box_region({0, 0, -1}, {2, 1, 1.5}), [](Vec3 p) { return std::fabs(p.x) < 1 && std::fabs(p.y) < 0.5 && std::fabs(p.z + 1) < 0.75; }},
      {"cylinder", along(RegionKind::cylinder, {0, 0, -2}, {0, 0, 1}, 0.8), [](Vec3 p) { return p.z > -2 && p.z < 1 && p.x * p.x + p.y * p.y < 0.64; }},
      {"cone", along(RegionKind::cone, {0, 0, -2}, {0, 0, 1}, 0.5, 1.4),
       [](Vec3 p) { return p.z > -2 && p.z < 1 && std::sqrt(p.x * p.x + p.y * p.y) < 0.5 + 0.3 * (p.z + 2); }},
      {"sphere", sphere({0.2, 0, -1}, 0.9), [](Vec3 p) { return glm::length(p - Vec3(0.2, 0, -1)) < 0.9; }},
      {"capsule", along(RegionKind::capsule, {-1, 0, -1}, {1, 0, -1}, 0.6),
       [](Vec3 p) { return glm::length(p - Vec3(std::clamp(p.x, -1.0, 1.0), 0, -1)) < 0.6; }},
      {"ellipsoid", ellipsoid, [](Vec3 p) { return p.x * p.x / 2.25 + p.y * p.y + (p.z + 1) * (p.z + 1) / 0.25 < 1; }},
      {"half-space", half_space({0, 0, -1}, {0, 3, 4}), [](Vec3 p) { return 3 * p.y + 4 * (p.z + 1) < 0; }},
  };
}

std::vector<Region> trees() {
  std::vector<Region> out;
  for (const Named& one : leaves()) out.push_back(one.region);
  out.push_back(turned_box());
  for (const double taper : {0.0, 6.0, -4.0, 25.0}) out.push_back(region_of(slot(taper)));
  Outline drawn = slot(8.0);
  drawn.shape = "box";
  drawn.paths = {{Vec3(0.2, 0, -2)}};
  drawn.box_size_mm = {2, 1, 0};
  out.push_back(region_of(drawn));
  for (const double rounding : {0.0, 0.4}) {
    out.push_back(node(RegionKind::joined, {region_of(slot(3)), box_region({2, 0, -2}, {1, 2, 3})}, rounding));
    out.push_back(node(RegionKind::common, {sphere({0, 0, 0}, 2), half_space({0, 0, -0.5}, {0, 0.2, 1}), turned_box()}, rounding));
    out.push_back(node(RegionKind::difference, {turned_box(), sphere({0, 0, 0}, 1), along(RegionKind::capsule, {-1, 0, -1}, {1, 0, -1}, 0.3)}, rounding));
  }
  out.push_back(node(RegionKind::offset, {node(RegionKind::difference, {turned_box(), sphere({0, 0, 0}, 1)}, 0.2)}, 0.3));
  return out;
}

class Places {
 public:
  Vec3 next() { return {at_(random_), at_(random_), at_(random_)}; }
  Vec3 beside(Vec3 p) { return p + 0.02 * next(); }

 private:
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> at_{-4, 3};
};

TEST(Region, TheSignOfEveryLeafIsItsDefinition) {
  Places places;
  for (const Named& one : leaves()) {
    const RegionShape shape(one.region);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = places.next();
      const double d = shape.near(p).distance_mm;
      if (std::fabs(d) > 1e-9) { EXPECT_EQ(d < 0, one.inside(p)) << one.name << ' ' << p.x << ' ' << p.y << ' ' << p.z; }
    }
  }
}

TEST(Region, ADistanceChangesByNoMoreThanItsPlace) {
  Places places;
  const std::vector<Region> all = trees();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const RegionShape shape(all[i]);
    for (int n = 0; n < 20000; ++n) {
      const Vec3 p = places.next(), q = n % 2 == 0 ? places.beside(p) : places.next();
      const double change = std::fabs(shape.near(p).distance_mm - shape.near(q).distance_mm);
      ASSERT_LE(change, glm::length(p - q) + 1e-9) << "tree " << i;
    }
  }
}

TEST(Region, ANodeHasTheSignOfItsParts) {
  Places places;
  const Region a = turned_box(), b = sphere({0, 0, -0.5}, 1);
  const RegionShape first(a), second(b), joined(node(RegionKind::joined, {a, b})), common(node(RegionKind::common, {a, b})),
      less(node(RegionKind::difference, {a, b}));
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = places.next();
    const bool in_a = first.near(p).distance_mm < 0, in_b = second.near(p).distance_mm < 0;
    EXPECT_EQ(joined.near(p).distance_mm < 0, in_a || in_b);
    EXPECT_EQ(common.near(p).distance_mm < 0, in_a && in_b);
    EXPECT_EQ(less.near(p).distance_mm < 0, in_a && !in_b);
  }
}

TEST(Region, ARoundedEdgePassesTheMiddleOfTheRoundOne) {
  // Two faces at a right angle, radius 0.5: the arc's middle lies 0.5 (sqrt 2 - 1) off the edge, along its bisector.
  const RegionShape edge(node(RegionKind::common, {half_space({0, 0, 0}, {1, 0, 0}), half_space({0, 0, 0}, {0, 1, 0})}, 0.5));
  const double in = 0.5 * (std::sqrt(2.0) - 1.0) / std::sqrt(2.0);
  EXPECT_NEAR(edge.near({-in, -in, 0}).distance_mm, 0.0, 1e-12);
  // Off the middle the parabola and the arc part by 0.0063 mm at most (measured).
  for (double deg = 0; deg <= 45; deg += 1) {
    const double t = deg * 3.14159265358979 / 180;
    EXPECT_NEAR(edge.near({-0.5 + 0.5 * std::cos(t), -0.5 + 0.5 * std::sin(t), 0}).distance_mm, 0.0, 0.007) << deg;
  }
}

TEST(Region, ALoneOutlineIsFormatOnesTargetBitForBit) {
  Places places;
  Outline drawn = slot(0);
  drawn.shape = "box";
  drawn.box_size_mm = {2, 1, 0};
  for (const Outline& outline : {slot(0), drawn}) {
    const OutlineShape shape(outline);
    const TargetShape target(region_of(outline));
    ASSERT_NE(target.upright(), nullptr);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = places.next();
      const double want = rounded_corner(shape.outline_mm({p.x, p.y}), shape.below_floor_mm(p.z), shape.corner_mm());
      EXPECT_EQ(target.distance_mm(p), want);
      EXPECT_EQ(target.near(p).distance_mm, want);
    }
  }
}

TEST(Region, ATaperedWallLeansByItsDegrees) {
  Outline out = slot(0);
  out.shape = "box";
  out.paths = {{Vec3(0, 0, -2)}};
  out.box_size_mm = {2, 1, 0};
  out.corner_radius_mm = 0;
  out.taper_deg = {10, 0, -5, 0};
  const OutlineShape shape(out);
  const double t10 = std::tan(10 * 3.14159265358979324 / 180), t5 = std::tan(5 * 3.14159265358979324 / 180);
  for (const double up : {0.0, 0.7, 2.0}) {
    EXPECT_NEAR(shape.wall_mm({-1 - t10 * up, 0, -2 + up}), 0.0, 1e-12) << "opens upwards from the floor";
    EXPECT_NEAR(shape.wall_mm({1, 0, -2 + up}), 0.0, 1e-12) << "upright";
    EXPECT_NEAR(shape.wall_mm({0, -0.5 - t5 * (2 - up), -2 + up}), 0.0, 1e-12) << "opens downwards from the plane";
  }
  EXPECT_NEAR(shape.wall_mm({-1 - 2 * t10, 0, 3}), 0.0, 1e-12) << "upright above the plane";
  EXPECT_NEAR(shape.low().x, -1 - 2 * t10, 1e-12);
}

TEST(Region, APlaceBelongsToTheNamedFaceThatItIsNearestTo) {
  Region proximal = box_region({3, 0, -2}, {1.5, 3, 4});
  proximal.faces = {{"z_low", FaceName::gingival_floor}, {"x_low", FaceName::axial_wall}, {"y_low", FaceName::buccal_wall}};
  Outline isthmus = slot(0);
  isthmus.paths = {{Vec3(-2, 0, -2), Vec3(3, 0, -2)}};
  const RegionShape shape(node(RegionKind::joined, {region_of(isthmus), proximal}));
  EXPECT_EQ(shape.near({0, 0, -2.1}).face, FaceName::pulpal_floor);
  EXPECT_EQ(shape.near({0, 0.6, -1}).face, FaceName::side_wall);
  EXPECT_EQ(shape.near({3, 0, -4.1}).face, FaceName::gingival_floor);
  EXPECT_EQ(shape.near({2.2, 0, -3}).face, FaceName::axial_wall);
  EXPECT_EQ(shape.near({3, -1.6, -2}).face, FaceName::buccal_wall);
  Places places;
  for (int i = 0; i < 5000; ++i) {
    const Near near = shape.near(places.next());
    EXPECT_EQ(is_floor(near.face), near.floor_mm >= near.wall_mm);
  }
}

TEST(Region, BesideALeaningWallAPlaceBelongsToTheWallThatItIsOff) {
  Outline out = slot(0);
  out.shape = "box";
  out.paths = {{Vec3(0, 0, -2)}};
  out.box_size_mm = {2, 1, 0};
  out.taper_deg = {20, 20, 0, 0};  // at the top the ends stand 2 tan 20 = 0.73 mm further out
  Region region = region_of(out);
  region.faces = {{"x_high", FaceName::mesial_wall}, {"y_high", FaceName::buccal_wall}};
  const RegionShape shape(region);
  EXPECT_EQ(shape.near({1.5, 0.6, 0}).face, FaceName::buccal_wall) << "0.1 mm off it, 0.23 mm within the mesial one";
  EXPECT_EQ(shape.near({1.9, 0.4, 0}).face, FaceName::mesial_wall);
}

TEST(Region, TheToleranceZoneIsAsWideAsItsFaceSays) {
  const TargetShape shape(region_of(slot(0)));
  Leeway leeway;
  leeway.floor_mm = leeway.side_mm = 0.3;
  leeway.faces = {{FaceName::pulpal_floor, 0.1}};
  EXPECT_EQ(place_of(shape, leeway, {0, 0.25, -2.09}), Place::tolerated_floor);
  EXPECT_EQ(place_of(shape, leeway, {0, 0.25, -2.11}), Place::beyond_floor);
  EXPECT_EQ(place_of(shape, leeway, {0, 1.0, -1}), Place::tolerated_side);
}

TEST(Region, ItsBoundsHoldIt) {
  Places places;
  for (const Region& region : trees()) {
    const RegionShape shape(region);
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = places.next();
      if (shape.near(p).distance_mm > 0) continue;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p[axis], shape.bounds().low[axis] - 1e-9);
        EXPECT_LE(p[axis], shape.bounds().high[axis] + 1e-9);
      }
    }
  }
}

TEST(Region, ATreeWithoutAnOutlineHasNoPlaneForDepth) {
  EXPECT_FALSE(TargetShape(sphere({0, 0, 0}, 1)).has_plane());
  EXPECT_TRUE(TargetShape(node(RegionKind::joined, {sphere({0, 0, 0}, 1), region_of(slot(2))})).has_plane());
}

constexpr Vec3 kUp(0, 0, 1);

/// A slot 2 mm deep along x, and at its end a box 4 mm deep whose faces have names.
Region slot_and_box() {
  Region proximal = box_region({3, 0, -2}, {2, 2.4, 4});
  proximal.faces = {{"z_low", FaceName::gingival_floor}, {"x_low", FaceName::axial_wall}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
  return node(RegionKind::joined, {region_of(slot(0)), proximal});
}

TEST(Facing, AFloorThatWasCutShortBelongsToItsFloorWhicheverWallIsNearer) {
  const RegionShape shape(slot_and_box());
  const auto floor = shape.facing({3, 1.1, -3.2}, kUp);  // 0.8 mm short of the gingival floor, 0.1 mm off the buccal wall
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->face, FaceName::gingival_floor);
  EXPECT_NEAR(floor->beyond_mm, -0.8, 1e-12);
  EXPECT_NEAR(floor->beside_mm, 0.0, 1e-12);
  EXPECT_NEAR(floor->wall_mm, -0.1, 1e-12);
  const auto wall = shape.facing({3, 1.1, -3.2}, {0, -1, 0});  // the same place as a wall that looks lingually
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->face, FaceName::buccal_wall);
  EXPECT_NEAR(wall->floor_mm, -0.8, 1e-12);
  EXPECT_EQ(wall->floor, FaceName::gingival_floor);
}

TEST(Facing, AFloorIsThatOfThePartItLiesOver) {
  const RegionShape shape(slot_and_box());
  EXPECT_EQ(shape.facing({0, 0, -2.7}, kUp)->face, FaceName::pulpal_floor);
  EXPECT_EQ(shape.facing({3.5, 0, -3.1}, kUp)->face, FaceName::gingival_floor) << "nearer to the height of the pulpal floor";
  EXPECT_EQ(shape.facing({2.1, 0, -3.0}, {1, 0, 0})->face, FaceName::axial_wall);
}

TEST(Facing, NothingFacesACeiling) {
  EXPECT_FALSE(RegionShape(region_of(slot(0))).facing({0, 0, -1}, {0, 0, -1}));
}

TEST(Facing, OfWhatIsTakenOffTheFacesAreTurned) {
  // A ball of 1 mm stays in a box: what was cut about it looks outwards.
  const RegionShape shape(node(RegionKind::difference, {box_region({0, 0, 0}, {6, 6, 6}), sphere({0, 0, 0}, 1)}));
  const auto about = shape.facing({1.2, 0, 0}, {1, 0, 0});
  ASSERT_TRUE(about);
  EXPECT_NEAR(about->beyond_mm, -0.2, 1e-12) << "0.2 mm of the target stand on the ball";
  const auto wall = shape.facing({2.9, 0, 0}, {-1, 0, 0});
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->beyond_mm, -0.1, 1e-12);
}

TEST(Facing, OfAnOffsetTheFacesMoveWithIt) {
  const RegionShape shape(node(RegionKind::offset, {sphere({0, 0, 0}, 1)}, 0.5));
  EXPECT_NEAR(shape.facing({0, 0, -1.6}, kUp)->beyond_mm, 0.1, 1e-12);
}

TEST(Facing, AnOffsetShrinksWhatIsTakenOff) {
  // A ball of 1 mm stays in a box; grown by 0.3 mm the target leaves a ball of 0.7 mm.
  const Region hollow = node(RegionKind::difference, {box_region({0, 0, 0}, {6, 6, 6}), sphere({0, 0, 0}, 1)});
  const RegionShape shape(node(RegionKind::offset, {hollow}, 0.3));
  for (const auto& [p, into_void] : {std::pair{Vec3(0.7, 0, 0), Vec3(1, 0, 0)}, {Vec3(3.3, 0, 0), Vec3(-1, 0, 0)}}) {
    EXPECT_NEAR(shape.near(p).distance_mm, 0.0, 1e-12);
    EXPECT_NEAR(shape.facing(p, into_void)->beyond_mm, 0.0, 1e-12) << p.x;
  }
  EXPECT_NEAR(shape.facing({0.9, 0, 0}, {1, 0, 0})->beyond_mm, -0.2, 1e-12) << "0.2 mm of the target stand on the ball";
}

TEST(Facing, EachFaceOfEachLeafIsFound) {
  const auto out = [](const Region& region, Vec3 p, Vec3 into_void) {
    const auto found = RegionShape(region).facing(p, into_void);
    return found ? found->beyond_mm : 99.0;
  };
  const double s = std::sqrt(0.5);
  EXPECT_NEAR(out(along(RegionKind::cylinder, {0, 0, -2}, {0, 0, 0}, 1), {0, 0, -2.1}, kUp), 0.1, 1e-12);
  EXPECT_NEAR(out(along(RegionKind::cylinder, {0, 0, -2}, {0, 0, 0}, 1), {0.8, 0, -1}, {-1, 0, 0}), -0.2, 1e-12);
  EXPECT_NEAR(out(along(RegionKind::cone, {0, 0, -1}, {0, 0, 0}, 1, 2), {1.5 - 0.1 * s, 0, -0.5 + 0.1 * s}, {-s, 0, s}), -0.1, 1e-12);
  EXPECT_NEAR(out(along(RegionKind::capsule, {0, 0, -2}, {0, 0, 0}, 1), {0, 0, -3.1}, kUp), 0.1, 1e-12);
  EXPECT_NEAR(out(half_space({0, 0, -1}, {0, 0, -1}), {5, 5, -0.8}, kUp), -0.2, 1e-12);
  Region ellipsoid = box_region({0, 0, 0}, {4, 4, 2});
  ellipsoid.kind = RegionKind::ellipsoid;
  EXPECT_NEAR(out(ellipsoid, {0, 0, -1}, kUp), 0.0, 1e-12);
  Region tapered = region_of(slot(0));
  tapered.outline.shape = "box";
  tapered.outline.paths = {{Vec3(0, 0, -2)}};
  tapered.outline.box_size_mm = {4, 2, 0};
  tapered.outline.taper_deg = {0, 10, 0, 0};
  const double wall_x = 2 + 1 * std::tan(10 * std::numbers::pi / 180);  // a millimetre above the floor
  EXPECT_NEAR(out(tapered, {wall_x, 0, -1}, {-1, 0, 0}), 0.0, 1e-12);
}

}  // namespace
}  // namespace cusp::test
