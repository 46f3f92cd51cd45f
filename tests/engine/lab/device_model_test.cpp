// The plant against mechanics in closed form. Units: N, mm, s; kg = 1e-3 N s2/mm.
#include "engine/lab/device_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/lab/transport.h"
#include "tests/engine/lab/bound.h"

namespace cusp::engine::lab {
namespace {

DeviceSettings device(double mass_kg, double damping, double friction) {
  DeviceSettings s;
  s.mass_kg = mass_kg;
  s.damping_ns_per_m = damping;
  s.friction_n = friction;
  return s;
}

void run(Plant& plant, Vec3 force, int ticks) {
  for (int i = 0; i < ticks; ++i) plant.advance(force, kSlicesPerTick);
}

TEST(Plant, a_free_mass_slows_down_exponentially) {
  Plant plant(device(0.1, 2.0, 0.0), kNoGrip, Vec3(0.0));
  plant.place(Vec3(0.0), Vec3(50.0, -20.0, 10.0));
  run(plant, Vec3(0.0), 100);
  // v = v0 exp(-b t / m), x = v0 m / b (1 - exp(-b t / m)); b / m = 20 / s, t = 0.1 s.
  const double left = std::exp(-2.0);
  for (int a = 0; a < 3; ++a) {
    const double v0 = a == 0 ? 50.0 : a == 1 ? -20.0 : 10.0;
    EXPECT_NEAR(plant.velocity_mm_s()[a], v0 * left, bound(1e-10));               // measured 4e-14
    EXPECT_NEAR(plant.position_mm()[a], v0 / 20.0 * (1.0 - left), bound(1e-11));  // measured 3e-15
  }
}

TEST(Plant, a_constant_force_accelerates_an_undamped_mass_evenly) {
  Plant plant(device(0.25, 0.0, 0.0), kNoGrip, Vec3(1.0));
  run(plant, Vec3(0.5, 0.0, 0.0), 200);
  // a = 0.5 N / 0.25 kg = 2000 mm/s2, t = 0.2 s.
  EXPECT_NEAR(plant.velocity_mm_s().x, 400.0, bound(1e-9));
  EXPECT_NEAR(plant.position_mm().x, 41.0, bound(1e-10));
  EXPECT_EQ(plant.position_mm().y, 1.0);
}

TEST(Plant, a_grip_rings_at_its_own_frequency_and_damping) {
  // 0.15 N/mm on 0.1 + 0.1 kg, damped by 0.5 + 2 N s/m: d = 6.25 / s, w = sqrt(750 - d2).
  Plant plant(device(0.1, 0.5, 0.0), kSoftGrip, Vec3(0.0));
  plant.place(Vec3(1.0, 0.0, 0.0), Vec3(0.0));
  run(plant, Vec3(0.0), 300);
  const double d = 2.5 / (2.0 * 0.2), w = std::sqrt(150.0 / 0.2 - d * d), t = 0.3;
  EXPECT_NEAR(plant.position_mm().x, std::exp(-d * t) * (std::cos(w * t) + d / w * std::sin(w * t)), bound(1e-12));
}

TEST(Plant, a_grip_that_moves_evenly_drags_the_device_behind_by_damping_times_speed_over_grip) {
  Plant plant(device(0.1, 2.0, 0.0), kFirmGrip, Vec3(0.0));
  plant.intend(Vec3(0.0), Vec3(50.0, 0.0, 0.0));
  run(plant, Vec3(0.0), 3000);
  // 2 N s/m at 0.05 m/s is 0.1 N; on 0.7 N/mm.
  EXPECT_NEAR(plant.intended_mm().x, 150.0, bound(1e-9));
  EXPECT_NEAR(plant.intended_mm().x - plant.position_mm().x, 0.1 / 0.7, bound(1e-10));
  EXPECT_NEAR(plant.velocity_mm_s().x, 50.0, bound(1e-9));
}

TEST(Plant, weight_and_push_move_it_as_forces_do) {
  DeviceSettings heavy = device(0.1, 0.0, 0.0);
  heavy.weight_n = Vec3(0.0, 0.0, -0.4);
  Plant plant(heavy, kFirmGrip, Vec3(0.0));
  plant.push(Vec3(0.0, 0.0, -0.3));
  run(plant, Vec3(0.0), 5000);
  EXPECT_NEAR(plant.position_mm().z, -1.0, bound(1e-12));  // 0.7 N on 0.7 N/mm
}

TEST(Plant, one_step_of_twenty_slices_is_twenty_steps_of_one) {
  Plant a(device(0.1, 5.0, 0.0), kFirmGrip, Vec3(0.0)), b = a;
  for (Plant* p : {&a, &b}) p->intend(Vec3(1.0, 0.0, 0.0), Vec3(0.0, 30.0, 0.0));
  for (int t = 0; t < 200; ++t) {
    a.advance(Vec3(0.1, 0.2, -0.3), kSlicesPerTick);
    for (int i = 0; i < kSlicesPerTick; ++i) b.advance(Vec3(0.1, 0.2, -0.3), 1);
  }
  EXPECT_LE(glm::length(a.position_mm() - b.position_mm()), bound(1e-11));  // measured 8e-14
}

TEST(Plant, what_friction_can_hold_does_not_creep) {
  Plant plant(device(0.1, 0.5, 0.1), kNoGrip, Vec3(0.3, 0.2, 0.1));
  run(plant, Vec3(0.06, 0.0, -0.0799), 10000);  // 0.0999 N against 0.1 N, for 10 s
  EXPECT_EQ(plant.position_mm(), Vec3(0.3, 0.2, 0.1));
  EXPECT_TRUE(plant.sticks());
}

TEST(Plant, what_friction_cannot_hold_moves_by_the_rest) {
  Plant plant(device(0.1, 0.0, 0.1), kNoGrip, Vec3(0.0));
  run(plant, Vec3(0.0, 0.15, 0.0), 100);
  // (0.15 - 0.1) N / 0.1 kg = 500 mm/s2 for 0.1 s.
  EXPECT_NEAR(plant.velocity_mm_s().y, 50.0, bound(1e-9));
  EXPECT_NEAR(plant.position_mm().y, 2.5, bound(1e-10));
}

TEST(Plant, a_sliding_mass_stops_where_its_energy_is_used_up) {
  Plant plant(device(0.25, 0.0, 0.1), kNoGrip, Vec3(0.0));
  plant.place(Vec3(0.0), Vec3(30.0, 0.0, 40.0));  // 50 mm/s: 0.3125 mJ
  run(plant, Vec3(0.0), 200);                     // it takes m v / f = 125 ms
  EXPECT_EQ(plant.velocity_mm_s(), Vec3(0.0));
  // m v2 / 2 f = 3.125 mm, straight on. The last slice is not split: 1e-5 of it.
  EXPECT_NEAR(plant.position_mm().x, 0.6 * 3.125, bound(1e-4));
  EXPECT_NEAR(plant.position_mm().z, 0.8 * 3.125, bound(1e-4));
  EXPECT_NEAR(plant.friction_mj(), 0.3125, bound(1e-6));
}

TEST(Plant, a_grip_breaks_friction_where_its_spring_reaches_it) {
  Plant plant(device(0.1, 2.0, 0.1), kSoftGrip, Vec3(0.0));
  plant.intend(Vec3(0.1 / 0.15 - 1e-6, 0.0, 0.0), Vec3(0.0));
  run(plant, Vec3(0.0), 2000);
  EXPECT_EQ(plant.position_mm().x, 0.0);
  plant.intend(Vec3(0.1 / 0.15 + 0.01, 0.0, 0.0), Vec3(0.0));
  run(plant, Vec3(0.0), 2000);
  EXPECT_GT(plant.position_mm().x, 0.0);
}

TEST(Plant, takes_no_more_energy_than_forces_put_in_and_loses_none_unaccounted) {
  // Random forces, slice by slice; the damper's share by the trapezoid rule. Work in = kinetic + friction + damping.
  for (const double friction : {0.0, 0.1}) {
    Plant plant(device(0.1, 2.0, friction), kNoGrip, Vec3(0.0));
    Dice dice(5);
    double work = 0.0, damping = 0.0, gross = 0.0;
    for (int t = 0; t < 2000; ++t) {
      const Vec3 force = Vec3(dice.roll() - 0.5, dice.roll() - 0.5, dice.roll() - 0.5);
      for (int i = 0; i < kSlicesPerTick; ++i) {
        const Vec3 x = plant.position_mm(), v = plant.velocity_mm_s();
        plant.advance(force, 1);
        const Vec3 w = plant.velocity_mm_s();
        const double given = glm::dot(force, plant.position_mm() - x);
        work += given;
        gross += std::fabs(given);
        damping += 2e-3 * kSliceUs * 1e-6 * (glm::dot(v, v) + glm::dot(v, w) + glm::dot(w, w)) / 3.0;
      }
    }
    EXPECT_GT(gross, 1.0);  // mJ
    EXPECT_NEAR(work, plant.kinetic_mj() + plant.friction_mj() + damping, bound(2e-6 * gross)) << friction;
  }
}

TEST(Plant, nothing_moves_along_a_rail_that_holds) {
  const Vec3 a = glm::normalize(Vec3(1.0, 1.0, 0.0)), b = glm::normalize(Vec3(1.0, -1.0, 0.5));
  const Vec3 free = glm::cross(a, glm::normalize(b - a * glm::dot(a, b)));
  for (const double friction : {0.0, 0.1}) {
    Plant plant(device(0.1, 2.0, friction), kNoGrip, Vec3(1.0, 2.0, 3.0));
    plant.rail(a, glm::normalize(b - a * glm::dot(a, b)));
    run(plant, Vec3(1.0, 0.7, -0.4), 100);
    const Vec3 moved = plant.position_mm() - Vec3(1.0, 2.0, 3.0);
    EXPECT_GT(std::fabs(glm::dot(moved, free)), 0.1);
    EXPECT_LE(glm::length(moved - free * glm::dot(moved, free)), 1e-12);
  }
}

TEST(Plant, goes_where_it_is_driven_whatever_pulls) {
  Plant plant(device(0.1, 5.0, 0.1), kFirmGrip, Vec3(0.0));
  plant.drive(Vec3(0.0, 0.0, -50.0));
  run(plant, Vec3(3.0, 3.0, 3.0), 20);
  EXPECT_NEAR(plant.position_mm().z, -1.0, 1e-12);
  EXPECT_EQ(plant.position_mm().x, 0.0);
  plant.release();
  run(plant, Vec3(3.0, 3.0, 3.0), 1);
  EXPECT_GT(plant.position_mm().x, 0.0);
}

TEST(Falcon, figures_are_those_of_its_published_mechanism) {
  // Middle of the workspace: 0.049 mm a count sideways, 16.2 N at 4095 counts along the axis, 6.1 N in the worst
  // direction.
  const DeviceSettings s = falcon({.mass_kg = 0.25, .damping_ns_per_m = 5.0, .friction_n = 0.1});
  EXPECT_NEAR(s.encoder_step_mm, 0.049, 1e-12);
  EXPECT_NEAR(s.force_quantum_n, 0.003956, 1e-6);
  EXPECT_NEAR(s.limit_n, 6.1, 1e-12);
  EXPECT_EQ(s.mass_kg, 0.25);  // not known: whatever is swept
}

}  // namespace
}  // namespace cusp::engine::lab
