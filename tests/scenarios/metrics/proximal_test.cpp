// A proximal box in a round tooth that touches a round neighbour: depth, contact, clearance and caries against their closed forms.
// Eight cases at voxels of 0.1 mm; with CUSP_FULL=1 twenty each at 0.05, 0.078 and 0.1 mm, and the table of scenarios/metrics/README.md.

#include "scenarios/metrics/proximal.h"

#include "scenarios/metrics/caries.h"
#include "scenarios/metrics/unsupported.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/metrics/known.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

/// Two balls whose lower and upper parts are cut off; they touch at (5, 0, -1.5), 0.01 mm apart.
constexpr double kRadius = 5.0, kMiddle = -1.5, kBeside = 10.01, kDentineRadius = 3.6;
double own_tooth(Vec3 p) {
  return std::max(ball_distance(p, Vec3(0, 0, kMiddle), kRadius), box_distance(p, Vec3(2, 0, -2.25), Vec3(4, 3, 2.25)));
}
double neighbour(Vec3 p) {
  return std::max(ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius), box_distance(p, Vec3(5.5, 0, -2.25), Vec3(1, 3, 2.25)));
}
Tissue tissue_at(Vec3 p) {
  if (neighbour(p) < own_tooth(p)) return kNeighbourEnamel;
  return ball_distance(p, Vec3(0, 0, kMiddle), kDentineRadius) < 0.0 ? Tissue::dentine : Tissue::enamel;
}

template <class TissueAt>
std::shared_ptr<const Specimen> two_teeth(double voxel_mm, Draw& draw, TissueAt&& tissue) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  grid.size = IVec3(glm::ceil(Vec3(8.5, 6.0, 4.5) / voxel_mm)) + 10;
  const double x = draw(0, 1), y = draw(0, 1), z = draw(0, 1);
  grid.origin_mm = Vec3(-2, -3, -4.5) + voxel_mm * (Vec3(x, y, z) - 5.0);
  return carved::specimen(grid, Reading::banded, [](Vec3 p) { return std::min(own_tooth(p), neighbour(p)); }, tissue);
}

/// A slot and a box at its mesial end. Walls stand at y = lingual and buccal at the gingival floor and open by `slope` a mm.
struct Box {
  double axial_x = 2.9, buccal = 1.6, lingual = -1.6, gingival = 3.2, pulpal = 1.8, slope = 0.0;

  double wall_y(double z, bool at_buccal) const {
    const double up = slope * (z + gingival);
    return at_buccal ? buccal + up : lingual - up;
  }
  /// The void, which ends at the neighbour.
  double distance(Vec3 p) const {
    const double steep = std::sqrt(1.0 + slope * slope);
    const double walls = std::max(p.y - wall_y(p.z, true), wall_y(p.z, false) - p.y) / steep;
    const double box = std::max({walls, axial_x - p.x, -gingival - p.z});
    const double slot = std::max({std::fabs(p.y) - 0.6, -pulpal - p.z, -1.2 - p.x});
    return std::max(std::min(box, slot), -ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius));
  }
  static Region target() {
    Region proximal = box_region({4.9, 0, -1.1}, {4, 3.2, 4.2});
    proximal.faces = {{"z_low", FaceName::gingival_floor}, {"x_low", FaceName::axial_wall}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
    Outline slot;
    slot.shape = "box";
    slot.paths = {{Vec3(1, 0, -1.8)}};
    slot.box_size_mm = {4.4, 1.2, 0};
    slot.depth_mm = 1.8;
    slot.corner_radius_mm = 0.2;
    return node(RegionKind::joined, {region_of(slot), proximal});
  }
  /// The margin of a wall on the round tooth at a height.
  Vec3 margin(double z, bool at_buccal) const {
    const double y = wall_y(z, at_buccal);
    return {std::sqrt(kRadius * kRadius - y * y - (z - kMiddle) * (z - kMiddle)), y, z};
  }
  static double clearance(Vec3 p) { return ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius); }
};

Scenario exercise() {
  Scenario s = box_exercise_on_36({2, 1, 2}, {Tissue::enamel, 3, 0.5});
  s.target = Box::target();
  s.rubric = whole_rubric();
  return s;
}

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
  for (const double voxel_mm : known_voxels()) {
    SCOPED_TRACE(testing::Message() << "voxel " << voxel_mm << " mm, seed " << kSeed);
    Draw draw{std::mt19937_64(kSeed)};
    KnownRows rows;
    for (int i = 0; i < (full_run() ? 20 : 8); ++i) {
      const Box box{draw(2.6, 3.1), draw(1.4, 1.9), draw(-1.9, -1.4), draw(2.9, 3.4), draw(1.6, 2.0), draw(-0.06, 0.08)};
      const auto specimen = two_teeth(voxel_mm, draw, tissue_at);
      const auto truth = truth_of(box, voxel_mm);
      Scenario s = exercise();
      s.rubric = rubric_of(truth);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return box.distance(p); });
      count_case(Reference(s, specimen), volume, truth, rows);
    }
    expect_known(voxel_mm, rows);
  }
}

Measure get(const std::vector<Measure>& measures, std::string_view metric) {
  const auto found = std::ranges::find(measures, metric, &Measure::metric);
  return found == measures.end() ? not_measured("absent", "") : *found;
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
  for (const double voxel_mm : {0.05, 0.078, 0.1})
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

/// A slot through enamel into a ball of dentine, and a groove beneath the enamel about it. Rods are the ball's radii.
struct UndercutSlot {
  double half_x = 0.7, half_y = 0.5, depth = 2.0, groove = 0.2, x = 1.0;
  static constexpr Vec3 kMiddleMm{1, 0, -5};
  static constexpr double kBallMm = 3.5;

  static double dentine(Vec3 p) { return ball_distance(p, kMiddleMm, kBallMm); }
  static Tissue tissue(Vec3 p) { return neighbour(p) < own_tooth(p) ? kNeighbourEnamel : dentine(p) < 0.0 ? Tissue::dentine : Tissue::enamel; }

  bool removed(Vec3 p) const { return distance(p) < 0.0; }
  double distance(Vec3 p) const {
    const auto slot = [&](double more) { return std::max({std::fabs(p.x - x) - half_x - more, std::fabs(p.y) - half_y - more, -depth - p.z}); };
    return std::min(slot(0.0), std::max(slot(groove), dentine(p)));
  }
  bool unsupported(Vec3 p) const {
    const Vec3 out = p - kMiddleMm;
    const double radius = glm::length(out);
    for (double mm = kBallMm - kCarrierMm; mm < radius; mm += 0.02)
      if (removed(kMiddleMm + mm / radius * out)) return true;
    return false;
  }
  double unsupported_mm3() const {
    constexpr double kStep = 0.04;
    double sum = 0;
    for (double px = -1.0; px < 3.0; px += kStep)
      for (double py = -1.6; py < 1.6; py += kStep)
        for (double pz = -depth; pz < 0.0; pz += kStep) {
          const Vec3 p = Vec3(px, py, pz) + 0.5 * kStep;
          const bool enamel = own_tooth(p) < 0.0 && dentine(p) >= 0.0;
          if (enamel && !removed(p) && unsupported(p)) sum += kStep * kStep * kStep;
        }
    return sum;
  }
};

TEST(Unsupported, EnamelOverAKnownGrooveIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 43;
  for (const double voxel_mm : known_voxels()) {
    SCOPED_TRACE(testing::Message() << "voxel " << voxel_mm << " mm, seed " << kSeed);
    Draw draw{std::mt19937_64(kSeed)};
    KnownRows rows;
    for (int i = 0; i < (full_run() ? 20 : 8); ++i) {
      const UndercutSlot cut{draw(0.5, 0.9), draw(0.4, 0.6), draw(1.8, 2.2), i % 4 == 0 ? 0.0 : draw(0.05, 0.3), draw(0.7, 1.3)};
      const auto specimen = two_teeth(voxel_mm, draw, UndercutSlot::tissue);
      const std::map<std::string, double> truth = {{"unsupported_enamel", cut.unsupported_mm3()}};
      Scenario s = exercise();
      s.rubric = rubric_of(truth);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return cut.distance(p); });
      count_case(Reference(s, specimen), volume, truth, rows);
    }
    expect_known(voxel_mm, rows);
  }
}

/// A ball of soft caries in the dentine, firm for its outer 0.3 mm, under the middle of the tooth's top.
struct Lesion {
  Vec3 at{1.0, 0.0, -1.2};
  double radius = 0.9;
  Tissue operator()(Vec3 p) const {
    const Tissue sound = tissue_at(p);
    const double d = ball_distance(p, at, radius);
    if (d >= 0.0 || sound == kNeighbourEnamel) return sound;
    if (sound == Tissue::enamel) return Tissue::carious_enamel;
    return d > -0.3 ? kFirmCariousDentine : Tissue::carious_dentine;
  }
};

std::map<std::string, double> caries_truth(const Lesion& lesion, double cut_z) {
  std::map<std::string, double> out = {{"caries_left_periphery", 0}, {"caries_left_pulp", 0}, {"caries_left_pulp_firm", 0}};
  const double step = 0.025;
  for (double x = -lesion.radius; x < lesion.radius; x += step)
    for (double y = -lesion.radius; y < lesion.radius; y += step)
      for (double z = -lesion.radius; z < lesion.radius; z += step) {
        const Vec3 p = lesion.at + Vec3(x, y, z);
        const Tissue t = lesion(p);
        if (p.z > cut_z || (t != Tissue::carious_dentine && t != kFirmCariousDentine)) continue;
        const bool periphery = ball_distance(p, Vec3(0, 0, kMiddle), kDentineRadius) > -kPeripheryMm;
        out[periphery ? "caries_left_periphery" : t == kFirmCariousDentine ? "caries_left_pulp_firm" : "caries_left_pulp"] += step * step * step;
      }
  return out;
}

TEST(Caries, LeftOfAKnownLesionIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 42;
  for (const double voxel_mm : known_voxels()) {
    SCOPED_TRACE(testing::Message() << "voxel " << voxel_mm << " mm, seed " << kSeed);
    Draw draw{std::mt19937_64(kSeed)};
    KnownRows rows;
    for (int i = 0; i < (full_run() ? 20 : 8); ++i) {
      const Lesion lesion{Vec3(draw(1.9, 2.4), draw(-0.5, 0.5), draw(-1.6, -1.2)), draw(0.8, 1.0)};
      const auto specimen = two_teeth(voxel_mm, draw, lesion);
      Scenario s = exercise();
      const double cut_z = draw(-2.0, -1.2);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return box_distance(p, Vec3(2, 0, cut_z + 2), Vec3(1.5, 1.5, 2)); });
      const auto truth = caries_truth(lesion, cut_z);
      s.rubric = rubric_of(truth);
      count_case(Reference(s, specimen), volume, truth, rows);
    }
    expect_known(voxel_mm, rows);
  }
}

TEST(Caries, SoundTissueWithinThePermittedAccessIsNotLost) {
  Draw draw{std::mt19937_64(1)};
  const Lesion lesion;
  const auto specimen = two_teeth(0.1, draw, lesion);
  Scenario s = exercise();
  s.target = box_region({1, 0, -0.5}, {2.4, 2.4, 3});  // down to z = -2
  s.leeway = {0.2, 0.2};
  const auto lost = [&](double down_to) {
    Volume volume(specimen);
    carved::carve(volume, [&](Vec3 p) { return box_distance(p, Vec3(1, 0, 0.5 * (1 + down_to)), Vec3(1.2, 1.2, 0.5 * (1 - down_to))); });
    return get(measure(Reference(s, specimen), volume, {}), "sound_lost").value;
  };
  EXPECT_NEAR(lost(-2.0), 0.0, 0.01);
  // 0.5 mm below the zone, 2.4 x 2.4 mm, less what of the lesion's ball reaches there: none below z = -2.1.
  EXPECT_NEAR(lost(-2.7), 0.5 * 5.76, 0.1);
}

TEST(Caries, WithoutALesionIsNotMeasured) {
  Draw draw{std::mt19937_64(1)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  const auto measures = measure(Reference(exercise(), specimen), Volume(specimen), {});
  for (const char* metric : {"caries_left_periphery", "caries_left_pulp", "caries_left_pulp_firm", "caries_left_enamel"}) EXPECT_FALSE(get(measures, metric).measured) << metric;
}

}  // namespace
}  // namespace cusp::test
