// A perfect method has no error; a broken one is reported.
#include "tests/bench/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/bench/frame.h"
#include "tests/bench/measure.h"

namespace cusp::bench {
namespace {

/// Coarse voxels and few ticks: quick. The bound is on ticks, so no clock decides.
Measure quick(Method method = Method::surface) {
  Measure what;
  what.method = method;
  what.voxel_mm = 0.2;
  what.budget_s = 1e9;
  what.most_ticks = 600;
  return what;
}

/// The goals of the surface proxy on a flat face (0.05 degrees, 0.05 um) as one verdict.
bool passes(const Row& row) {
  return row.samples > 100 && row.angle_deg_mean < 0.05 && row.depth_um_mean < 0.05 && row.infeasible_ticks == 0;
}

Stepper broken(const std::function<void(StepOutput&)>& how) {
  return [how](StepState& state, const StepInput& input) {
    StepOutput out = step(state, input);
    if (out.contact) how(out);
    return out;
  };
}

TEST(Accuracy, PassesTheSurfaceProxyOnAFaceAndInACorner) {
  EXPECT_TRUE(passes(measure_slide(*make_shape("face", 0.5), quick())));
  EXPECT_TRUE(passes(measure_slide(*make_shape("corner", 0.5), quick())));
}

/// What one bur has cut another one feels: a student drills with a fissure and goes on with a round bur.
TEST(Accuracy, PassesTheSurfaceProxyOnTheRimOfAHoleThatAnotherBurHasDrilled) {
  for (const double radius : {0.25, 0.5}) {
    Measure what = quick();
    what.voxel_mm = 10.0 / 128;
    what.speed_mm_s = 50.0;
    const Row row = measure_slide(*make_shape("cut", radius, "drilled"), what);
    EXPECT_GT(row.samples, 500) << radius;
    EXPECT_LT(row.angle_deg_mean, 0.1) << radius;
    EXPECT_LT(row.depth_um_mean, 0.05) << radius;
    EXPECT_LT(row.pose_um_mean, 0.3) << radius;  // measured 0.18 and 0.08; 2.6 where its rim is made of straight pieces
    EXPECT_LT(row.pose_um_max, 2.0) << radius;   // measured 1.3 and 0.8; 9 where points that lie on the rim hold the ball
  }
}

TEST(Accuracy, CatchesAFlippedNormal) {
  Measure what = quick();
  what.stepper = broken([](StepOutput& out) {
    out.force_raw_n = -out.force_raw_n;
    out.proxy_mm = 2.0 * out.device_mm - out.proxy_mm;
  });
  const Row row = measure_slide(*make_shape("face", 0.5), what);
  EXPECT_FALSE(passes(row));
  EXPECT_NEAR(row.angle_deg_mean, 180.0, 0.1);
  EXPECT_NEAR(row.depth_um_mean, 600.0, 0.5);  // 0.3 mm to the wrong side
}

TEST(Accuracy, CatchesADroppedConstraint) {
  const auto shape = make_shape("corner", 0.5);
  // The normal of one wall: from a spot that touches no other.
  const auto truth = shape->truth();
  Random random(1);
  Vec3 wall(0.0);
  while (length(wall) == 0.0) {
    const Spot spot = shape->spot(random);
    if (std::fabs(truth->clearance_mm(spot.centre + spot.normal * 0.01) - 0.01) < 1e-9) wall = spot.normal;
  }
  Measure what = quick();
  what.stepper = broken([wall](StepOutput& out) {
    const double push = glm::dot(out.force_raw_n, wall);
    out.force_raw_n -= wall * push;
    out.proxy_mm -= wall * push;
  });
  EXPECT_FALSE(passes(measure_slide(*shape, what)));
}

TEST(Accuracy, ReadsHalfADegreeAndOneMicrometreAsSuch) {
  Measure what = quick();
  const auto shape = make_shape("face", 0.5);
  const Vec3 n = shape->tool_axis();
  const Vec3 aside = unit(glm::cross(n, Vec3(1.0, 0.0, 0.0)));
  const double tilt = std::tan(0.5 / 57.295779513);
  what.stepper = broken([&](StepOutput& out) {
    out.force_raw_n += aside * (glm::dot(out.force_raw_n, n) * tilt);
    out.proxy_mm -= n * 0.001;
  });
  const Row row = measure_slide(*shape, what);
  EXPECT_NEAR(row.angle_deg_mean, 0.5, 0.01);  // the method's own 0.002 degrees beside
  EXPECT_NEAR(row.depth_um_mean, 1.0, 0.01);   // and 0.001 um
  EXPECT_NEAR(row.force_error_percent_rms, 100.0 * tilt, 0.05);
}

TEST(Accuracy, FindsNoErrorInTheExactProxyOfTheQuantisedInput) {
  // A method that answers with the exact proxy of the very input it was given, on a shape that turns its normal.
  const auto shape = make_shape("sphere", 0.5);
  const auto truth = shape->truth();
  bool begun = false;
  Measure what = quick();
  what.stepper = [&](StepState& state, const StepInput& input) {
    StepOutput out = step(state, input);
    if (!begun) truth->start(input.position_mm());
    begun = true;
    const Exact exact = truth->follow(input.position_mm());
    out.proxy_mm = exact.pose_mm;
    out.force_raw_n = exact.pose_mm - out.device_mm;
    return out;
  };
  const Row row = measure_slide(*shape, what);
  EXPECT_LT(row.angle_deg_max, 1e-6);  // 0.05 um of rounding would be 0.01 degrees of 0.3 mm
  EXPECT_LT(row.depth_um_max, 1e-6);
  EXPECT_LT(std::fabs(row.force_step_excess_mn_p99), 1e-6);
}

TEST(Accuracy, CountsAMissingForceAsNinetyDegrees) {
  Measure what = quick();
  what.stepper = broken([](StepOutput& out) { out.force_raw_n = Vec3(0.0); });
  EXPECT_DOUBLE_EQ(measure_slide(*make_shape("face", 0.5), what).angle_deg_mean, 90.0);
}

TEST(Accuracy, CountsNotANumberAsOneMetreOff) {
  Measure what = quick();
  what.stepper = broken([](StepOutput& out) { out.proxy_mm.y = std::nan(""); });
  const Row row = measure_slide(*make_shape("face", 0.5), what);
  EXPECT_DOUBLE_EQ(row.angle_deg_mean, 90.0);
  EXPECT_DOUBLE_EQ(row.depth_um_mean, 1e6);
}

TEST(Accuracy, RanksTheOccupancyProxyBelowTheSurfaceProxy) {
  const auto shape = make_shape("sphere", 0.5);
  EXPECT_GT(measure_slide(*shape, quick(Method::occupancy)).angle_deg_mean,
            50.0 * measure_slide(*shape, quick()).angle_deg_mean);  // measured: 17 against 0.01 degrees
}

TEST(Accuracy, CallsFeaturesUnderTwoAndAHalfVoxelsUnresolved) {
  EXPECT_FALSE(make_shape("wall", 0.25)->unresolved(0.078125));  // 0.2 mm are 2.56 of them
  EXPECT_TRUE(make_shape("wall", 0.25)->unresolved(0.1));
  EXPECT_FALSE(make_shape("pit", 0.25)->unresolved(0.078125));  // 0.3 mm: 3.84
  EXPECT_TRUE(make_shape("pit", 0.25)->unresolved(0.2));
  EXPECT_FALSE(make_shape("face", 0.25)->unresolved(0.2));
}

TEST(Accuracy, GivesARowForEachMethodMotionAndSpeed) {
  Options options;
  options.methods = {"surface", "occupancy"};
  options.shapes = {"face"};
  options.voxels_mm = {0.2};
  options.bur_radii_mm = {0.5};
  options.budget_s = 0.001;
  const std::vector<Row> rows = accuracy_rows(options);  // press, and slides at three speeds
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[0].method, "occupancy");
  EXPECT_EQ(rows[0].motion, "press");
  EXPECT_EQ(rows[4].method, "surface");
  EXPECT_EQ(rows[7].speed_mm_s, 200.0);
}

TEST(Accuracy, SamplesAreCountedWhateverTheyTake) {
  Options options;
  options.methods = {"surface"};
  options.shapes = {"face"};
  options.voxels_mm = {0.2};
  options.bur_radii_mm = {0.5};
  options.budget_s = 0.001;
  options.samples = 150;
  for (const Row& row : accuracy_rows(options)) EXPECT_EQ(row.samples + row.skipped, 150) << row.motion << row.speed_mm_s;
}

}  // namespace
}  // namespace cusp::bench
