// The laboratory against theory: where a sampled wall begins to ring, by its eigenvalues and in the loop itself.
#include "engine/lab/sampled_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "tests/engine/lab/bound.h"

namespace cusp::engine::lab {
namespace {

/// True when a motion in the loop grows from its third second to its fourth.
bool rings(const SampledWall& w) {
  DeviceSettings s;
  s.mass_kg = w.mass_kg;
  s.damping_ns_per_m = w.damping_ns_per_m;
  s.encoder_step_mm = 0.0;
  s.force_quantum_n = 0.0;
  s.limit_n = 1e9;
  TransportSettings transport;
  transport.delay_ms = w.delay_ticks;
  ClosedLoop loop(s, transport, w.grip, Vec3(0.0));
  // From 1 m. A reading is rounded to 0.1 um, and what has come to rest within a few of those is at rest.
  constexpr double kRestMm = 1e-3;
  loop.plant().place(Vec3(1000.0, 0.0, 0.0), Vec3(0.0));
  double before = 1000.0, most[2] = {0.0, 0.0};
  for (int t = 0; t < 4000; ++t) {
    const LoopTick tick = loop.tick([&](const Reading& r) {
      const double x = r.position_mm().x;
      const double f = -w.stiffness_n_per_mm * x - w.virtual_damping_ns_per_m * 1e-3 * (x - before) / w.tick_s;
      before = x;
      return Vec3(f, 0.0, 0.0);
    });
    if (t >= 2000) most[t / 3000] = std::max(most[t / 3000], std::fabs(tick.to_mm.x));
    if (most[0] > 1e5) return true;
  }
  return most[1] > most[0] && most[1] > kRestMm;
}

double measured_k_max(SampledWall w) {
  double low = 0.01, high = 40.0;
  while (high > low * 1.002) {
    w.stiffness_n_per_mm = std::sqrt(low * high);
    (rings(w) ? high : low) = w.stiffness_n_per_mm;
  }
  return low;
}

TEST(SampledWall, rings_in_the_laboratory_where_its_eigenvalues_leave_the_unit_circle) {
  double worst = 0.0;
  for (const double mass : {0.1, 0.25})
    for (const double damping : {0.5, 2.0, 5.0})
      for (const int delay : {0, 1, 3})
        for (const double virtual_damping : {0.0, 0.3}) {
          SampledWall w;
          w.mass_kg = mass;
          w.damping_ns_per_m = damping;
          w.delay_ticks = delay;
          w.virtual_damping_ns_per_m = virtual_damping;
          const double theory = critical_stiffness_n_per_mm(w), seen = measured_k_max(w);
          ASSERT_GT(theory, 0.0);
          worst = std::max(worst, std::fabs(seen / theory - 1.0));
          EXPECT_NEAR(seen / theory, 1.0, bound(0.02))
              << "mass " << mass << " damping " << damping << " delay " << delay << " B " << virtual_damping;
        }
  RecordProperty("worst_share", std::to_string(worst));
}

TEST(SampledWall, rings_in_a_hand_at_the_stiffness_of_its_eigenvalues) {
  for (const Grip& grip : {kSoftGrip, kFirmGrip})
    for (const int delay : {0, 1, 3}) {
      SampledWall w;
      w.grip = grip;
      w.delay_ticks = delay;
      EXPECT_NEAR(measured_k_max(w) / critical_stiffness_n_per_mm(w), 1.0, bound(0.02)) << delay;
    }
}

TEST(SampledWall, without_delay_rings_at_the_stiffness_of_the_jury_test) {
  // z2 + (d1 + K n1) z + d0 + K n0 has its roots inside the circle until d0 + K n0 = 1, with d0 = p = exp(-b T / m),
  // n0 = the product of the hold's gains: K = (1 - p) / n0, n0 = (m (1 - p) - b T p) / b2.
  for (const double mass : {0.1, 0.25})
    for (const double b : {0.5, 2.0, 5.0}) {
      const double T = 0.001, p = std::exp(-b * T / mass);
      const double n0 = (mass * (1.0 - p) - b * T * p) / (b * b);
      SampledWall w;
      w.mass_kg = mass;
      w.damping_ns_per_m = b;
      EXPECT_NEAR(critical_stiffness_n_per_mm(w) / ((1.0 - p) / n0 * 1e-3), 1.0, bound(1e-5));  // measured 1e-6
    }
}

TEST(SampledWall, without_any_damping_rings_at_any_stiffness) {
  SampledWall w;
  w.damping_ns_per_m = 0.0;
  for (const double k : {0.01, 0.1, 1.0}) {
    w.stiffness_n_per_mm = k;
    EXPECT_GT(spectral_radius(w), 1.0 + 1e-6) << k;
  }
  EXPECT_EQ(critical_stiffness_n_per_mm(w), 0.0);
}

TEST(SampledWall, with_next_to_no_wall_keeps_the_plants_own_eigenvalues) {
  SampledWall w;
  w.stiffness_n_per_mm = 0.0;
  w.virtual_damping_ns_per_m = 0.0;
  EXPECT_NEAR(spectral_radius(w), 1.0, 1e-9);  // a free mass stays where it is
  w.grip = kFirmGrip;
  // 0.35 kg, 10 N s/m, 700 N/m: overdamped no, so |z| = exp(-b T / 2 m).
  EXPECT_NEAR(spectral_radius(w), std::exp(-10.0 * 0.001 / 0.7), bound(1e-9));
}

TEST(Colgate, bound_lies_below_where_a_wall_rings_because_it_is_only_sufficient) {
  for (const double mass : {0.1, 0.25})
    for (const double b : {0.5, 2.0, 5.0}) {
      SampledWall w;
      w.mass_kg = mass;
      w.damping_ns_per_m = b;
      const double passive = colgate_bound_n_per_mm({.damping_ns_per_m = b}), rings_at = critical_stiffness_n_per_mm(w);
      EXPECT_LE(passive, rings_at);
      EXPECT_NEAR(passive, b * 2.0, 1e-12);  // 2 b / T: 1 N/mm for each 0.5 N s/m
      w.grip = kFirmGrip;                    // a hand adds damping, which the bound does not count
      EXPECT_LE(2.0 * passive, 2.0 * critical_stiffness_n_per_mm(w));
    }
  EXPECT_NEAR(colgate_bound_n_per_mm({.damping_ns_per_m = 2.0, .virtual_damping_ns_per_m = 0.5}), 3.0, 1e-12);  // b - |B|
  EXPECT_NEAR(colgate_bound_n_per_mm({.damping_ns_per_m = 2.0, .virtual_damping_ns_per_m = -0.5}), 3.0, 1e-12);
  EXPECT_EQ(colgate_bound_n_per_mm({.damping_ns_per_m = 0.5, .virtual_damping_ns_per_m = 2.0}), 0.0);
}

TEST(AbbottOkamura, bound_is_the_lesser_of_damping_and_friction) {
  DeviceSettings device;
  device.encoder_step_mm = 0.05;
  device.damping_ns_per_m = 5.0;
  EXPECT_EQ(abbott_okamura_bound_n_per_mm(device, 0.001), 0.0);  // no friction: it chatters
  device.friction_n = 0.1;
  EXPECT_NEAR(abbott_okamura_bound_n_per_mm(device, 0.001), 4.0, 1e-12);  // 2 x 0.1 N / 0.05 mm
  device.damping_ns_per_m = 0.5;
  EXPECT_NEAR(abbott_okamura_bound_n_per_mm(device, 0.001), 1.0, 1e-12);  // 2 x 0.5 / 0.001 s
  device.encoder_step_mm = 0.0;
  device.damping_ns_per_m = 2.0;
  EXPECT_NEAR(abbott_okamura_bound_n_per_mm(device, 0.001), 4.0, 1e-12);  // no encoder: Colgate's
}

TEST(AbbottOkamura, a_wall_within_the_bound_rests_on_an_encoder_and_one_far_above_it_does_not) {
  DeviceSettings s;
  s.mass_kg = 0.1;
  s.damping_ns_per_m = 5.0;
  s.friction_n = 0.1;
  const double k = abbott_okamura_bound_n_per_mm(s, 0.001);
  const auto peak_to_peak = [&](double stiffness) {
    ClosedLoop loop(s, {}, kNoGrip, Vec3(0.0), Vec3(0.37));
    loop.plant().place(Vec3(0.0), Vec3(-50.0, 0.0, 0.0));
    loop.plant().push(Vec3(-1.0, 0.0, 0.0));
    Steadiness steady(Vec3(1, 0, 0), Vec3(0, 1, 0));
    for (int t = 0; t < 2000; ++t)
      steady.add(
          loop.tick([&](const Reading& r) { return Vec3(std::max(0.0, -stiffness * r.position_mm().x), 0.0, 0.0); }),
          t >= 1200 ? Steadiness::Part::in_window : Steadiness::Part::before_window);
    return steady.peak_to_peak_mm();
  };
  EXPECT_LE(peak_to_peak(k), 1e-9);
  EXPECT_GT(peak_to_peak(4.0 * k), 0.01);
}

}  // namespace
}  // namespace cusp::engine::lab
