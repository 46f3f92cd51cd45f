// The contact methods beside the surface proxy, each by what it promises, and by where it is known to fail: a test of a
// failure fails when the failure is gone, so that the READMEs keep telling the truth.
// CUSP_TOLERANCE_ZERO=1 prints the residuals by failing every bound.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/engine/step/cut_along.h"
#include "tests/engine/step/scenes.h"

namespace cusp::test {
namespace {

constexpr Method kAll[] = {Method::occupancy, Method::occupancy_pivot, Method::ray,
                           Method::penalty,   Method::gradient,        Method::surface};
constexpr Method kThree[] = {Method::ray, Method::penalty, Method::gradient};

std::string name_of(const testing::TestParamInfo<Method>& p) {
  std::string name(key_of(p.param));
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

/// A ball on nothing: where only the ball is meant.
void without_shank(Scene& scene) {
  Bur& bur = scene.burs[0];
  bur.neck_radius_mm = bur.shank_radius_mm = 0.05;
  bur.neck_length_mm = bur.shank_length_mm = 0.1;
}

class EveryContactMethod : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, EveryContactMethod, testing::ValuesIn(kAll), name_of);

TEST_P(EveryContactMethod, feels_nothing_in_free_space) {
  StepState state(scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.0; }), GetParam(), 0.25));
  // A tenth of a millimetre clear; a voxelised tool may reach half a voxel further than its ball.
  const StepOutput out = approach(state, {0, 0, 2.5}, {0, 0, 1.36});
  EXPECT_FALSE(out.contact);
  EXPECT_EQ(out.force_raw_n, Vec3(0.0));
  EXPECT_EQ(out.proxy_mm, out.device_mm);
}

TEST_P(EveryContactMethod, begins_where_the_device_is_when_that_is_free) {
  // Under an overhang: from above the bur could not come there.
  auto scene =
      scene_of(from_distance(4.0, 0.1, [](Vec3 p) { return box_distance(p - Vec3(0, 0, 1.0), Vec3(1.5, 1.5, 0.4)); }),
               GetParam(), 0.25);
  without_shank(*scene);
  StepState state(scene);
  const StepOutput out = step(state, input_at({0.3, 0.2, -1.0}));
  EXPECT_EQ(out.proxy_mm, out.device_mm);
  EXPECT_FALSE(out.contact);
}

TEST_P(EveryContactMethod, gives_finite_forces_to_a_violent_hand) {
  auto scene = scene_of(block_of(0.15), GetParam(), 0.4, 5.0);
  scene->friction = true;
  scene->guard = GuardSettings{};
  StepState state(scene);
  std::uint64_t seed = 7;
  const auto random = [&seed] {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 2147483648.0 - 1.0;
  };
  Vec3 at(0, 0, 3.0);
  for (int k = 0; k < 4000; ++k) {
    // From tremor to 2 mm in a tick, through the middle of everything, with every length of tick.
    const double far = k % 3 == 0 ? 1.1 : k % 3 == 1 ? 0.05 : 0.001;
    at = glm::clamp(at + far * Vec3(random(), random(), random()), Vec3(-2.6), Vec3(2.6));
    const auto elapsed = static_cast<std::uint32_t>(1 + 2000.0 * (1.0 + random()));
    const StepOutput out = step(state, input_at(at, random() > -0.2 ? CutButton::pressed : CutButton::up, elapsed));
    const double force = length(out.force_raw_n);
    ASSERT_TRUE(force >= 0.0 && force < 100.0) << k << ": " << force;  // NaN too; the block is 7 mm across, K is 1 N/mm
    ASSERT_TRUE(length(out.proxy_mm) < 100.0) << k;
    ASSERT_FALSE(out.faulted) << k;
    ASSERT_FALSE(out.overflow) << k;
  }
}

TEST_P(EveryContactMethod, removes_and_never_adds) {
  StepState state(scene_of(block_of(0.1), GetParam(), 0.3, 3.0));
  approach(state, {0, 0, 3.0}, {0, 0, 2.1});
  VoxelVolume before = state.volume().dense();
  const VoxelVolume whole = before;
  for (int round = 0; round < 5; ++round) {
    for (int k = 0; k < 60; ++k)
      step(state, input_at({0.4 * std::sin(0.02 * (k + 60 * round)), 0.01 * k, 2.0}, CutButton::pressed));
    const VoxelVolume after = state.volume().dense();
    for (std::size_t i = 0; i < after.s.size(); ++i) ASSERT_LE(after.s[i], before.s[i]);
    before = after;
  }
  EXPECT_NE(before.s, whole.s);
}

TEST_P(EveryContactMethod, leaves_tissue_that_cannot_be_cut) {
  StepState state(scene_of(block_of(0.1), GetParam(), 0.25, 0.0));
  approach(state, {0, 0, 3.0}, {0, 0, 2.0});
  for (int k = 0; k < 200; ++k) ASSERT_FALSE(step(state, input_at({0, 0, 2.0}, CutButton::pressed)).cutting);
  EXPECT_TRUE(state.volume().cut_bricks().empty());
}

TEST_P(EveryContactMethod, knows_a_cut_along_a_known_path) {
  auto scene = scene_of(block_of(0.1), GetParam(), 0.5);
  StepState state(scene);
  approach(state, {0, 0, 3.5}, {0, 0, 2.6});
  ASSERT_TRUE(cut_along(state, 0, {0, 0, 2.6}, {0, 0, 1.0}));
  EXPECT_EQ(state.last().proxy_mm, Vec3(0, 0, 2.6));
  // Down the hole, to half a voxel above its floor: the voxelised hole is that much narrower at its end.
  const StepOutput out = approach(state, {0, 0, 2.6}, {0, 0, 1.05});
  EXPECT_LT(length(out.proxy_mm - out.device_mm), 0.12) << out.proxy_mm.z;
  // By the pivot alone the bur goes deeper by its radius.
  const StepOutput pressed = approach(state, {0, 0, 1.05}, {0, 0, GetParam() == Method::occupancy_pivot ? 0.2 : 0.7});
  EXPECT_TRUE(pressed.contact);
  EXPECT_GT(pressed.force_raw_n.z, 0.2);
}

// Slides at 50 mm/s, 0.3 mm below the offset surface of a tilted face, K = 2 N/mm: a force of 0.6 N along the normal.
struct Sliding {
  double angle_deg = 0.0;  // worst
  double force_n = 0.0;    // mean
  double step_n = 0.0;     // worst from tick to tick
  double off_um = 0.0;     // worst of the proxy off the offset face
};
Sliding slide_on_face(Method method, double radius) {
  const Vec3 n = Vec3(0.1, 0.2, 1.0) / length(Vec3(0.1, 0.2, 1.0));
  auto scene = scene_of(from_distance(6.0, kPaperVoxelMm, [n](Vec3 p) { return glm::dot(p, n); }), method, radius);
  scene->tissues[index_of(Tissue::dentine)].stiffness_n_per_mm = 2.0;
  StepState state(scene);
  const auto place = [n](double s) {
    const Vec3 p(1.5 * std::cos(s / 1.5), 1.5 * std::sin(s / 1.5), 0.0);
    return p - n * glm::dot(p, n);
  };
  approach(state, place(0.0) + n * (radius + 0.5), place(0.0) + n * (radius - 0.3));
  Sliding out;
  constexpr int kTicks = 1000;
  Vec3 before = state.last().force_raw_n;
  for (int k = 1; k <= kTicks; ++k) {
    const StepOutput o = step(state, input_at(place(0.05 * k) + n * (radius - 0.3)));
    const double force = length(o.force_raw_n);
    out.angle_deg = std::max(out.angle_deg, std::acos(std::min(1.0, glm::dot(o.force_raw_n, n) / force)) * 57.29578);
    out.force_n += force / kTicks;
    out.step_n = std::max(out.step_n, length(o.force_raw_n - before));
    out.off_um = std::max(out.off_um, std::fabs(glm::dot(o.proxy_mm, n) - radius) * 1000.0);
    before = o.force_raw_n;
  }
  return out;
}

TEST(GradientProxy, pushes_back_along_a_face_with_its_depth) {
  for (const double radius : {0.25, 0.5}) {
    const Sliding s = slide_on_face(Method::gradient, radius);
    EXPECT_LE(s.angle_deg, bound(0.01)) << radius;       // measured 0.002: 16-bit samples
    EXPECT_NEAR(s.force_n, 0.6, bound(1e-4)) << radius;  // measured 7e-7
    EXPECT_LE(s.off_um, bound(0.02)) << radius;          // measured 0.003
  }
}

TEST(Penalty, pushes_back_along_a_face_with_its_depth) {
  for (const double radius : {0.25, 0.5}) {
    const Sliding s = slide_on_face(Method::penalty, radius);
    // A point a voxel, and the band's end rounded by the trilinear field.
    EXPECT_LE(s.angle_deg, bound(0.4)) << radius;        // measured 0.26
    EXPECT_NEAR(s.force_n, 0.6, bound(0.02)) << radius;  // measured 0.011
  }
}

TEST(RayProxy, pushes_back_along_a_face_within_a_voxel_of_its_depth) {
  for (const double radius : {0.25, 0.5}) {
    const Sliding s = slide_on_face(Method::ray, radius);
    EXPECT_LE(s.angle_deg, bound(4.0)) << radius;           // measured 3.1
    EXPECT_NEAR(s.force_n, 0.6, bound(0.04)) << radius;     // measured 0.016
    EXPECT_LE(s.off_um, bound(1000.0 * kPaperVoxelMm)) << radius;  // measured 58
  }
}

TEST(RayProxy, steps_by_a_voxel_on_a_slope) {
  // Known: the proxy stands on voxels. Half a voxel at 2 N/mm is 0.078 N from one tick to the next; the exact step is
  // 0.
  EXPECT_GT(slide_on_face(Method::ray, 0.25).step_n, 0.078);
}

TEST(RayProxy, never_overlaps_tissue_with_the_tool) {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.0)); }), Method::ray, 0.3);
  StepState state(scene);
  const VoxelTool tool = voxelise(scene->burs[0], scene->tool_axis, 0.1);
  approach(state, {0.13, -0.21, 2.0}, {0.13, -0.21, 0.9});
  for (int i = 0; i < 800; ++i) {
    const StepOutput out =
        step(state, input_at({0.13 + 1.3 * std::sin(i * 0.01), -0.21 + 1.2 * std::cos(i * 0.013), 0.9}));
    const Grid& grid = state.volume().grid();
    const IVec3 pivot(glm::floor((out.proxy_mm - grid.origin_mm) / 0.1 + 0.5));
    for (const IVec3& o : tool.cutting) ASSERT_FALSE(state.volume().occupied(pivot + o)) << "tick " << i;
  }
}

TEST(GradientProxy, stands_on_a_sphere_as_exactly_as_the_plain_field_is) {
  StepState state(scene_of(from_distance(10.0, kPaperVoxelMm, [](Vec3 p) { return length(p) - 4.0; }), Method::gradient, 0.5));
  approach(state, {0, 0, 5.0}, {0, 0, 4.2});
  double off = 0.0;
  for (int k = 0; k < 600; ++k) {
    const Vec3 u = Vec3(0.7 * std::sin(0.004 * k), 0.3 * std::sin(0.007 * k), 0.8);
    const StepOutput out = step(state, input_at(4.2 * u / length(u)));
    off = std::max(off, std::fabs(length(out.proxy_mm) - 4.5) * 1000.0);
  }
  // Linear between samples h apart, a distance of curvature 1/R is off by h^2 / 8R an axis: 0.38 um over the two of a
  // sphere.
  EXPECT_LE(off, bound(0.5));  // measured 0.38
}

// A wall of 0.2 mm that the device point crosses at 300 mm/s; where the proxy is at the end.
double behind_a_thin_wall(Method method) {
  auto scene = scene_of(from_distance(4.0, kPaperVoxelMm, [](Vec3 p) { return std::fabs(p.x) - 0.1; }), method, 0.25);
  without_shank(*scene);
  StepState state(scene);
  approach(state, {1.5, 0.02, 0.01}, {0.5, 0.02, 0.01});
  StepOutput out;
  for (int k = 1; k <= 6; ++k) out = step(state, input_at({0.5 - 0.3 * k, 0.02, 0.01}));
  return out.proxy_mm.x;
}

TEST(Penalty, falls_through_a_thin_wall_at_speed) {
  // Known: without a proxy there is no side. The device point is 1.3 mm behind the wall, and so is the bur.
  EXPECT_NEAR(behind_a_thin_wall(Method::penalty), -1.3, 1e-6);
}

TEST(RayProxy, stays_before_a_thin_wall_at_speed) {
  EXPECT_NEAR(behind_a_thin_wall(Method::ray), 0.35, bound(kPaperVoxelMm));  // measured 0.037
}

TEST(GradientProxy, stays_before_a_thin_wall_at_speed) {
  EXPECT_NEAR(behind_a_thin_wall(Method::gradient), 0.35, bound(0.001));  // measured 1e-7
}

/// Pressed 0.3 mm into both faces of an inner right angle along z: the exact proxy stands at (r, r). Largest distance
/// from there over 200 ticks while the device point goes along it at 10 mm/s.
double off_an_inner_angle(Method method, double radius, double tilt) {
  const double c = std::sqrt(1.0 - tilt * tilt);
  const auto turned = [c, tilt](Vec3 p) { return Vec3(c * p.x + tilt * p.y, -tilt * p.x + c * p.y, p.z); };
  const auto back = [c, tilt](Vec3 p) { return Vec3(c * p.x - tilt * p.y, tilt * p.x + c * p.y, p.z); };
  auto scene =
      scene_of(from_distance(4.0, kPaperVoxelMm, [&](Vec3 p) { return std::min(turned(p).x, turned(p).y); }), method, radius);
  without_shank(*scene);
  StepState state(scene);
  approach(state, back({radius + 0.4, radius + 0.5, 0}), back({radius - 0.3, radius - 0.3, 0}));
  double off = 0.0;
  for (int k = 0; k < 200; ++k) {
    const StepOutput out = step(state, input_at(back({radius - 0.3, radius - 0.3, 0.005 * k})));
    const Vec3 p = turned(out.proxy_mm);
    off = std::max(off, length(Vec3(p.x - radius, p.y - radius, 0.0)));
  }
  return off;
}

TEST(GradientProxy, enters_one_wall_of_an_inner_corner) {
  // Known: one plane at a time. It is some 0.1 mm inside one wall or the other; the surface proxy's error is below 1
  // um.
  EXPECT_GT(off_an_inner_angle(Method::gradient, 0.25, 0.2), 0.05);
  EXPECT_LT(off_an_inner_angle(Method::surface, 0.25, 0.2), 0.001);
}

TEST(RayProxy, rests_in_an_inner_corner_within_a_voxel) {
  EXPECT_LT(off_an_inner_angle(Method::ray, 0.25, 0.2), bound(kPaperVoxelMm));  // measured 0.042
}

TEST(GradientProxy, sinks_into_a_groove_of_sixty_degrees) {
  // Known: neither of the two planes alone holds the bur. The exact proxy stands 2 r above the groove's line, as
  // 1 / sin(30 degrees) = 2.
  const double radius = 0.25;
  const Vec3 left(std::sqrt(3.0) / 2.0, 0.0, 0.5), right(-std::sqrt(3.0) / 2.0, 0.0, 0.5);
  const auto groove = [&](Vec3 p) { return std::min(glm::dot(p, left), glm::dot(p, right)); };
  double depth[2];
  int i = 0;
  for (const Method method : {Method::gradient, Method::surface}) {
    auto scene = scene_of(from_distance(4.0, kPaperVoxelMm, groove), method, radius);
    without_shank(*scene);
    StepState state(scene);
    approach(state, {0.02, 0, 1.5}, {0.02, 0, 2 * radius - 0.3});
    StepOutput out;
    for (int k = 0; k < 100; ++k) out = step(state, input_at({0.02, 0.005 * k, 2 * radius - 0.3}));
    depth[i++] = 2 * radius - out.proxy_mm.z;
  }
  EXPECT_GT(depth[0], 0.1);
  EXPECT_LT(std::fabs(depth[1]), 0.001);
}

TEST(Penalty, is_too_soft_in_a_right_angle_and_too_stiff_in_its_own_hole) {
  // By the law: two walls give 2^(1/4) d where K d along both would be 2^(1/2) d ...
  const double radius = 0.5, depth = 0.1;
  auto corner =
      scene_of(from_distance(4.0, kPaperVoxelMm, [](Vec3 p) { return std::min(p.x, p.y); }), Method::penalty, radius);
  without_shank(*corner);
  StepState in_corner(corner);
  const StepOutput pressed = step(in_corner, input_at({radius - depth, radius - depth, 0.0}));
  EXPECT_NEAR(length(pressed.force_raw_n), std::sqrt(std::sqrt(2.0)) * depth, bound(0.005));  // measured 0.0008
  // ... and a hole as wide as the bur, whose push is d / 6 over the sphere, the depth D of a plane that gives
  // (D^2 / 2 - D^3 / 6 r) / 2 r = d / 6: 0.1956 mm.
  auto hole = scene_of(block_of(kPaperVoxelMm), Method::penalty, radius);
  without_shank(*hole);
  StepState in_hole(hole);
  ASSERT_TRUE(cut_along(in_hole, 0, {0, 0, 3.0}, {0, 0, 0.0}));
  const StepOutput held = step(in_hole, input_at({0.0, 0.0, -depth}));
  EXPECT_NEAR(held.force_raw_n.z, 0.1956, bound(0.02));  // measured 0.010
}

/// Drills straight down at full wear; mm/s between half of the stroke and its end.
double drilling_speed(Method method, double radius, double tick_us) {
  StepState state(scene_of(block_of(kPaperVoxelMm), method, radius));
  approach(state, {0.013, 0.027, 2.5 + radius}, {0.013, 0.027, 1.65 + radius});
  const int ticks = static_cast<int>(1.0e6 / tick_us);
  double from = 0.0, to = 0.0;
  for (int k = 0; k < ticks; ++k) {
    const double z = 1.65 + radius - 1e-6 * k * tick_us;
    const StepOutput out =
        step(state, input_at({0.013, 0.027, z}, CutButton::pressed, static_cast<std::uint32_t>(tick_us)));
    if (k == ticks / 2) from = out.proxy_mm.z;
    to = out.proxy_mm.z;
  }
  return (from - to) / ((ticks - 1 - ticks / 2) * tick_us * 1e-6);
}

TEST(RayProxy, drills_at_the_tissues_speed) {
  EXPECT_NEAR(drilling_speed(Method::ray, 0.25, 1000.0), 1.0,
              bound(0.1));  // measured 0.06: a voxel is 16 % of the stroke
}
TEST(Penalty, drills_at_the_tissues_speed_at_any_tick_length) {
  for (const double tick_us : {250.0, 1000.0, 4000.0})
    EXPECT_NEAR(drilling_speed(Method::penalty, 0.25, tick_us), 1.0, bound(0.03)) << tick_us;  // measured 0.0026
}
TEST(GradientProxy, drills_at_the_tissues_speed_at_any_tick_length) {
  for (const double tick_us : {250.0, 1000.0, 4000.0})
    EXPECT_NEAR(drilling_speed(Method::gradient, 0.25, tick_us), 1.0, bound(0.1)) << tick_us;  // measured 0.036
}

TEST(ContactMethods, the_shank_keeps_the_bur_off_a_wall) {
  for (const Method method : kThree) {
    auto scene = scene_of(from_distance(6.0, 0.1, [](Vec3 p) { return p.x; }), method, 0.25);
    scene->burs[0].neck_radius_mm = 0.2;
    scene->burs[0].neck_length_mm = 1.0;
    scene->burs[0].shank_radius_mm = 0.8;
    scene->burs[0].shank_length_mm = 1.0;
    StepState state(scene);
    const StepOutput out = approach(state, {2.0, 0, -1.0}, {0.6, 0, -1.0});
    EXPECT_TRUE(out.shank) << key_of(method);
    EXPECT_NEAR(out.proxy_mm.x, 0.8, bound(0.06)) << key_of(method);  // measured 0.030; its radius, not the ball's
  }
}

}  // namespace
}  // namespace cusp::test
