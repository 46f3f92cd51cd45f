// Preparations carved by analysis against the measurements of their form: each value within its stated uncertainty in at
// least 93 % of the cases. Six cases a kind at voxels of 0.1 mm; with CUSP_FULL=1 sixty a kind at 0.05, 0.078 and
// 0.1 mm, and the rows of scenarios/metrics/errors.md on stdout.

#include "scenarios/metrics/form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/angle.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/metrics/preparation.h"

namespace cusp::test {
namespace {

/// The block that stands for a tooth: top at z = 0, proximal faces at x = -3.5 and 3.5.
constexpr Vec3 kBlockCentre(0, 0, -1.7), kBlockHalf(3.5, 2.5, 1.7);

double block_of_tooth(Vec3 p) { return box_distance(p, kBlockCentre, kBlockHalf); }
Tissue dentine_alone(Vec3) { return Tissue::dentine; }

Scenario exercise_on_36() { return box_exercise_on_36({2.2, 1.6, 1.8}, {Tissue::dentine, 2, 1.6}); }

/// What each measurement has to come to. `low`: where the walls begin.
std::map<std::string, double> truth_of(const Preparation& p, double low) {
  std::map<std::string, double> out;
  WallAngles walls;
  for_wall(p, low, 0.0, 12, 0.5, [&](double, Vec3, Vec3 area) { walls.add(area); });
  add_walls(walls, 1, out);
  out["floor_flatness"] = 0.0;
  out["floor_tilt"] = std::atan(std::hypot(p.tilt_x, p.tilt_y)) / kRadians;
  out["isthmus_width"] = 2.0 * p.half_y + p.depth * (p.lean[2].y / p.lean[2].x + p.lean[3].y / p.lean[3].x);
  out["ridge_mesial"] = kBlockHalf.x - p.furthest_x(1.0);
  out["ridge_distal"] = kBlockHalf.x - p.furthest_x(-1.0);
  return out;
}

void measure_one(const Preparation& p, double voxel_mm, Vec3 phase, KnownRows& rows) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  grid.size = IVec3(glm::ceil(2.0 * kBlockHalf / voxel_mm)) + 10;
  grid.origin_mm = kBlockCentre - kBlockHalf + voxel_mm * (phase - 5.0);
  const Scenario scenario = exercise_on_36();
  const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth, dentine_alone);
  const Reference reference(scenario, specimen);
  Volume volume(specimen);
  carved::carve(volume, [&](Vec3 at) { return p.distance(at); });
  const auto depth = floor_depth(reference, volume);
  ASSERT_TRUE(depth);
  std::vector<Measure> measures;
  add_form(CutFaces(reference, volume, depth), margin_points(volume), reference, volume, measures);
  const auto truth = truth_of(p, -depth->mean_mm + kCorner + 0.5 * voxel_mm);
  EXPECT_EQ(measures.size(), truth.size());
  count_case(measures, truth, rows);
}

TEST(Form, IsWithinItsUncertaintyOnKnownPreparations) {
  constexpr std::uint64_t kSeed = 22;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (const Kind kind : {Kind::tapered, Kind::rounded, Kind::slot})
      for (int i = 0; i < (full_run() ? 60 : 6); ++i) {
        const Preparation p = random_preparation(kind, draw);
        const double x = draw(0, 1), y = draw(0, 1), z = draw(0, 1);
        measure_one(p, voxel_mm, {x, y, z}, table.rows(voxel_mm));
      }
  }
  table.expect(kSeed);
}

TEST(Form, OfABlockHasNoSides) {
  Scenario scenario = exercise_on_36();
  scenario.specimen.generator = "block";
  Grid grid;
  grid.size = IVec3(80, 60, 44);
  grid.origin_mm = kBlockCentre - kBlockHalf - 0.5;
  const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth, dentine_alone);
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 at) { return Preparation{}.distance(at); });
  std::vector<Measure> measures;
  const Reference reference(scenario, specimen);
  add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
  for (const Measure& m : measures) {
    const bool of_no_side = m.metric.starts_with("floor_") || m.metric == "isthmus_width";
    EXPECT_EQ(m.measured, of_no_side) << m.metric;
  }
}

TEST(Form, OfAnUntouchedOrFilledSpecimenIsNotMeasured) {
  Grid grid;
  grid.size = IVec3(80, 60, 44);
  grid.origin_mm = kBlockCentre - kBlockHalf - 0.5;
  for (const Reading reading : {Reading::banded, Reading::filled}) {
    const auto specimen = carved::specimen(grid, reading, block_of_tooth, dentine_alone);
    Volume volume(specimen);
    if (reading == Reading::filled) carved::carve(volume, [](Vec3 at) { return Preparation{}.distance(at); });
    std::vector<Measure> measures;
    const Reference reference(exercise_on_36(), specimen);
    add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
    ASSERT_EQ(measures.size(), 11u);
    for (const Measure& m : measures) EXPECT_FALSE(m.measured) << m.metric;
  }
}

TEST(Form, OfAMirroredToothNamesTheOtherSide) {
  Scenario scenario = exercise_on_36();
  Grid grid;
  grid.size = IVec3(80, 60, 44);
  grid.origin_mm = kBlockCentre - kBlockHalf - 0.5;
  const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth, dentine_alone);
  Volume volume(specimen);
  Preparation p;
  p.kind = Kind::rounded;
  p.lean[0] = direction(6);
  p.lean[1] = direction(1);
  carved::carve(volume, [&](Vec3 at) { return p.distance(at); });
  for (const auto& [fdi, mesial] : {std::pair{36, 6.0}, {46, 1.0}}) {
    scenario.specimen.fdi = fdi;
    std::vector<Measure> measures;
    const Reference reference(scenario, specimen);
    add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
    EXPECT_EQ(measures[0].metric, "wall_angle_mesial");
    EXPECT_NEAR(measures[0].value, mesial, measures[0].uncertainty) << fdi;
  }
}

TEST(Form, ARidgeBesideAWallThatConvergesIsMeasuredAtItsFoot) {
  constexpr double kToWallMm = 1.2, kConvergesDeg = 8.0;
  // Of a rounded line angle (u + r)² + (v + r)² = r², u out of the wall and v below the floor: the place furthest along x.
  const double rise = std::sin(kConvergesDeg * kRadians), run = std::cos(kConvergesDeg * kRadians);
  const double fillet_mm = kCorner * (std::sqrt(1.0 + rise * rise) - 1.0 - rise) / run;
  for (const auto& [kind, outermost] : {std::pair{Kind::tapered, kToWallMm}, {Kind::rounded, kToWallMm + fillet_mm}})
    for (const double voxel_mm : {0.05, 0.1, 0.2})
      for (const double phase : {0.0, 0.5}) {
        SCOPED_TRACE(testing::Message() << voxel_mm << " mm, phase " << phase << (kind == Kind::rounded ? ", rounded" : ", sharp"));
        Grid grid;
        grid.voxel_mm = voxel_mm;
        grid.size = IVec3(glm::ceil(2.0 * kBlockHalf / voxel_mm)) + 10;
        grid.origin_mm = kBlockCentre - kBlockHalf + voxel_mm * (Vec3(phase) - 5.0);
        const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth, dentine_alone);
        Preparation p{.kind = kind, .half_x = kToWallMm};
        p.lean[0] = p.lean[1] = direction(-kConvergesDeg);
        Volume volume(specimen);
        carved::carve(volume, [&](Vec3 at) { return p.distance(at); });
        std::vector<Measure> measures;
        const Reference reference(exercise_on_36(), specimen);
        add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
        for (const char* metric : {"ridge_mesial", "ridge_distal"}) {
          const Measure& ridge = *std::ranges::find(measures, metric, &Measure::metric);
          ASSERT_TRUE(ridge.measured) << metric;
          EXPECT_NEAR(ridge.value, kBlockHalf.x - outermost, ridge.uncertainty) << metric;  // measured 0.12 voxel of 0.14 at most
        }
      }
}

TEST(Form, ARidgeIsOfTheToothsOwnTissuesWhateverTheirCodes) {
  Grid grid;
  grid.size = IVec3(80, 60, 44);
  grid.origin_mm = kBlockCentre - kBlockHalf - 0.5;
  const auto ridge = [&](Tissue beyond_3_mm) {
    const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth,
                                           [&](Vec3 p) { return p.x > 3.0 ? beyond_3_mm : Tissue::dentine; });
    Volume volume(specimen);
    carved::carve(volume, [](Vec3 at) { return Preparation{.half_x = 1.2}.distance(at); });
    std::vector<Measure> measures;
    const Reference reference(exercise_on_36(), specimen);
    add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
    return *std::ranges::find(measures, "ridge_mesial", &Measure::metric);
  };
  for (const Tissue own : {Tissue::enamel, Tissue{16}, kFirmCariousDentine})
    EXPECT_NEAR(ridge(own).value, 2.3, ridge(own).uncertainty) << index_of(own);
  // Half a voxel: where a neighbour touches, the border is known to a voxel.
  for (const Tissue neighbours : {kNeighbourEnamel, kNeighbourDentine}) EXPECT_NEAR(ridge(neighbours).value, 1.8, 0.06);
}

TEST(Form, NoRidgeIsMeasuredWhereToothAndNeighboursAreOfOnePlastic) {
  Grid grid;
  grid.size = IVec3(80, 60, 44);
  grid.origin_mm = kBlockCentre - kBlockHalf - 0.5;
  const auto specimen = carved::specimen(grid, Reading::banded, block_of_tooth, [](Vec3) { return Tissue::plastic; });
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 at) { return Preparation{.half_x = 1.2}.distance(at); });
  Scenario s = exercise_on_36();
  s.specimen.typodont = true;
  for (const auto& [around, measured] : {std::pair{"gingiva", true}, {"neighbours", false}, {"jaw", false}}) {
    s.specimen.around = {around};
    std::vector<Measure> measures;
    const Reference reference(s, specimen);
    add_form(CutFaces(reference, volume, floor_depth(reference, volume)), margin_points(volume), reference, volume, measures);
    for (const char* metric : {"ridge_mesial", "ridge_distal"})
      EXPECT_EQ(std::ranges::find(measures, metric, &Measure::metric)->measured, measured) << metric << ", " << around;
  }
}

TEST(Angle, IsTheArcTangent) {
  // The largest difference seen is 3e-14 degrees.
  for (double deg = -90.0; deg <= 90.0; deg += 0.37)
    EXPECT_NEAR(slope_deg(std::sin(deg * kRadians), std::max(0.0, std::cos(deg * kRadians))), deg, 1e-12);
}

}  // namespace
}  // namespace cusp::test
