// Preparations carved by analysis against the measurements of their form: each value within its stated uncertainty in at
// least 93 % of the cases. Six cases a kind at voxels of 0.1 mm; with CUSP_FULL=1 sixty a kind at 0.05, 0.078 and
// 0.1 mm, and the table of scenarios/metrics/README.md on stdout.

#include "scenarios/metrics/form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "scenarios/metrics/angle.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/engine/volume/carved.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
/// The block that stands for a tooth: top at z = 0, proximal faces at x = -3.5 and 3.5.
constexpr Vec3 kBlockCentre(0, 0, -1.7), kBlockHalf(3.5, 2.5, 1.7);
constexpr double kCorner = 0.3;

double block_of_tooth(Vec3 p) { return box_distance(p, kBlockCentre, kBlockHalf); }
Tissue dentine_alone(Vec3) { return Tissue::dentine; }

enum class Kind : std::uint8_t { tapered, rounded, slot };

/// A preparation with walls at angles of its own and a tilted floor, turned about the axis.
struct Preparation {
  Kind kind = Kind::tapered;
  double half_x = 1.2, half_y = 0.9, depth = 1.8, turn_deg = 0;
  std::array<double, 4> wall_deg{};  // mesial, distal, buccal, lingual
  double tilt_x = 0, tilt_y = 0;     // slopes of the floor

  double distance(Vec3 p) const {
    const double c = std::cos(turn_deg * kRadians), s = std::sin(turn_deg * kRadians);
    const Vec2 q(c * p.x + s * p.y, c * p.y - s * p.x);
    const double length = std::sqrt(1.0 + tilt_x * tilt_x + tilt_y * tilt_y);
    const double below_floor = (-depth + tilt_x * q.x + tilt_y * q.y - p.z) / length;
    if (kind == Kind::slot) {
      const double u = segment_distance(q, {half_y - half_x, 0.0}, {half_x - half_y, 0.0}) - half_y;
      return rounded_corner(u, below_floor, kCorner);
    }
    // Through the floor's edge, opening upwards by the wall's angle.
    const auto wall = [&](double out, double half, double deg) {
      return (out - half) * std::cos(deg * kRadians) - (p.z + depth) * std::sin(deg * kRadians);
    };
    const double along = std::max(wall(q.x, half_x, wall_deg[0]), wall(-q.x, half_x, wall_deg[1]));
    const double across = std::max(wall(q.y, half_y, wall_deg[2]), wall(-q.y, half_y, wall_deg[3]));
    const double u = rounded_corner(along, across, 0.5);  // the vertical corners that a bur of 1 mm leaves
    return kind == Kind::rounded ? rounded_corner(u, below_floor, kCorner) : std::max(u, below_floor);
  }
  /// The wall's place at a height, in a direction from the axis.
  Vec3 wall_at(double z, double deg) const {
    const Vec3 way(std::cos(deg * kRadians), std::sin(deg * kRadians), 0.0);
    double in = 0, out = 3.4;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (in + out);
      (distance(Vec3(0, 0, z) + middle * way) < 0.0 ? in : out) = middle;
    }
    return Vec3(0, 0, z) + in * way;
  }
  double furthest_x(double z, double direction) const {
    double best = 0;
    for (double deg = 0.0; deg < 360.0; deg += 0.25) best = std::max(best, direction * wall_at(z, deg).x);
    return best;
  }
  /// The definition of wall_angle_<side> by integration over the wall from `low` to the top: mesial, distal, buccal,
  /// lingual. A wall takes half of the rounded vertical corners beside it.
  std::array<double, 4> wall_truth(double low) const {
    constexpr int kLevels = 12;
    constexpr double kStepDeg = 0.5;
    std::array<double, 4> rise{}, run{};
    std::array<Vec3, kLevels + 1> last{}, next{};
    for (double deg = -kStepDeg; deg < 360.0; deg += kStepDeg) {
      for (int k = 0; k <= kLevels; ++k) next[static_cast<std::size_t>(k)] = wall_at(low - low * k / kLevels, deg);
      for (std::size_t k = 0; deg >= 0.0 && k < kLevels; ++k) {
        const Vec3 n = 0.5 * glm::cross(last[k + 1] - next[k], next[k + 1] - last[k]);  // into the void
        const std::size_t side = std::fabs(n.x) >= std::fabs(n.y) ? (n.x < 0.0 ? 0u : 1u) : (n.y < 0.0 ? 2u : 3u);
        rise[side] += n.z;
        run[side] += std::hypot(n.x, n.y);
      }
      last = next;
    }
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = std::atan2(rise[i], run[i]) / kRadians;
    return out;
  }
};

Preparation random_preparation(Kind kind, std::mt19937_64& random) {
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Preparation p;
  p.kind = kind;
  p.half_x = between(1.3, 1.6);
  p.half_y = between(0.9, 1.1);
  p.depth = between(1.5, 2.2);
  p.turn_deg = between(-20, 20);
  if (kind != Kind::slot)
    for (double& deg : p.wall_deg) deg = between(-8, 10);
  const double tilt = std::tan(between(0, 5) * kRadians), way = between(0, 360) * kRadians;
  p.tilt_x = tilt * std::cos(way);
  p.tilt_y = tilt * std::sin(way);
  return p;
}

Scenario exercise_on_36() { return box_exercise_on_36({2.2, 1.6, 1.8}, {Tissue::dentine, 2, 1.6}); }

/// What each measurement has to come to. `low`: where the walls begin.
std::map<std::string, double> truth_of(const Preparation& p, double low) {
  std::map<std::string, double> out;
  const std::array<double, 4> w = p.wall_truth(low);
  out["wall_angle_mesial"] = w[0];
  out["wall_angle_distal"] = w[1];
  out["wall_angle_buccal"] = w[2];
  out["wall_angle_lingual"] = w[3];
  out["convergence_mesiodistal"] = -(w[0] + w[1]);
  out["convergence_buccolingual"] = -(w[2] + w[3]);
  out["floor_flatness"] = 0.0;
  out["floor_tilt"] = std::atan(std::hypot(p.tilt_x, p.tilt_y)) / kRadians;
  const auto width = [&](double z, double half, double a, double b) {
    return 2.0 * half + (z + p.depth) * (std::tan(a * kRadians) + std::tan(b * kRadians));
  };
  const auto& own = p.wall_deg;
  out["isthmus_width"] = width(0.0, p.half_y, own[2], own[3]);
  out["ridge_mesial"] = kBlockHalf.x - std::max(p.furthest_x(low, 1.0), p.furthest_x(0.0, 1.0));
  out["ridge_distal"] = kBlockHalf.x - std::max(p.furthest_x(low, -1.0), p.furthest_x(0.0, -1.0));
  return out;
}

struct Row {
  int cases = 0, within = 0, unmeasured = 0;
  double worst = 0, uncertainty = 0;
  std::string unit;
};

void measure_one(const Preparation& p, double voxel_mm, Vec3 phase, std::map<std::string, Row>& rows) {
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
  for (const Measure& m : measures) {
    Row& row = rows[m.metric];
    row.unit = m.unit;
    ++row.cases;
    if (!m.measured) {
      ++row.unmeasured;
      continue;
    }
    const double error = std::fabs(m.value - truth.at(m.metric));
    row.within += error <= m.uncertainty;
    row.worst = std::max(row.worst, error);
    row.uncertainty = std::max(row.uncertainty, m.uncertainty);
  }
}

void print_rows(double voxel_mm, const std::map<std::string, Row>& rows) {
  for (const auto& [metric, row] : rows)
    std::printf("| %.3f | %s | %d | %.1f %% | %.4f %s | %.4f %s |\n", voxel_mm, metric.c_str(), row.cases,
                100.0 * row.within / row.cases, row.worst, row.unit.c_str(), row.uncertainty, row.unit.c_str());
}

TEST(Form, IsWithinItsUncertaintyOnKnownPreparations) {
  const bool full = full_run();
  const int cases = full ? 60 : 6;
  constexpr std::uint64_t kSeed = 22;
  for (const double voxel_mm : full ? std::vector<double>{0.05, 0.078, 0.1} : std::vector<double>{0.1}) {
    SCOPED_TRACE(testing::Message() << "voxel " << voxel_mm << " mm, seed " << kSeed);
    std::map<std::string, Row> rows;
    std::mt19937_64 random(kSeed);
    for (const Kind kind : {Kind::tapered, Kind::rounded, Kind::slot})
      for (int i = 0; i < cases; ++i) {
        const Preparation p = random_preparation(kind, random);
        std::uniform_real_distribution<double> phase(0, 1);
        const double x = phase(random), y = phase(random), z = phase(random);
        measure_one(p, voxel_mm, {x, y, z}, rows);
      }
    print_rows(voxel_mm, rows);
    int all = 0, within = 0;
    for (const auto& [metric, row] : rows) {
      all += row.cases;
      within += row.within;
      EXPECT_GE(row.within, 0.85 * row.cases) << metric;
      EXPECT_EQ(row.unmeasured, 0) << metric;
      // Issue 22, "Must show" 1: at 0.078 mm at most 0.02 mm and 1 degree.
      if (voxel_mm == 0.078) {
        EXPECT_LE(row.uncertainty, row.unit == "deg" ? 1.0 : 0.02) << metric;
      }
    }
    EXPECT_GE(within, 0.93 * all) << within << " of " << all;
  }
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
  p.wall_deg = {6, 1, 0, 0};
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

TEST(Angle, IsTheArcTangent) {
  // The largest difference seen is 3e-14 degrees.
  for (double deg = -90.0; deg <= 90.0; deg += 0.37)
    EXPECT_NEAR(slope_deg(std::sin(deg * kRadians), std::max(0.0, std::cos(deg * kRadians))), deg, 1e-12);
}

}  // namespace
}  // namespace cusp::test
