#include "scenarios/metrics/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/volume/cut_volume.h"
#include "scenarios/format/keys.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/deviation.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A block of 9 x 5 x 5 mm, top at z = 0: enamel above -0.75, dentine below, pulp below -3.05.
Grid block_grid(double h) {
  Grid g;
  g.voxel_mm = h;
  g.size = IVec3(static_cast<int>(9.0 / h) + 10, static_cast<int>(5.0 / h) + 10, static_cast<int>(5.0 / h) + 10);
  g.origin_mm = Vec3(-4.5 - 4.5 * h, -2.5 - 4.5 * h, -5.0 - 4.5 * h) + h * Vec3(0.21, -0.13, 0.07);
  return g;
}
double block(Vec3 p) { return box_distance(p, Vec3(0, 0, -2.5), Vec3(4.5, 2.5, 2.5)); }
Tissue layers(Vec3 p) { return p.z > -0.75 ? Tissue::enamel : p.z > -3.05 ? Tissue::dentine : Tissue::pulp; }
Tissue no_pulp(Vec3 p) { return p.z > -0.75 ? Tissue::enamel : Tissue::dentine; }

/// A slot of 6 x 1.2 mm, 2 mm deep, corners of 0.5 mm.
Scenario slot() {
  Scenario s;
  s.tissues = {{Tissue::enamel, 3, 0.4}, {Tissue::dentine, 2, 1.6}, {Tissue::pulp, 0.5, 5}, {Tissue::bone, 1, 1}};
  s.instruments = {{}};
  s.target.outline.shape = "channel";
  s.target.outline.paths = {{Vec3(-3, 0, -2), Vec3(3, 0, -2)}};
  s.target.outline.width_mm = 1.2;
  s.target.outline.depth_mm = 2.0;
  s.target.outline.corner_radius_mm = 0.5;
  s.leeway.floor_mm = 0.3;
  s.leeway.side_mm = 0.2;
  return s;
}

struct Bench {
  Scenario scenario = slot();
  std::shared_ptr<const Specimen> specimen;
  std::shared_ptr<const Reference> reference;
  explicit Bench(double h = 0.1, Reading reading = Reading::banded, Tissue (*tissue_at)(Vec3) = layers)
      : specimen(carved::specimen(block_grid(h), reading, block, tissue_at)),
        reference(std::make_shared<Reference>(scenario, specimen)) {}
  Measure get(const Volume& volume, std::string_view key, const Process& process = {}) const {
    for (const Measure& m : measure(*reference, volume, process))
      if (m.metric == key) return m;
    ADD_FAILURE() << "no measure " << key;
    return {};
  }
};

/// A slot as a cut: shifted, deepened and widened against the target.
double cut_slot(Vec3 p, double deeper, double wider, double shift = 0.0) {
  Outline t = slot().target.outline;
  t.depth_mm += deeper;
  t.width_mm += 2.0 * wider;
  t.corner_radius_mm += wider;  // the same fillet, offset
  const OutlineShape shape(t);
  return shape.distance_mm(p - Vec3(0, shift, 0));
}

/// Closed form of the slot's volume below z = 0: a stadium swept down, less the fillet along its edge.
double slot_mm3(double width, double depth, double r) {
  const double a = 0.5 * width, length = 6.0;
  const double stadium = kPi * a * a + length * width;
  // Fillet: cross section r² (1 - pi/4) along both straight walls, and its solid of revolution at the two half ends:
  // Pappus, with the section's centroid r (10 - 3 pi) / (12 - 3 pi) from the wall.
  const double section = r * r * (1.0 - kPi / 4.0);
  const double from_wall = r * (10.0 - 3.0 * kPi) / (12.0 - 3.0 * kPi);
  return stadium * depth - section * (2.0 * length + 2.0 * kPi * (a - from_wall));
}

TEST(Reference, KnowsTheTargetsOwnVolume) {
  const Bench bench;
  const double exact = slot_mm3(1.2, 2.0, 0.5);
  EXPECT_NEAR(bench.reference->target_mm3(), exact, 0.002 * exact);
}

TEST(Measure, AnUntouchedSpecimenIsNothingRemovedAndAllLeft) {
  const Bench bench;
  const Volume volume(bench.specimen);
  EXPECT_EQ(bench.get(volume, "target_removed").value, 0.0);
  EXPECT_NEAR(bench.get(volume, "uncut_remainder").value, bench.reference->target_mm3(), 1e-12);
  EXPECT_EQ(bench.get(volume, "overcut_beyond_side").value, 0.0);
  EXPECT_FALSE(bench.get(volume, "depth_mean").measured);
  EXPECT_FALSE(bench.get(volume, "remaining_over_pulp").measured);
  EXPECT_FALSE(bench.get(volume, "force_peak").measured);
  EXPECT_FALSE(bench.get(volume, "time").measured);
  EXPECT_EQ(bench.get(volume, "pulp_exposure").value, 0.0);
  EXPECT_TRUE(bench.get(volume, "pulp_exposure").measured);
  EXPECT_FALSE(bench.get(volume, "removed_bone").measured) << "a tissue that the specimen does not have";
}

TEST(Measure, ThePerfectCutIsAllOfTheTargetAndNothingElse) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  const Measure removed = bench.get(volume, "target_removed");
  EXPECT_NEAR(removed.value, 100.0, 0.2);
  EXPECT_LT(std::fabs(100.0 - removed.value), 2.0 * removed.uncertainty + 0.05);
  double over = 0;
  for (const char* key :
       {"overcut_leeway_floor", "overcut_leeway_side", "overcut_beyond_floor", "overcut_beyond_side"})
    over += bench.get(volume, key).value;
  EXPECT_LT(over, 0.02);  // of 13.6 mm3
  EXPECT_NEAR(bench.get(volume, "depth_mean").value, 2.0, 0.001);
  EXPECT_NEAR(bench.get(volume, "depth_least").value, 2.0, 0.01);
  EXPECT_NEAR(bench.get(volume, "depth_most").value, 2.0, 0.01);
}

TEST(Measure, OverCutIsDividedByRegionAsItsClosedForm) {
  const Bench bench;
  Volume volume(bench.specimen);
  // 0.5 mm too deep with the right walls: 0.3 of it is tolerated. Below the old floor the new slot's own fillet lies.
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0.5, 0); });
  const double all = slot_mm3(1.2, 2.5, 0.5) - slot_mm3(1.2, 2.0, 0.5);
  const Measure tolerated = bench.get(volume, "overcut_leeway_floor");
  const Measure beyond = bench.get(volume, "overcut_beyond_floor");
  const double side = bench.get(volume, "overcut_leeway_side").value + bench.get(volume, "overcut_beyond_side").value;
  EXPECT_NEAR(tolerated.value + beyond.value + side, all, 0.01 * all);
  // By brute force: the analytic shapes sampled at 0.02 mm.
  double want_tolerated = 0, want_beyond = 0;
  const TargetShape shape(bench.scenario.target);
  const double step = 0.025;
  for (double x = -4; x < 4; x += step)
    for (double y = -1; y < 1; y += step)
      for (double z = -2.6; z < -1.4; z += step) {
        const Vec3 p(x, y, z);
        if (cut_slot(p, 0.5, 0) >= 0.0) continue;
        const Place place = place_of(shape, bench.scenario.leeway, p);
        want_tolerated += place == Place::tolerated_floor ? step * step * step : 0.0;
        want_beyond += place == Place::beyond_floor ? step * step * step : 0.0;
      }
  EXPECT_NEAR(tolerated.value, want_tolerated, 0.01 * want_tolerated);
  EXPECT_NEAR(beyond.value, want_beyond, 0.01 * want_beyond);
  ASSERT_TRUE(beyond.where_mm.has_value());
  EXPECT_NEAR(beyond.where_mm->z, -2.5, 0.02);
  EXPECT_NEAR(bench.get(volume, "depth_mean").value, 2.5, 0.001);
}

TEST(Measure, OverCutWallsCountAsSide) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0, 0.4); });
  const Measure side = bench.get(volume, "overcut_leeway_side");
  const Measure beyond = bench.get(volume, "overcut_beyond_side");
  // A shift of 0.4 sweeps 0.4 x 6 x 2 and the ends' crescents, less the fillet; 0.2 of the 0.4 mm is tolerated.
  EXPECT_GT(side.value, 2.0);
  EXPECT_GT(beyond.value, 2.0);
  // The uncut remainder on the other side equals the over-cut on this one; below the bisector it counts as floor.
  const double floor = bench.get(volume, "overcut_leeway_floor").value + bench.get(volume, "overcut_beyond_floor").value;
  EXPECT_NEAR(side.value + beyond.value + floor, bench.get(volume, "uncut_remainder").value, 0.03);
  ASSERT_TRUE(beyond.where_mm.has_value());
  EXPECT_GT(beyond.where_mm->y, 0.9);
  EXPECT_LT(bench.get(volume, "target_removed").value, 75.0);
  ASSERT_TRUE(bench.get(volume, "uncut_remainder").where_mm.has_value());
  EXPECT_LT(bench.get(volume, "uncut_remainder").where_mm->y, 0.0);
}

TEST(Measure, HalvingTheVoxelShrinksTheError) {
  double last = 0;
  for (const double h : {0.2, 0.1}) {
    const Bench bench(h);
    Volume volume(bench.specimen);
    const auto tool = [](Vec3 p) { return capsule_distance(p, Vec3(-2, 0.1, -0.9), Vec3(2, 0.1, -0.9), 0.5); };
    carved::carve(volume, tool);
    const double exact = kPi * 0.25 * 4.0 + 4.0 / 3.0 * kPi * 0.125;  // wholly inside block and target
    RegionShares sum;
    for (const int b : bricks_to_measure(volume)) sum.add(shares_of_brick(*bench.reference, volume, b));
    double all = 0;
    for (const double v : sum.removed_mm3) all += v;
    const double error = std::fabs(all / exact - 1.0);
    std::printf("capsule through the regions, h %.2f: %.4f %%\n", h, 100 * error);
    if (last > 0.0) {
      EXPECT_LT(error, last / 4.0);
    }
    last = error;
  }
}

TEST(Measure, PlacesAndTissuesAddUpToTheWholeOfWhatIsGone) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0.4, 0.3, 0.1); });
  RegionShares sum;
  for (const int b : bricks_to_measure(volume)) sum.add(shares_of_brick(*bench.reference, volume, b));
  double places = 0, tissues = 0;
  for (const double v : sum.removed_mm3) places += v;
  for (const double v : sum.tissue_mm3) tissues += v;
  EXPECT_NEAR(places, removed_solid(volume).total_mm3(), 1e-9);
  EXPECT_NEAR(tissues, places, 1e-9);
}

TEST(Measure, RemovedTissueIsWithinItsUncertainty) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  const Measure enamel = bench.get(volume, "removed_enamel");
  const double exact = (kPi * 0.36 + 6.0 * 1.2) * 0.75;
  EXPECT_NEAR(enamel.value, exact, 2.0 * enamel.uncertainty);
  EXPECT_GT(enamel.uncertainty, 0.0);
}

TEST(Measure, RemainingOverPulpIsTheGapToThePulp) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  const Measure m = bench.get(volume, "remaining_over_pulp");
  EXPECT_NEAR(m.value, 1.05, m.uncertainty);
  EXPECT_NEAR(m.uncertainty, 0.06, 1e-9);
  ASSERT_TRUE(m.where_mm.has_value());
  EXPECT_NEAR(m.where_mm->z, -2.0, 0.02);
  EXPECT_EQ(bench.get(volume, "pulp_exposure").value, 0.0);
}

TEST(Measure, ACutThatReachesThePulpIsAnExposure) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  carved::carve(volume, [](Vec3 p) { return capsule_distance(p, Vec3(1, 0, -2), Vec3(1, 0, -2.7), 0.5); });
  const Measure m = bench.get(volume, "pulp_exposure");
  EXPECT_EQ(m.value, 1.0);
  ASSERT_TRUE(m.where_mm.has_value());
  EXPECT_NEAR(m.where_mm->x, 1.0, 0.5);
  EXPECT_NEAR(bench.get(volume, "remaining_over_pulp").value, 0.0, 1e-9);
}

/// A pulp of 0.6 mm in the middle of the slot: 0.3 mm from its walls, 0.7 mm above its floor.
Tissue small_pulp(Vec3 p) { return ball_distance(p, Vec3(0, 0, -1), 0.3) < 0.0 ? Tissue::pulp : no_pulp(p); }

TEST(Measure, NothingRemainsOverAPulpThatIsGoneWhole) {
  const Bench bench(0.1, Reading::banded, small_pulp);
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  EXPECT_EQ(bench.get(volume, "pulp_exposure").value, 1.0);
  const Measure m = bench.get(volume, "remaining_over_pulp");
  EXPECT_TRUE(m.measured);
  EXPECT_EQ(m.value, 0.0);  // the cut surface is 0.3 mm from where it was
  LiveMetrics live(bench.reference);
  live.update(volume, volume.cut_bricks());
  EXPECT_EQ(live.reading().remaining_over_pulp_mm, 0.0);
}

TEST(Measure, NothingRemainsOverThePulpOfAToothThatIsGoneWhole) {
  const Bench bench;
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3) { return -10.0; });
  EXPECT_EQ(bench.get(volume, "pulp_exposure").value, 1.0);
  const Measure m = bench.get(volume, "remaining_over_pulp");
  EXPECT_TRUE(m.measured) << "else its points go to what is left of the rubric";
  EXPECT_EQ(m.value, 0.0);
  EXPECT_FALSE(m.where_mm.has_value());  // there is no cut surface
}

TEST(Measure, WithoutPulpItIsNotMeasured) {
  const Bench bench(0.1, Reading::banded, no_pulp);
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  EXPECT_FALSE(bench.get(volume, "pulp_exposure").measured);
  EXPECT_FALSE(bench.get(volume, "remaining_over_pulp").measured);
}

TEST(Measure, DepthLooksOnlyAtFloorsThatABurLeft) {
  const Bench bench;
  Volume volume(bench.specimen);
  // Half of the slot is cut, and only to 1.5 mm; the rest is the block's own face and is no floor.
  carved::carve(volume, [](Vec3 p) { return std::max(cut_slot(p, -0.5, 0), p.x); });
  EXPECT_NEAR(bench.get(volume, "depth_mean").value, 1.5, 0.002);
  EXPECT_NEAR(bench.get(volume, "depth_least").value, 1.5, 0.05);
  EXPECT_NEAR(bench.get(volume, "depth_most").value, 1.5, 0.01);
}

TEST(Measure, AFilledVolumeIsMeasuredWithALargerUncertainty) {
  const Bench bench(0.1, Reading::filled);
  Volume volume(bench.specimen);
  carved::carve(volume, [](Vec3 p) { return cut_slot(p, 0, 0); });
  const Measure removed = bench.get(volume, "target_removed");
  EXPECT_NEAR(removed.value, 100.0, removed.uncertainty);
  EXPECT_GT(removed.uncertainty, 1.0);
  const Measure depth = bench.get(volume, "depth_mean");
  EXPECT_NEAR(depth.value, 2.0, depth.uncertainty);
  EXPECT_NEAR(depth.uncertainty, 0.05, 1e-9);
}

TEST(Measure, ATargetOutsideTheSpecimenIsNotMeasured) {
  Bench bench;
  bench.scenario.target.outline.paths = {{Vec3(40, 0, 0), Vec3(41, 0, 0)}};
  const Reference away(bench.scenario, bench.specimen);
  for (const Measure& m : measure(away, Volume(bench.specimen), {})) {
    if (m.metric != "target_removed" && m.metric != "uncut_remainder") continue;
    EXPECT_FALSE(m.measured);
  }
}

TEST(Live, AgreesWithTheFinalMeasuresAfterManyCuts) {
  const Bench bench;
  Volume volume(bench.specimen);
  LiveMetrics live(bench.reference);
  std::vector<std::uint32_t> seen(static_cast<std::size_t>(volume.specimen().brick_count().x) *
                                  static_cast<std::size_t>(volume.specimen().brick_count().y) *
                                  static_cast<std::size_t>(volume.specimen().brick_count().z));
  double last = 0;
  for (int i = 0; i <= 24; ++i) {
    const Vec3 at(-3.0 + 0.25 * i, 0.05 * std::sin(i), -1.2 - 0.03 * i);
    carved::carve(volume, [&](Vec3 p) { return capsule_distance(p, at, at + Vec3(0, 0, 3), 0.5); });
    std::vector<std::int32_t> changed;
    for (const std::int32_t b : volume.cut_bricks()) {
      const auto n = static_cast<std::size_t>(b);
      if (volume.revision(b) != seen[n]) changed.push_back(b);
      seen[n] = volume.revision(b);
    }
    live.update(volume, changed);
    EXPECT_GE(live.reading().target_removed, last);
    last = live.reading().target_removed;
  }
  EXPECT_EQ(live.reading().target_removed, bench.get(volume, "target_removed").value);
  EXPECT_EQ(live.reading().overcut_mm3[static_cast<std::size_t>(Place::tolerated_side)],
            bench.get(volume, "overcut_leeway_side").value);
  EXPECT_EQ(live.reading().overcut_mm3[static_cast<std::size_t>(Place::beyond_floor)],
            bench.get(volume, "overcut_beyond_floor").value);
  EXPECT_EQ(live.reading().removed_mm3[index_of(Tissue::dentine)], bench.get(volume, "removed_dentine").value);
  ASSERT_TRUE(live.reading().remaining_over_pulp_mm.has_value());
  EXPECT_EQ(*live.reading().remaining_over_pulp_mm, bench.get(volume, "remaining_over_pulp").value);
  live.reset();
  EXPECT_EQ(live.reading().target_removed, 0.0);
}

TEST(Live, CallsThePulpExposedWhenTheGradeDoes) {
  const Bench bench;
  Volume volume(bench.specimen);
  LiveMetrics live(bench.reference);
  int exposed = 0;
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    // The lowest place goes from -2.95 to -3.17 mm: past the last voxel of dentine, at -3.04 mm, and half a voxel into the pulp's first.
    const Vec3 at(1, 0, -2.45 - 0.02 * i);
    carved::carve(volume, [&](Vec3 p) { return capsule_distance(p, at, at + Vec3(0, 0, 3), 0.5); });
    live.update(volume, volume.cut_bricks());
    EXPECT_EQ(live.reading().pulp_exposed, bench.get(volume, "pulp_exposure").value == 1.0) << i;
    exposed += live.reading().pulp_exposed ? 1 : 0;
  }
  EXPECT_TRUE(exposed > 0 && exposed < kSteps) << exposed;
}

TEST(Measure, MeasuresCoolantOnlyIfTheExerciseHasHeat) {
  Process p;
  StepOutput o;
  o.elapsed_us = 1000;
  o.heat_k = 6.0f;
  o.phenomena = static_cast<std::uint8_t>(PhenomenonSign::overheated);
  p.add(o);
  Bench without(0.25);
  const Volume volume(without.specimen);
  for (const Measure& m : measure(*without.reference, volume, p)) EXPECT_FALSE(needs_heat(m.metric)) << m.metric;

  Scenario scenario = slot();
  scenario.phenomena = {"heat"};
  const Reference with(scenario, without.specimen);
  int reported = 0;
  for (const Measure& m : measure(with, volume, p)) {
    if (!needs_heat(m.metric)) continue;
    ++reported;
    EXPECT_TRUE(m.measured) << m.metric;
    EXPECT_NEAR(m.value, m.metric == "dry_cutting" ? 1.0 : m.metric == "dry_cutting_time" ? 0.0 : 6.0, 1e-6) << m.metric;
  }
  EXPECT_EQ(reported, 3);
  for (const Measure& m : measure(with, volume, Process()))
    EXPECT_FALSE(needs_heat(m.metric) && m.measured) << m.metric << " of an attempt that never began";
}

TEST(Deviation, IsPositiveForOverCutAndNegativeForUncutRemainder) {
  const TargetShape shape(slot().target);
  EXPECT_NEAR(*deviation_mm(shape, {0, 0, -2.3}, SurfaceKind::cut), 0.3, 1e-12);
  EXPECT_NEAR(*deviation_mm(shape, {0, 0, -1.8}, SurfaceKind::cut), -0.2, 1e-12);
  // The block's face within the outline: all of it still stands.
  EXPECT_LT(*deviation_mm(shape, {0, 0, 0}, SurfaceKind::original), 0.0);
  EXPECT_FALSE(deviation_mm(shape, {0, 2, 0}, SurfaceKind::original).has_value());
}

}  // namespace
}  // namespace cusp::test
