// Single faults of a class I preparation, carved by analysis, against a rubric of the offered bands: each lowers its own
// criterion, the more the larger it is. The preparation that meets the target has full points.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "scenarios/grading/default_bands.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

constexpr double kDepth = 1.8, kLength = 2.8, kWidth = 1.0;

Scenario class_one_on_36() {
  Scenario s = box_exercise_on_36({kLength, kWidth, kDepth}, {Tissue::enamel, 3, 0.5});
  s.rubric.criteria = {{"target_removed", 10, {80, 90, 97, 100, 100, 100}}, {"depth_mean", 10, {1.2, 1.5, 1.65, 1.95, 2.1, 2.6}}};
  for (const char* metric : {"wall_angle_mesial", "wall_angle_distal", "wall_angle_buccal", "wall_angle_lingual",
                             "convergence_mesiodistal", "convergence_buccolingual", "floor_flatness", "floor_tilt",
                             "isthmus_width", "ridge_mesial", "ridge_distal"})
    s.rubric.criteria.push_back({metric, 10, default_bands(metric, 36).value()});
  return s;
}

using Shape = std::function<double(Vec3)>;

double points_of(const Grade& grade, std::string_view metric) {
  for (const CriterionGrade& c : grade.criteria)
    if (c.id == metric) return c.measure.measured ? c.points : -1.0;
  return -1.0;
}

const Measure& measure_of(const Grade& grade, std::string_view metric) {
  return std::ranges::find(grade.criteria, metric, &CriterionGrade::id)->measure;
}

/// The exercise and its block, made once for all faults.
struct Exercise {
  Scenario scenario = class_one_on_36();
  std::shared_ptr<const Specimen> specimen = block();
  Reference reference{scenario, specimen};
  Grade ideal = grade_of([shape = TargetShape(class_one_on_36().target)](Vec3 p) { return shape.distance_mm(p); });

  Grade grade_of(const Shape& shape) const {
    Volume volume(specimen);
    carved::carve(volume, shape);
    return grade(scenario, measure(reference, volume, {}));
  }
  static std::shared_ptr<const Specimen> block() {
    Grid grid;
    grid.size = IVec3(82, 58, 48);
    grid.origin_mm = Vec3(-4.02, -2.83, -4.17);
    return carved::specimen(
        grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -1.9), Vec3(3.5, 2.3, 1.9)); },
        [](Vec3) { return Tissue::enamel; });
  }
};

class Faults : public testing::Test {
 protected:
  static const Exercise& exercise() {
    static const Exercise once;
    return once;
  }
  static Grade grade_of(const Shape& shape) { return exercise().grade_of(shape); }
  /// Three sizes of one fault: its own criterion has fewer points each time.
  static void lowers(std::string_view metric, const std::array<Shape, 3>& shapes) {
    EXPECT_NEAR(exercise().ideal.score, 100.0, 1e-9);
    double last = points_of(exercise().ideal, metric);
    for (const Shape& shape : shapes) {
      const double points = points_of(grade_of(shape), metric);
      EXPECT_GE(points, 0.0) << metric << " was not measured";
      EXPECT_LT(points, last) << metric;
      last = points;
    }
  }
  static Shape of(const std::function<void(Outline&)>& change) {
    Outline t = class_one_on_36().target.outline;
    change(t);
    return [shape = OutlineShape(t)](Vec3 p) { return shape.distance_mm(p); };
  }
};

TEST_F(Faults, ATooDeepFloorLowersTheDepth) {
  const auto deeper = [](double mm) { return of([mm](Outline& t) { t.depth_mm += mm; }); };
  lowers("depth_mean", {deeper(0.25), deeper(0.45), deeper(0.7)});
}

TEST_F(Faults, ACutRightThroughIsAsDeepAsTheSpecimen) {
  constexpr double kThick = 3.8;
  const Shape through = of([](Outline& t) { t.depth_mm = 9.0; });
  const Grade whole = grade_of(through);
  ASSERT_TRUE(measure_of(whole, "depth_mean").measured) << "else its points would go to what is left of the rubric";
  EXPECT_NEAR(measure_of(whole, "depth_mean").value, kThick, measure_of(whole, "depth_mean").uncertainty);
  EXPECT_EQ(points_of(whole, "depth_mean"), 0.0);
  // Its distal half alone: as many columns have the one depth as the other.
  const Shape exact = of([](Outline&) {});
  const Grade half = grade_of([&](Vec3 p) { return std::min(exact(p), std::max(through(p), -p.x)); });
  EXPECT_NEAR(measure_of(half, "depth_mean").value, 0.5 * (kDepth + kThick), 0.06);
}

TEST(FloorDepth, OfAFilledSpecimenThatIsCutThroughIsItsThickness) {
  Grid grid;
  grid.size = IVec3(82, 58, 48);
  grid.origin_mm = Vec3(-4.02, -2.83, -4.17);
  const auto specimen = carved::specimen(
      grid, Reading::filled, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -1.9), Vec3(3.5, 2.3, 1.9)); }, [](Vec3) { return Tissue::enamel; });
  Volume volume(specimen);
  carved::carve(volume, [](Vec3 p) { return std::max(std::fabs(p.x) - 2.0, std::fabs(p.y) - 1.0); });
  const Reference reference(class_one_on_36(), specimen);
  const auto depth = floor_depth(reference, volume);
  ASSERT_TRUE(depth);
  EXPECT_NEAR(depth->least_mm, 3.8, reference.point_sigma_mm());
  EXPECT_EQ(depth->least_mm, depth->most_mm);
}

TEST_F(Faults, ATooShallowFloorLowersTheDepthAndTheTarget) {
  const auto shallower = [](double mm) { return of([mm](Outline& t) { t.depth_mm -= mm; }); };
  lowers("depth_mean", {shallower(0.25), shallower(0.35), shallower(0.5)});
  lowers("target_removed", {shallower(0.25), shallower(0.3), shallower(0.34)});
}

TEST_F(Faults, ATooWideCavityLowersTheIsthmus) {
  const auto wider = [](double mm) { return of([mm](Outline& t) { t.box_size_mm.y += mm; }); };
  lowers("isthmus_width", {wider(0.35), wider(0.6), wider(0.9)});
}

TEST_F(Faults, ATiltedBuccalWallLowersItsAngle) {
  const auto tilted = [](double deg) -> Shape {
    const Shape wide = of([](Outline& t) {
      t.box_size_mm.y += 2.0;
      t.paths[0][0].y += 1.0;
    });
    const double rise = std::sin(deg * std::numbers::pi / 180), run = std::cos(deg * std::numbers::pi / 180);
    return [=](Vec3 p) { return std::max(wide(p), (p.y - 0.5 * kWidth) * run - (p.z + kDepth) * rise); };
  };
  lowers("wall_angle_buccal", {tilted(4), tilted(5.5), tilted(7)});
}

TEST_F(Faults, ARoughFloorLowersItsFlatness) {
  const auto rough = [](double mm) -> Shape {
    const Shape whole = of([](Outline& t) { t.depth_mm += 0.6; });
    // A wave of 1.8 mm: at 0.27 mm it leans 43 degrees, so that all of it is floor.
    return [=](Vec3 p) {
      return std::max(whole(p), (-kDepth + mm * std::cos(2 * std::numbers::pi * p.x / 1.8) - p.z) / 1.38);
    };
  };
  lowers("floor_flatness", {rough(0.19), rough(0.23), rough(0.27)});
}

TEST_F(Faults, AThinMesialRidgeLowersItsThickness) {
  const auto longer = [](double mm) {
    return of([mm](Outline& t) {
      t.box_size_mm.x += mm;
      t.paths[0][0].x += 0.5 * mm;
    });
  };
  lowers("ridge_mesial", {longer(0.25), longer(0.45), longer(0.7)});
}

TEST_F(Faults, AScratchOnARidgeIsNoWallOfTheCavity) {
  const Shape cavity = of([](Outline&) {});
  const Grade scratched = grade_of([&](Vec3 p) {
    const double mesial = box_distance(p, Vec3(1.85, 0, 0), Vec3(0.15, 0.3, 0.1)), distal = box_distance(p, Vec3(-1.85, 0, 0), Vec3(0.15, 0.3, 0.1));
    return std::min({cavity(p), mesial, distal});
  });
  for (const char* metric : {"ridge_mesial", "ridge_distal"}) {
    const auto& before = measure_of(exercise().ideal, metric);
    EXPECT_NEAR(measure_of(scratched, metric).value, before.value, before.uncertainty) << metric;
  }
}

TEST_F(Faults, ARidgeThatIsCutThroughIsGone) {
  const Shape cavity = of([](Outline&) {});
  for (const double half_width : {0.2, 0.5 * kWidth}) {
    const Grade through = grade_of([&](Vec3 p) { return std::min(cavity(p), box_distance(p, Vec3(2.5, 0, 0), Vec3(1.5, half_width, kDepth))); });
    EXPECT_TRUE(measure_of(through, "ridge_mesial").measured) << half_width;
    EXPECT_EQ(measure_of(through, "ridge_mesial").value, 0.0) << half_width;
    EXPECT_EQ(points_of(through, "ridge_mesial"), 0.0) << half_width;
  }
}

TEST_F(Faults, ARidgeIsMeasuredHoweverFarTheCutRunsIntoIt) {
  const Grade far = grade_of(of([](Outline& t) {
    t.box_size_mm.x += 1.3;
    t.paths[0][0].x += 0.65;
  }));
  ASSERT_TRUE(measure_of(far, "ridge_mesial").measured);
  EXPECT_NEAR(measure_of(far, "ridge_mesial").value, 0.8, 0.03);  // 3.5 - 1.4 - 1.3
}

TEST_F(Faults, AScratchBesideTheCavityIsNoIsthmus) {
  const Shape cavity = of([](Outline&) {});
  const Grade scratched = grade_of([&](Vec3 p) { return std::min(cavity(p), box_distance(p, Vec3(0, 1.1, 0), Vec3(0.6, 0.15, 0.15))); });
  const auto& before = measure_of(exercise().ideal, "isthmus_width");
  EXPECT_NEAR(measure_of(scratched, "isthmus_width").value, before.value, before.uncertainty);
}

TEST_F(Faults, AnIsthmusFarTooWideIsStillMeasured) {
  const Grade wide = grade_of(of([](Outline& t) { t.box_size_mm.y += 2.6; }));  // 1.3 mm on either side
  ASSERT_TRUE(measure_of(wide, "isthmus_width").measured);
  EXPECT_NEAR(measure_of(wide, "isthmus_width").value, kWidth + 2.6, 0.03);
  EXPECT_EQ(points_of(wide, "isthmus_width"), 0.0);
}

TEST_F(Faults, AnUntouchedToothHasNoPoints) {
  EXPECT_EQ(grade_of([](Vec3) { return 1.0; }).score, 0.0);
}

TEST_F(Faults, AShaftOfATwentiethOfTheTargetEarnsAtMostFivePoints) {
  const Shape shaft = of([](Outline& t) {
    t.box_size_mm.x = 0.05 * kLength * kWidth / 0.4;
    t.box_size_mm.y = 0.4;
    t.corner_radius_mm = 0.1;
  });
  const Grade g = grade_of(shaft);
  EXPECT_FALSE(g.passed);
  EXPECT_LE(g.score, 5.0);  // measured: 2.3; 9.5 by evaluator 3, which counted the depth whole
}

}  // namespace
}  // namespace cusp::test
