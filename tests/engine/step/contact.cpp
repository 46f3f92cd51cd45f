// The proxies against closed forms. CUSP_TOLERANCE_ZERO=1 prints the residuals by failing every bound.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/contact/solver/plane_search.h"
#include "tests/engine/step/cut_along.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

struct Residual {
  double angle_deg = 0.0;
  double depth_um = 0.0;
  int infeasible = 0;
};

/// Slides at 50 mm/s, 0.3 mm below the offset surface, and keeps the worst of 4,000 ticks.
Residual slide(const VoxelVolume& volume, double radius, const std::function<Vec3(double)>& on_surface,
               const std::function<double(Vec3)>& distance, const std::function<Vec3(Vec3)>& normal) {
  StepState state(scene_of(volume, Method::surface, radius));
  const Vec3 start = on_surface(0.0);
  approach(state, start + normal(start) * (radius + 0.5), start + normal(start) * (radius - 0.3));
  Residual worst;
  for (int k = 1; k <= 4000; ++k) {
    const Vec3 p = on_surface(0.05 * k);
    const StepInput input = input_at(p + normal(p) * (radius - 0.3));
    const StepOutput out = step(state, input);
    const Vec3 exact = normal(input.position_mm());
    const double cosine = glm::dot(out.force_raw_n, exact) / length(out.force_raw_n);
    worst.angle_deg = std::max(worst.angle_deg, std::acos(std::min(1.0, cosine)) * 57.29578);
    worst.depth_um = std::max(worst.depth_um, std::fabs(distance(out.proxy_mm) - radius) * 1000.0);
    worst.infeasible += out.infeasible ? 1 : 0;
  }
  return worst;
}

TEST(SurfaceProxy, slides_over_a_tilted_face_with_the_exact_normal) {
  const Vec3 n = Vec3(0.1, 0.2, 1.0) / length(Vec3(0.1, 0.2, 1.0));
  const auto face = [n](Vec3 p) { return glm::dot(p, n); };
  const VoxelVolume volume = from_distance(10.0, kPaperVoxelMm, face);
  const auto circle = [n](double s) {
    const Vec3 p(2.0 * std::cos(s / 2.0), 2.0 * std::sin(s / 2.0), 0.0);
    return p - n * glm::dot(p, n);
  };
  const Residual worst = slide(volume, 0.25, circle, face, [n](Vec3) { return n; });
  EXPECT_LE(worst.angle_deg, bound(0.02));  // measured 0.004: 16-bit samples
  EXPECT_LE(worst.depth_um, bound(0.02));   // measured 0.0023
  EXPECT_EQ(worst.infeasible, 0);
}

TEST(SurfaceProxy, slides_over_a_sphere_far_below_the_voxel_size) {
  const auto sphere = [](Vec3 p) { return length(p) - 4.0; };
  const VoxelVolume volume = from_distance(10.0, kPaperVoxelMm, sphere);
  const auto path = [](double s) {
    const Vec3 u(0.75 * std::cos(s / 3.0), 0.75 * std::sin(s / 3.0), 0.66 + 0.1 * std::sin(s));
    return 4.0 * u / length(u);
  };
  const Residual worst = slide(volume, 0.5, path, sphere, [](Vec3 p) { return p / length(p); });
  EXPECT_LE(worst.angle_deg, bound(0.03));  // measured 0.008
  EXPECT_LE(worst.depth_um, bound(0.05));   // measured 0.004
  EXPECT_EQ(worst.infeasible, 0);
}

TEST(SurfaceProxy, a_bur_outside_the_tissue_feels_no_force) {
  const VoxelVolume volume = from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.0; });
  StepState state(scene_of(volume, Method::surface, 0.25));
  const StepOutput out = approach(state, {0, 0, 2.5}, {0, 0, 1.26});
  EXPECT_FALSE(out.contact);
  EXPECT_EQ(out.force_raw_n, Vec3(0.0));
  EXPECT_EQ(out.proxy_mm, out.device_mm);
}

TEST(SurfaceProxy, rests_in_an_inner_corner_on_three_faces) {
  // Outside of a box, turned inside out: tissue round a cubic cavity, 3 mm wide.
  const VoxelVolume volume = from_distance(5.0, 0.1, [](Vec3 p) { return -box_distance(p, Vec3(1.5, 1.5, 1.5)); });
  auto scene = scene_of(volume, Method::surface, 0.4);
  scene->burs[0].neck_length_mm = 0.1;
  scene->burs[0].shank_length_mm = 0.1;
  scene->burs[0].shank_radius_mm = 0.1;
  StepState state(scene);
  StepOutput out;
  for (int i = 0; i < 200; ++i) out = step(state, input_at(Vec3(0.0)));
  for (int i = 1; i <= 200; ++i) out = step(state, input_at(Vec3(-1.4 * i / 200.0)));
  // The ball's centre stands 0.4 mm from each face, at -1.1; the corner itself is rounded over a voxel.
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(out.proxy_mm[a], -1.1, bound(0.0005));
}

/// Within 2.5 voxels of an outer edge the field rounds: faces and edge are to be known all the same.
TEST(SurfaceProxy, beside_an_outer_edge_it_feels_the_face_alone) {
  // A box turned so that no face lies in a grid plane; the ball stands on its top, beside the edge x = 1.
  const Vec3 x = Vec3(0.95, 0.2, 0.24) / length(Vec3(0.95, 0.2, 0.24));
  const Vec3 y = glm::cross(Vec3(0.0, 0.0, 1.0), x) / length(glm::cross(Vec3(0.0, 0.0, 1.0), x));
  const Vec3 z = glm::cross(x, y);
  const auto scene = scene_of(from_distance(3.0, kPaperVoxelMm, [&](Vec3 p) {
                                return box_distance(Vec3(glm::dot(p, x), glm::dot(p, y), glm::dot(p, z)), Vec3(1.0));
                              }), Method::surface, 0.5);
  double worst = 0.0;
  for (const double beside : {0.02, 0.05, 0.08, 0.1, 0.15})
    for (int k = 0; k < 24; ++k) {
      StepState state(scene);
      const Vec3 touch = x * (1.0 - beside) + y * (-0.6 + 0.051 * k) + z * 1.5;
      approach(state, touch + z * 0.1, touch - z * 0.1);
      const StepOutput out = step(state, input_at(touch - z * 0.1));
      const Vec3 aside = out.force_raw_n - z * glm::dot(out.force_raw_n, z);
      worst = std::max(worst, length(aside) / length(out.force_raw_n) * 57.29578);
    }
  EXPECT_LE(worst, bound(0.2));  // degrees; measured 0.1 (of the rounded field: 12)
}

TEST(SurfaceProxy, the_shank_keeps_the_bur_off_a_wall) {
  const VoxelVolume volume = from_distance(6.0, 0.1, [](Vec3 p) { return p.x - 0.0; });
  auto scene = scene_of(volume, Method::surface, 0.25);
  scene->burs[0].neck_radius_mm = 0.2;
  scene->burs[0].neck_length_mm = 1.0;
  scene->burs[0].shank_radius_mm = 0.8;
  scene->burs[0].shank_length_mm = 1.0;
  StepState state(scene);
  const StepOutput out = approach(state, {2.0, 0, -1.0}, {0.1, 0, -1.0});
  EXPECT_TRUE(out.shank);
  EXPECT_NEAR(out.proxy_mm.x, 0.8, bound(0.002));  // the shank's radius, not the ball's
}

TEST(SurfaceProxy, a_wall_cannot_be_jumped_in_one_tick) {
  // 0.4 mm wall; the device point crosses it at 1 m/s.
  const VoxelVolume volume = from_distance(6.0, 0.1, [](Vec3 p) { return std::fabs(p.x) - 0.2; });
  auto scene = scene_of(volume, Method::surface, 0.25);
  scene->burs[0].shank_radius_mm = scene->burs[0].neck_radius_mm;
  StepState state(scene);
  StepOutput out = approach(state, {-1.5, 0, 0}, {-0.6, 0, 0});
  for (int i = 0; i < 30; ++i) {
    out = step(state, input_at(Vec3(std::min(1.5, -0.6 + 1.0 * i), 0.003 * i, 0)));
    EXPECT_LT(out.proxy_mm.x, -0.44) << "tick " << i;
  }
}

TEST(SurfaceProxy, a_wall_that_cuts_have_left_holds_a_bur_that_lags_behind_its_device) {
  // The device leaps out of a pocket 2.5 mm long, through the 0.4 mm that are left at its end, and rests: the proxy is on its
  // way for some ticks, in which no wall is within reach of the device's own motion.
  auto scene = scene_of(block_of(0.1), Method::surface, 0.25);
  scene->burs[0].shank_radius_mm = scene->burs[0].neck_radius_mm;
  scene->burs.push_back(scene->burs[0]);
  scene->burs[1].radius_mm = 0.3;
  StepState state(scene);
  for (int k = 0; k <= 14; ++k) {
    const double x = k <= 12 ? -1.5 + 0.2 * k : 1.7 + 0.2 * (k - 12);
    for (const double z : {1.1, 1.3, 1.5, 1.7, 1.9}) ASSERT_TRUE(cut_along(state, 1, {x, -1.0, z}, {x, 1.0, z}));
  }
  approach(state, {-1.5, 0, 4.0}, {-1.5, 0, 1.5});
  for (int i = 0; i < 30; ++i) {
    const StepOutput out = step(state, input_at(Vec3(1.9, 0.003 * i, 1.5)));
    EXPECT_LT(out.proxy_mm.x, 1.0) << "tick " << i;
  }
}

TEST(OccupancyProxy, never_overlaps_tissue_with_the_tool) {
  const VoxelVolume volume = from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.0)); });
  auto scene = scene_of(volume, Method::occupancy, 0.3);
  StepState state(scene);
  const VoxelTool tool = voxelise(scene->burs[0], scene->tool_axis, 0.1);
  approach(state, {0.13, -0.21, 2.0}, {0.13, -0.21, 0.9});
  for (int i = 0; i < 800; ++i) {
    const StepOutput out = step(state, input_at({0.13 + 0.9 * std::sin(i * 0.01), -0.21 + 0.7 * std::cos(i * 0.013), 0.9}));
    const Vec3 x = (out.proxy_mm - volume.grid.origin_mm) / 0.1 + 0.5;
    const IVec3 pivot(glm::floor(x));
    for (const IVec3& o : tool.cutting) ASSERT_FALSE(state.volume().occupied(pivot + o)) << "tick " << i;
  }
}

TEST(OccupancyProxy, pushes_back_along_the_face_it_presses) {
  const VoxelVolume volume = from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.0)); });
  StepState state(scene_of(volume, Method::occupancy, 0.3));
  const StepOutput out = approach(state, {0, 0, 2.0}, {0, 0, 0.9});
  EXPECT_TRUE(out.contact);
  EXPECT_GT(out.force_raw_n.z, 0.3);
  EXPECT_LT(std::fabs(out.force_raw_n.x) + std::fabs(out.force_raw_n.y), 0.1);  // within a voxel: the ray leaves from its centre
}

TEST(PlaneSearch, agrees_with_brute_force_over_all_triples) {
  // Random planes about the origin; the true optimum is the best feasible vertex, edge point or foot.
  std::uint64_t seed = 42;
  const auto random = [&seed] {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 2147483648.0 - 1.0;
  };
  for (int round = 0; round < 300; ++round) {
    std::vector<Plane> planes;
    for (int i = 0; i < 9; ++i) {
      Vec3 n(random(), random(), random() + 1.1);
      n = n / length(n);
      planes.push_back({n, 0.3 * random()});
    }
    const Vec3 q(random(), random(), -1.0);
    const auto feasible = [&planes](Vec3 y) {
      for (const Plane& p : planes)
        if (glm::dot(p.n, y) < p.c - 1e-9) return false;
      return true;
    };
    double best = feasible(q) ? 0.0 : 1e9;
    const auto offer = [&](Vec3 y) {
      if (feasible(y)) best = std::min(best, length(y - q));
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
      offer(q + planes[i].n * (planes[i].c - glm::dot(planes[i].n, q)));
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        const double g = glm::dot(planes[i].n, planes[j].n);
        const double a = planes[i].c - glm::dot(planes[i].n, q);
        const double b = planes[j].c - glm::dot(planes[j].n, q);
        const double det = 1.0 - g * g;
        offer(q + planes[i].n * ((a - g * b) / det) + planes[j].n * ((b - g * a) / det));
        for (std::size_t k = j + 1; k < planes.size(); ++k) {
          const glm::dmat3 m = glm::transpose(glm::dmat3(planes[i].n, planes[j].n, planes[k].n));
          offer(glm::inverse(m) * Vec3(planes[i].c, planes[j].c, planes[k].c));
        }
      }
    }
    const PlaneSearch found = closest_point(q, planes, 1e-10);
    ASSERT_TRUE(found.feasible) << "round " << round;
    ASSERT_TRUE(feasible(found.y)) << "round " << round;
    ASSERT_NEAR(length(found.y - q), best, 1e-7) << "round " << round;
  }
}

TEST(PlaneSearch, bears_planes_that_all_but_coincide) {
  // Neighbouring points of one smooth surface: normals that differ by 1e-9 to 1e-2, and a device that pushes through
  // them.
  std::uint64_t seed = 7;
  const auto random = [&seed] {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 1073741824.0 - 1.0;
  };
  for (int round = 0; round < 20000; ++round) {
    const double spread = std::pow(10.0, -5.5 + 3.5 * random());
    std::vector<Plane> planes;
    PlaneSet set(8);
    for (int i = 0; i < 5 + round % 3; ++i) {
      const Vec3 n(spread * random(), spread * random(), 1.0);
      planes.push_back({n / length(n), 1e-5 * random()});
      set.add(planes.back().n, planes.back().c);
    }
    const Vec3 q(0.1 * random(), 0.1 * random(), -0.3);
    for (const PlaneSearch& found : {closest_point(q, planes, 1e-7), closest_point(q, set, 1e-7, {})}) {
      ASSERT_TRUE(std::isfinite(found.y.x) && std::isfinite(found.y.y) && std::isfinite(found.y.z)) << "round " << round;
      ASSERT_TRUE(found.feasible) << "round " << round;
      for (const Plane& p : planes) ASSERT_GT(glm::dot(p.n, found.y) - p.c, -2e-7) << "round " << round;
    }
  }
}

TEST(PlaneSearch, finds_the_same_point_sooner_from_planes_thought_to_hold) {
  std::uint64_t seed = 11;
  const auto random = [&seed] {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 1073741824.0 - 1.0;
  };
  for (int round = 0; round < 2000; ++round) {
    PlaneSet set(40);
    for (int i = 0; i < 40; ++i) {
      const Vec3 n(random(), random(), random() + 1.2);
      set.add(n / length(n), 0.3 * random());
    }
    const Vec3 q(random(), random(), -1.0);
    const PlaneSearch cold = closest_point(q, set, 1e-9, {});
    ASSERT_TRUE(cold.feasible);
    const int guess[3] = {static_cast<int>(20.0 + 19.0 * random()), cold.index[0], 7};
    const PlaneSearch warm = closest_point(q, set, 1e-9, {guess, static_cast<std::size_t>(round % 4)});
    ASSERT_TRUE(warm.feasible);
    ASSERT_LT(length(cold.y - warm.y), 1e-7) << "round " << round;
  }
}

TEST(PlaneSearch, says_when_planes_contradict_each_other) {
  const Plane planes[] = {{Vec3(0, 0, 1), 1.0}, {Vec3(0, 0, -1), 1.0}};
  EXPECT_FALSE(closest_point(Vec3(0.0), planes, 1e-9).feasible);
}

}  // namespace
}  // namespace cusp::test
