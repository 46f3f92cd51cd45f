// A proximal box in a round tooth that touches a round neighbour: depth, contact and clearance against their closed forms.
// Four cases at voxels of 0.1 mm; with CUSP_FULL=1 two hundred, a hundred each at 0.05 and 0.078 mm, and the rows of
// scenarios/metrics/errors.md on stdout.

#include "scenarios/metrics/proximal.h"

#include "tests/full_run.h"
#include "tests/scenarios/metrics/two_teeth.h"

namespace cusp::test {
namespace {

std::map<std::string, double> truth_of(const Box& b, double voxel_mm) {
  std::map<std::string, double> out;
  out["contact_broken"] = 1;
  out["box_height"] = b.gingival - b.pulpal;
  // Along x from the junction's ball to the wall.
  const auto past = [&](double y, double z) { return std::sqrt(kDentineRadius * kDentineRadius - y * y - (z - kMiddle) * (z - kMiddle)) - b.axial_x; };
  double least = 1e9, most = -1e9, sum = 0;
  int count = 0;
  const double floor = -b.gingival + 0.2 + 0.5 * voxel_mm;  // the wall begins above the line angle
  for (double z = floor; z < -b.pulpal; z += 0.01)
    for (double y = b.wall_y(z, false); y < b.wall_y(z, true); y += 0.01) {
      least = std::min(least, past(y, z));
      most = std::max(most, past(y, z));
      sum += past(y, z);
      ++count;
    }
  out["axial_past_junction_least"] = least;
  out["axial_past_junction_most"] = most;
  out["axial_past_junction_mean"] = sum / count;
  for (const bool buccal : {true, false})
    for (int third = 0; third < 3; ++third) {
      double nearest = 1e9;
      for (int i = 0; i <= 200; ++i)
        nearest = std::min(nearest, Box::clearance(b.margin(-b.gingival * (1.0 - (third + i / 200.0) / 3.0), buccal)));
      out[std::string("clearance_") + (buccal ? "buccal_" : "lingual_") + std::array{"gingival", "middle", "occlusal"}[static_cast<std::size_t>(third)]] = nearest;
    }
  const double level = kRadius * kRadius - (kMiddle + b.gingival) * (kMiddle + b.gingival);
  out["clearance_gingival"] = Box::clearance({std::sqrt(level), 0, -b.gingival});
  const double middle = 0.5 * (b.buccal + b.lingual), half = 0.25 * (b.buccal - b.lingual);
  double depth = 0;
  for (int i = 0; i < 1000; ++i) {
    const double y = middle + half * (2.0 * (i + 0.5) / 1000.0 - 1.0);
    depth += (std::sqrt(level - y * y) - b.axial_x) / 1000.0;
  }
  out["gingival_floor_mesiodistal"] = depth;
  return out;
}

TEST(Proximal, OfAKnownBoxIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 41;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (int i = 0; i < known_cases(voxel_mm, 4, 200); ++i) {
      const Box box{draw(2.6, 3.1), draw(1.4, 1.9), draw(-1.9, -1.4), draw(2.9, 3.4), draw(1.6, 2.0), draw(-0.06, 0.08)};
      const auto specimen = two_teeth(voxel_mm, draw, tissue_at);
      const auto truth = truth_of(box, voxel_mm);
      Scenario s = exercise();
      s.rubric = rubric_of(truth);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return box.distance(p); });
      count_groups(Reference(s, specimen), volume, truth, table.rows(voxel_mm));
    }
  }
  table.expect(kSeed);
}

TEST(Proximal, ABoxFarOffItsTargetIsStillMeasured) {
  Draw draw{std::mt19937_64(3)};
  const auto specimen = two_teeth(0.15, draw, tissue_at);
  const Reference reference(exercise(), specimen);
  const auto box_with = [](double Box::* part, double mm) {
    Box box;
    box.*part = mm;
    return box;
  };
  const std::pair<Box, std::vector<std::string>> cases[] = {
      {box_with(&Box::axial_x, 1.6), {"axial_past_junction_least", "axial_past_junction_mean", "axial_past_junction_most", "gingival_floor_mesiodistal"}},
      {box_with(&Box::buccal, 2.7), {"clearance_buccal_gingival", "clearance_buccal_middle", "clearance_buccal_occlusal"}},
      {box_with(&Box::gingival, 4.3), {"clearance_gingival", "box_height"}}};
  for (const auto& [box, keys] : cases) {
    const auto truth = truth_of(box, 0.15);
    Volume volume(specimen);
    carved::carve(volume, [&](Vec3 p) { return box.distance(p); });
    const auto measures = measure(reference, volume, {});
    for (const std::string& key : keys) {
      const Measure m = get(measures, key);
      ASSERT_TRUE(m.measured) << key;
      EXPECT_NEAR(m.value, truth.at(key), m.uncertainty) << key;
    }
  }
}

TEST(Proximal, ABoxThatOpensASideLeavesNoRidgeThereToMeasure) {
  Draw draw{std::mt19937_64(1)};
  Scenario s = exercise();
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  Volume volume(specimen);
  const Region slot = Box::target().parts.front();
  // 0.9 mm stay before the neighbour, and the end of the box is a mesial wall.
  carved::carve(volume, [](Vec3 p) { return std::max(Box{}.distance(p), p.x - 4.1); });
  const auto measures = measure(Reference(s, specimen), volume, {});
  EXPECT_FALSE(get(measures, "ridge_mesial").measured) << "the target's box holds the contact";
  EXPECT_TRUE(get(measures, "ridge_distal").measured);
  s.target = slot;
  EXPECT_TRUE(get(measure(Reference(s, specimen), volume, {}), "ridge_mesial").measured) << "the ridge was to stay";
}

TEST(Proximal, AContactThatStandsIsNotBroken) {
  Draw draw{std::mt19937_64(1)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  const Reference reference(exercise(), specimen);
  Volume volume(specimen);
  // As deep as the box, but 0.3 mm of enamel stay before the neighbour.
  carved::carve(volume, [](Vec3 p) { return std::max(Box{}.distance(p), p.x - 4.7); });
  const Measure standing = get(measure(reference, volume, {}), "contact_broken");
  ASSERT_TRUE(standing.measured);
  EXPECT_EQ(standing.value, 0.0);
  ASSERT_TRUE(standing.where_mm);
  EXPECT_NEAR(glm::length(*standing.where_mm - Vec3(5, 0, -1.5)), 0.0, 1.0) << "where less than 0.1 mm lies between the balls";
  EXPECT_EQ(get(measure(reference, Volume(specimen), {}), "contact_broken").value, 0.0) << "untouched";
}

TEST(Proximal, AContactIsBrokenAtTheSameGapWhateverTheVoxel) {
  // A slab along the neighbour, cut so thick: the tooth then stands as far off.
  const auto along_neighbour = [](double thick) {
    return [thick](Vec3 p) {
      const double off = ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius);
      return std::max(off - thick, -off);
    };
  };
  Scenario s = exercise();
  s.rubric = rubric_of({{"contact_broken", 0}});
  const std::vector<double> voxels = full_run() ? std::vector{0.05, 0.078, 0.1} : std::vector{0.078, 0.1};
  for (const double voxel_mm : voxels)
    for (const std::uint64_t phase : {1u, 2u}) {
      Draw draw{std::mt19937_64(phase)};
      const auto specimen = two_teeth(voxel_mm, draw, tissue_at);
      const Reference reference(s, specimen);
      for (const auto& [gap_mm, broken, sure] : {std::tuple(0.05, 0.0, true), {0.15, 1.0, true}, {0.1, 1.0, false}}) {
        SCOPED_TRACE(testing::Message() << "voxel " << voxel_mm << " mm, phase " << phase << ", gap " << gap_mm);
        Volume volume(specimen);
        carved::carve(volume, along_neighbour(gap_mm));
        const Measure m = get(measure(reference, volume, {}), "contact_broken");
        ASSERT_TRUE(m.measured);
        if (sure) {
          EXPECT_EQ(m.value, broken);
        }
        EXPECT_EQ(m.uncertainty, sure ? 0.0 : 1.0);
        ASSERT_TRUE(m.where_mm);
        EXPECT_NEAR(ball_distance(*m.where_mm, Vec3(kBeside, 0, kMiddle), kRadius), gap_mm, voxel_mm) << "on the tooth, before the neighbour";
      }
    }
}

TEST(Proximal, AClearanceIsShownOnTheMarginThatItIsOf) {
  Draw draw{std::mt19937_64(2)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  const Box box;
  Volume volume(specimen);
  carved::carve(volume, [&](Vec3 p) { return box.distance(p); });
  int places = 0;
  for (const Measure& m : measure(Reference(exercise(), specimen), volume, {})) {
    if (!m.metric.starts_with("clearance_")) continue;
    ASSERT_TRUE(m.measured && m.where_mm) << m.metric;
    EXPECT_NEAR(own_tooth(*m.where_mm), 0.0, 0.05) << m.metric;
    EXPECT_NEAR(box.distance(*m.where_mm), 0.0, 0.05) << m.metric;
    EXPECT_NEAR(Box::clearance(*m.where_mm), m.value, m.uncertainty) << m.metric;
    ++places;
  }
  EXPECT_EQ(places, 7);
}

TEST(Proximal, AClearanceIsToTheNeighbourAsItStoodHoweverDeepItWasCut) {
  Draw draw{std::mt19937_64(2)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  Scenario s = exercise();
  s.rubric = rubric_of({{"clearance_gingival", 0}});
  const Reference reference(s, specimen);
  const Box box;
  const auto truth = truth_of(box, 0.1);
  // The neighbour's whole side, then a groove before the buccal wall alone.
  const auto groove = [](Vec3 p) { return std::fabs(p.y - 1.6) - 0.3; };
  for (const double deep_mm : {0.1, 0.5})
    for (const bool whole : {true, false}) {
      SCOPED_TRACE(testing::Message() << (whole ? "side" : "groove") << " cut " << deep_mm << " mm deep");
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) {
        const double in = -ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius);
        const double nick = std::max({-in, in - deep_mm, whole ? -kRadius : groove(p)});
        return std::min(box.distance(p), nick);
      });
      const auto measures = measure(reference, volume, {});
      for (const auto& [key, mm] : truth) {
        if (!key.starts_with("clearance_")) continue;
        const Measure m = get(measures, key);
        ASSERT_TRUE(m.measured) << key;
        EXPECT_NEAR(m.value, mm, m.uncertainty) << key;
      }
    }
}

TEST(Proximal, WithoutAContactInTheTargetNothingIsSaidOfIt) {
  Draw draw{std::mt19937_64(1)};
  Scenario s = exercise();
  s.target = Box::target().parts.front();  // the slot alone
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 p) { return Box{}.distance(p); });
  const auto measures = measure(Reference(s, specimen), volume, {});
  EXPECT_FALSE(get(measures, "contact_broken").measured);
  EXPECT_FALSE(get(measures, "clearance_gingival").measured);
  EXPECT_FALSE(get(measures, "box_height").measured);
}

TEST(Proximal, AnModHasAFloorOnEitherSide) {
  constexpr double kMesial = 1.5, kDistal = 1.2;  // of a block of 10 mm, floors at z = -3
  Grid grid;
  grid.size = IVec3(114, 74, 60);
  grid.origin_mm = Vec3(-5.63, -3.61, -5.17);
  const auto specimen = carved::specimen(grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -2.25), Vec3(5, 3, 2.25)); },
                                         [](Vec3) { return Tissue::enamel; });
  Scenario s = exercise();
  Region mesial = box_region({7 - kMesial, 0, -1}, {4, 3, 4}), distal = box_region({kDistal - 7, 0, -1}, {4, 3, 4});
  mesial.faces = distal.faces = {{"z_low", FaceName::gingival_floor}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
  mesial.faces["x_low"] = distal.faces["x_high"] = FaceName::axial_wall;
  s.target = node(RegionKind::joined, {Box::target().parts.front(), mesial, distal});
  s.rubric = rubric_of({{"gingival_floor_mesiodistal", 0}});
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 p) {
    return std::min({box_distance(p, Vec3(7 - kMesial, 0, -1), Vec3(2, 1.5, 2)), box_distance(p, Vec3(kDistal - 7, 0, -1), Vec3(2, 1.5, 2)),
                     box_distance(p, Vec3(0, 0, 0), Vec3(4.5, 0.6, 1.8))});
  });
  const Measure depth = get(measure(Reference(s, specimen), volume, {}), "gingival_floor_mesiodistal");
  ASSERT_TRUE(depth.measured);
  EXPECT_NEAR(depth.value, 0.5 * (kMesial + kDistal), depth.uncertainty);
}

TEST(Proximal, TheGingivalFloorIsMeasuredFromTheJunctionBesideIt) {
  Draw draw{std::mt19937_64(1)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  const Reference reference(exercise(), specimen);
  const ToothLandmarks* landmarks = reference.landmarks();
  ASSERT_NE(landmarks, nullptr) << "of tooth 36, in whose frame the balls stand";
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 p) { return Box{}.distance(p); });
  // The junction's heights beside the floor, which is mesial: x above 2.9, y within 1.6 mm.
  double low = 1e9, high = -1e9;
  for (const Vec3& p : landmarks->cej)
    if (p.x > 2 && std::fabs(p.y) < 2.5) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
  const Measure above = get(measure(reference, volume, {}), "gingival_above_cej");
  ASSERT_TRUE(above.measured);
  EXPECT_GE(above.value, -3.2 - high - above.uncertainty);
  EXPECT_LE(above.value, -3.2 - low + above.uncertainty);
}

}  // namespace
}  // namespace cusp::test
