// Targets that are trees, and what an attempt is to spare: cuts of exactly known shape in a block of enamel over dentine.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "engine/removal/carve.h"
#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/keys.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/measure.h"
#include "tests/engine/volume/carved.h"
#include "tests/full_run.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/block_cuts.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

TEST(TreeTarget, ThatIsCutExactlyIsRemovedWholeAndNothingElse) {
  const Region target = class_two(4);
  const auto measures = measured(exercise(target), exactly(target));
  EXPECT_GT(get(measures, "target_removed").value, 99.5);  // measured: 99.9
  for (const char* over : {"overcut_leeway_floor", "overcut_leeway_side", "overcut_beyond_floor", "overcut_beyond_side"})
    EXPECT_LT(get(measures, over).value, 0.05) << over;
}

TEST(TreeTarget, ItsVolumeIsThatOfTheSolid) {
  // Slot of 4 x 1.2 mm with round ends of radius 0.6, 2 mm deep, less its fillet; the box from x = 2 takes one of the ends.
  Region slot = region_of(isthmus(1.2, 2));
  slot.outline.corner_radius_mm = 0;
  Region target = class_two(4);
  target.parts[0] = slot;
  const Reference reference(exercise(target), block());
  const double slot_mm3 = 2 * (4 * 1.2 + 0.5 * 3.14159265 * 0.36), box_mm3 = 2 * 2.4 * 4;
  EXPECT_NEAR(reference.target_mm3(), slot_mm3 + box_mm3, 0.005 * box_mm3);
}

TEST(TreeTarget, DepthIsThatOfThePulpalFloorAlone) {
  const Region target = class_two(4);
  const auto measures = measured(exercise(target), exactly(target));
  EXPECT_NEAR(get(measures, "depth_mean").value, 2.0, 0.005);
  EXPECT_NEAR(get(measures, "depth_most").value, 2.0, 0.02) << "the gingival floor at 4 mm is none";
}

Shape with(Shape a, Shape b) {
  return [a = std::move(a), b = std::move(b)](Vec3 p) { return std::min(a(p), b(p)); };
}

TEST(TreeTarget, AFloorThatIsCutRightThroughIsAsDeepAsTheSpecimen) {
  constexpr double kThick = 6.0;
  const Region target = class_two(4);
  const auto through = measured(exercise(target), with(exactly(target), exactly(region_of(isthmus(1.2, 9)))));
  for (const char* metric : {"depth_least", "depth_mean", "depth_most"}) {
    const Measure m = get(through, metric);
    ASSERT_TRUE(m.measured) << metric << ": else its points would go to what is left of the rubric";
    EXPECT_NEAR(m.value, kThick, m.uncertainty) << metric;
  }
  const auto hole = measured(exercise(target), with(exactly(target), exactly(box_region({-1, 0, -5}, {0.5, 0.5, 9}))));
  EXPECT_NEAR(get(hole, "depth_least").value, 2.0, get(hole, "depth_least").uncertainty);
  EXPECT_NEAR(get(hole, "depth_most").value, kThick, get(hole, "depth_most").uncertainty);
}

TEST(TreeTarget, AHoleInThePulpalFloorIsADepthThoughAnotherFloorIsNearer) {
  const Region target = class_two(4);
  // Down to the gingival floor, which lies 1.4 mm beside it and the pulpal floor 2 mm above.
  const auto measures = measured(exercise(target), with(exactly(target), exactly(box_region({0.3, 0, -2}, {0.6, 0.6, 4}))));
  EXPECT_NEAR(get(measures, "depth_most").value, 4.0, get(measures, "depth_most").uncertainty);
}

TEST(TreeTarget, OverCutOfTheAxialWallIsNoDepthOfThePulpalFloor) {
  const Region target = class_two(4);
  const auto measures = measured(exercise(target), with(exactly(target), exactly(box_region({2.8, 0, -1.5}, {2.4, 2.4, 5}))));
  EXPECT_NEAR(get(measures, "depth_most").value, 2.0, 0.02) << "0.4 mm of over-cut";
}

TEST(TreeTarget, ABoxThatIsCutRightThroughLeavesTheDepthOfThePulpalFloor) {
  const auto measures = measured(exercise(class_two(4)), exactly(class_two(9)));
  EXPECT_NEAR(get(measures, "depth_mean").value, 2.0, 0.005);
  EXPECT_NEAR(get(measures, "depth_most").value, 2.0, 0.02);
}

TEST(TreeTarget, ARoundedAxiopulpalLineAngleIsNoFloor) {
  Region target = class_two(4);
  target.rounding_mm = 0.5;
  const auto measures = measured(exercise(target), exactly(target));
  const Measure tilt = get(measures, "floor_tilt");
  ASSERT_TRUE(tilt.measured);
  EXPECT_NEAR(tilt.value, 0.0, tilt.uncertainty);
  EXPECT_NEAR(get(measures, "depth_most").value, 2.0, 0.02);
}

TEST(TreeTarget, WithoutAnOutlineHasNoDepth) {
  const Region target = sphere({0, 0, 0}, 1.5);
  const auto measures = measured(exercise(target), exactly(target));
  EXPECT_FALSE(get(measures, "depth_mean").measured);
  EXPECT_GT(get(measures, "target_removed").value, 99.0);
}

TEST(TreeTarget, AFloorThatIsCutTooDeepIsBeyondTheZoneOfItsOwnFace) {
  Scenario s = exercise(class_two(4));
  s.leeway.floor_mm = s.leeway.side_mm = 0.5;
  const Shape deeper = exactly(class_two(4.3));  // 0.3 mm below the gingival floor: 2 x 2.4 x 0.3 = 1.44 mm3
  const auto wide = measured(s, deeper);
  EXPECT_NEAR(get(wide, "overcut_leeway_floor").value, 1.44, 0.1);
  EXPECT_LT(get(wide, "overcut_beyond_floor").value, 0.05);
  s.leeway.faces = {{FaceName::gingival_floor, 0.1}};
  const auto narrow = measured(s, deeper);
  EXPECT_NEAR(get(narrow, "overcut_leeway_floor").value, 0.48, 0.06) << "a third of it";
  EXPECT_NEAR(get(narrow, "overcut_beyond_floor").value, 0.96, 0.08) << "two thirds";
}

TEST(TreeTarget, TheZoneOfAFaceHoldsForALoneOutlineToo) {
  Scenario s = exercise(region_of(isthmus(1.2, 2)));
  s.leeway.floor_mm = s.leeway.side_mm = 0.5;
  const Shape deeper = exactly(region_of(isthmus(1.2, 2.3)));
  EXPECT_LT(get(measured(s, deeper), "overcut_beyond_floor").value, 0.02);
  s.leeway.faces = {{FaceName::pulpal_floor, 0.1}};
  EXPECT_GT(get(measured(s, deeper), "overcut_beyond_floor").value, 0.5);
}

TEST(TreeTarget, ATaperedWallHasItsAngle) {
  Region target = region_of(isthmus(1.4, 2));
  target.outline.shape = "box";
  target.outline.paths = {{Vec3(0, 0, -2)}};
  target.outline.box_size_mm = {3, 1.4, 0};
  target.outline.taper_deg = {5, 5, -3, 8};  // mesial and distal are alike, -y is lingual
  const auto measures = measured(exercise(target), exactly(target));
  for (const auto& [metric, deg] : {std::pair{"wall_angle_mesial", 5.0}, {"wall_angle_distal", 5.0}, {"wall_angle_lingual", -3.0}, {"wall_angle_buccal", 8.0}}) {
    const Measure m = get(measures, metric);
    ASSERT_TRUE(m.measured) << metric;
    EXPECT_NEAR(m.value, deg, m.uncertainty) << metric;
  }
}

/// A box of named walls that stands turned about the axis; no wall's normal lies nearer to the direction of its name.
Region turned_box(double turn_deg) {
  Region out = box_region({0, 0, -0.5}, {3, 2, 3});
  const double turn = turn_deg * std::numbers::pi / 180;
  out.x_axis = {std::cos(turn), std::sin(turn), 0};
  out.faces = {{"x_low", FaceName::distal_wall}, {"x_high", FaceName::mesial_wall}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
  return out;
}

TEST(TreeTarget, AWallIsOfTheFaceThatNamesItAndNotOfItsNormal) {
  const Region target = turned_box(60);
  Region cut = target;
  cut.z_axis = Vec3(0, std::sin(0.06), std::cos(0.06));
  Scenario s = exercise(target);
  s.specimen.generator = "block";  // the names need no tooth's number
  const auto measures = measured(s, exactly(cut));
  // The box leans by 0.06 rad about x: each wall by its normal's part along y.
  const double turn = 60 * std::numbers::pi / 180;
  const Vec3 z = cut.z_axis, x = glm::normalize(Vec3(std::cos(turn), std::sin(turn), 0) - std::sin(turn) * z.y * z), y = glm::cross(z, x);
  const auto lean = [](Vec3 out) { return -std::asin(out.z) * 180 / std::numbers::pi; };
  for (const auto& [metric, out] : {std::pair{"wall_angle_mesial", x}, {"wall_angle_distal", -x}, {"wall_angle_buccal", y}, {"wall_angle_lingual", -y}}) {
    const Measure m = get(measures, metric);
    ASSERT_TRUE(m.measured) << metric;
    EXPECT_NEAR(m.value, lean(out), m.uncertainty) << metric;
  }
}

TEST(TreeTarget, AFloorThatIsHalfCutIsStillItsFloor) {
  // 0.9 mm short: the walls of the slot, 0.6 mm away at most, are nearer than the floor.
  const Region target = class_two(4);
  const auto measures = measured(exercise(target), exactly(region_of(isthmus(1.2, 1.1))));
  EXPECT_NEAR(get(measures, "depth_mean").value, 1.1, 0.005);
}

TEST(TreeTarget, AGingivalFloorFarTooDeepIsStillMeasured) {
  Scenario s = exercise(class_two(4));
  s.rubric.criteria = {{"box_height", 1, {}}};
  const Measure m = get(measured(s, exactly(class_two(5.2))), "box_height");
  ASSERT_TRUE(m.measured);
  EXPECT_NEAR(m.value, 3.2, m.uncertainty);
}

TEST(TreeTarget, AGingivalFloorThatIsCutThroughLiesWhereTheToothEnded) {
  constexpr double kThick = 6.0;
  Scenario s = exercise(class_two(4));
  s.rubric.criteria = {{"box_height", 1, {}}, {"gingival_above_cej", 1, {}}};
  const auto exact = measured(s, exactly(class_two(4)));
  const auto through = measured(s, exactly(class_two(9)));
  const Measure height = get(through, "box_height"), above = get(through, "gingival_above_cej");
  ASSERT_TRUE(height.measured && above.measured) << "else their points would go to what is left of the rubric";
  EXPECT_NEAR(height.value, kThick - 2.0, height.uncertainty);
  // The junction's height is of the nearest place in plan: 0.3 mm between the places of a floor.
  EXPECT_NEAR(above.value, get(exact, "gingival_above_cej").value - (kThick - 4.0), 0.3);
  // A hole of 0.5 mm in it: the mean height stays, the least does not.
  const auto hole = measured(s, with(exactly(class_two(4)), exactly(box_region({3, 0, -5}, {0.5, 0.5, 9}))));
  EXPECT_NEAR(get(hole, "box_height").value, 2.0, get(hole, "box_height").uncertainty);
  EXPECT_NEAR(get(hole, "gingival_above_cej").value, above.value, 0.3);
}

/// About the z axis.
Vec3 turned(Vec3 p, double deg) {
  const double c = std::cos(deg * std::numbers::pi / 180), s = std::sin(deg * std::numbers::pi / 180);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}
Region turned(Region region, double deg) {
  for (std::vector<Vec3>& path : region.outline.paths)
    for (Vec3& p : path) p = turned(p, deg);
  region.from_mm = turned(region.from_mm, deg);
  region.x_axis = turned(region.x_axis, deg);
  for (Region& part : region.parts) part = turned(part, deg);
  return region;
}
/// The block turned with a target in it, and its voxels shifted by parts of one.
std::shared_ptr<const Specimen> turned_block(double deg, Vec3 shift_voxels) {
  Grid grid;
  grid.size = IVec3(110, 110, 68);
  grid.origin_mm = Vec3(-5.47, -5.44, -6.33) + 0.1 * shift_voxels;
  return carved::specimen(
      grid, Reading::banded, [=](Vec3 p) { return box_distance(turned(p, -deg), Vec3(0, 0, -3), Vec3(4.5, 3, 3)); },
      [](Vec3 p) { return p.z > -3 ? Tissue::enamel : Tissue::dentine; });
}

/// What does not depend on where mesial is.
constexpr std::array kWhicheverWay = {
    "target_removed", "uncut_remainder", "overcut_leeway_floor", "overcut_leeway_side", "overcut_beyond_floor", "overcut_beyond_side",
    "depth_least", "depth_mean", "depth_most", "removed_enamel", "removed_dentine", "floor_flatness",
    "overcut_leeway_gingival_floor", "overcut_beyond_gingival_floor", "overcut_leeway_axial_wall", "surface_within_100", "surface_within_300",
    "surface_rms", "surface_p95", "surface_greatest", "box_height", "cavosurface_angle", "isthmus_width"};

TEST(TreeTarget, ATurnedAndShiftedSpecimenMeasuresTheSameWithinItsUncertainty) {
  const Region cut = class_two(4.4, 1.5);
  std::vector<Measure> straight;
  std::vector<std::pair<double, Vec3>> poses = {{0.0, Vec3(0.0)}, {37.0, Vec3(-0.2, 0.4, -0.35)}};
  if (full_run()) poses.insert(poses.end(), {{0.0, Vec3(0.31, -0.43, 0.27)}, {-118.0, Vec3(0.5, 0.1, 0.45)}});
  for (const auto& [deg, shift] : poses) {
    SCOPED_TRACE(testing::Message() << deg << " degrees");
    Scenario s = exercise(turned(class_two(4), deg));
    s.specimen.generator = "block";  // no side is buccal
    s.leeway = {0.2, 0.2};
    for (const char* key : kWhicheverWay) s.rubric.criteria.push_back({key, 1, {}});
    const auto specimen = turned_block(deg, shift);
    Volume volume(specimen);
    carved::carve(volume, exactly(turned(cut, deg)));
    const std::vector<Measure> all = measure(Reference(s, specimen), volume, {});
    if (straight.empty()) straight = all;
    EXPECT_NEAR(get(all, "isthmus_width").value, 1.5, get(all, "isthmus_width").uncertainty) << "of the slot; the box is 2.4 mm wide";
    for (const char* key : kWhicheverWay) {
      const Measure a = get(straight, key), b = get(all, key);
      ASSERT_TRUE(a.measured && b.measured) << key;
      EXPECT_NEAR(a.value, b.value, a.uncertainty + b.uncertainty) << key;
    }
  }
}

bool same_bits(const Measure& a, const Measure& b) {
  return a.metric == b.metric && a.measured == b.measured && a.value == b.value && a.uncertainty == b.uncertainty && a.where_mm == b.where_mm;
}

Scenario with_every_group() {
  Scenario s = exercise(class_two(4));
  s.leeway = {0.2, 0.2};
  for (const MetricKey& key : kMetricKeys) s.rubric.criteria.push_back({std::string(key.key), 1, {}});
  return s;
}

TEST(TreeTarget, MeasuresTheSameBitsOnAnyNumberOfThreads) {
  const auto specimen = block(full_run() ? 1 : 2);
  Volume volume(specimen);
  carved::carve(volume, exactly(class_two(4.4, 1.5)));
  const std::vector<Measure> alone = measure(Reference(with_every_group(), specimen), volume, {});
  const Reference shared(with_every_group(), specimen);
  std::vector<std::vector<Measure>> each(full_run() ? 3 : 2);
  {
    std::vector<std::jthread> threads;
    for (auto& one : each) threads.emplace_back([&] { one = measure(shared, volume, {}); });
  }
  for (const auto& one : each) EXPECT_TRUE(std::ranges::equal(one, alone, same_bits));
}

TEST(TreeTarget, LiveScoresAreTheSameBitsHoweverOftenTheMirrorAsks) {
  const auto specimen = block();
  const auto reference = std::make_shared<const Reference>(with_every_group(), specimen);
  std::array<LiveReading, 3> read;
  Volume volume(specimen);
  for (std::size_t i = 0; i < read.size(); ++i) {
    constexpr std::array kEvery = {1, 5, 100};  // cuts
    volume = Volume(specimen);
    LiveMetrics live(reference);
    std::set<std::int32_t> changed;
    std::map<std::int32_t, std::uint32_t> seen;
    for (int n = 0; n < 20; ++n) {
      const Vec3 at(-2.0 + 0.25 * n, 0.1 * std::sin(n), -1.6 - 0.12 * n);
      carved::carve(volume, [&](Vec3 p) { return capsule_distance(p, at, at + Vec3(0, 0, 6), 0.7); });
      for (const std::int32_t brick : volume.cut_bricks())
        if (std::exchange(seen[brick], volume.revision(brick)) != volume.revision(brick)) changed.insert(brick);
      if (n % kEvery[i] != kEvery[i] - 1 && n != 19) continue;
      live.update(volume, std::vector(changed.begin(), changed.end()));
      changed.clear();
    }
    read[i] = live.reading();
  }
  for (const LiveReading& one : read) {
    EXPECT_EQ(one.target_removed, read[0].target_removed);
    EXPECT_EQ(one.overcut_mm3, read[0].overcut_mm3);
    EXPECT_EQ(one.removed_mm3, read[0].removed_mm3);
  }
  const std::vector<Measure> all = measure(*reference, volume, {});
  EXPECT_EQ(read[0].target_removed, get(all, "target_removed").value);
  EXPECT_EQ(read[0].overcut_mm3[static_cast<std::size_t>(Place::beyond_floor)], get(all, "overcut_beyond_floor").value);
  EXPECT_EQ(read[0].removed_mm3[index_of(Tissue::dentine)], get(all, "removed_dentine").value);
}

/// A voxel's change reaches the cells of bricks on both sides, by the second differences and the faces beside an edge.
TEST(TreeTarget, LiveScoresOfABursSweepsAreThoseOfTheWhole) {
  const auto specimen = block();
  const auto reference = std::make_shared<const Reference>(with_every_group(), specimen);
  const Bur fissure = catalogue_bur("56")->bur;
  for (const bool ball : {true, false}) {
    Volume volume(specimen);
    LiveMetrics live(reference);
    std::map<std::int32_t, std::uint32_t> seen;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> tremor(-0.05, 0.05);
    Vec3 at(-2.0, -0.5, -0.3);
    for (int n = 0; n < 150; ++n) {
      const Vec3 next = Vec3(-2.0 + 0.04 * (n % 100), -0.5 + 0.25 * (n / 100), -0.3 - 0.2 * (n % 3)) + Vec3(tremor(random), tremor(random), tremor(random));
      if (ball) carve_sweep(volume, at, next, 0.4);
      else carve_sweep(volume, at, next, fissure, Vec3(0, 0, 1));
      at = next;
      std::vector<std::int32_t> changed;
      for (const std::int32_t brick : volume.cut_bricks())
        if (std::exchange(seen[brick], volume.revision(brick)) != volume.revision(brick)) changed.push_back(brick);
      live.update(volume, changed);
      if (n % 50 != 49) continue;
      LiveMetrics whole(reference);
      const auto cut = volume.cut_bricks();
      whole.update(volume, {cut.begin(), cut.end()});
      EXPECT_EQ(live.reading().removed_mm3, whole.reading().removed_mm3) << n << ball;
      EXPECT_EQ(live.reading().overcut_mm3, whole.reading().overcut_mm3) << n << ball;
    }
  }
}

}  // namespace
}  // namespace cusp::test
