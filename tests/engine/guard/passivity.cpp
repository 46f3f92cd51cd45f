// The passivity controller in the laboratory's closed loop, on a flat wall: the energy that it lets through, and the
// forces that it does not change. Plain walls: the controller does not depend on the method.
#include "engine/step/passivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "engine/step/guard.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A wall below z = 0 behind a guard.
class Wall {
 public:
  Wall(double k_n_per_mm, const GuardSettings& settings) : k_(k_n_per_mm), settings_(settings) {}
  Vec3 operator()(const lab::Reading& reading) {
    const Vec3 device = reading.position_mm();
    GuardTick tick;
    tick.device_mm = device;
    tick.proxy_mm = Vec3(device.x, device.y, std::max(device.z, 0.0));
    tick.contact = device.z < 0.0;
    tick.stiffness_n_per_mm = tick.contact ? k_ : 0.0;
    tick.raw_n = (tick.proxy_mm - device) * k_;
    tick.dt_ms = reading.elapsed_us * 1e-3;
    const Vec3 out = guarded(settings_, state_, tick, any_ ? device - last_ : Vec3(0.0), acts_);
    last_ = device;
    any_ = true;
    return out;
  }
  double scale() const { return state_.passivity.scale; }
  std::uint16_t acts() const { return acts_; }

 private:
  double k_;
  GuardSettings settings_;
  GuardState state_;
  Vec3 last_{0.0};
  bool any_ = false;
  std::uint16_t acts_ = 0;
};

struct Ring {
  double energy_mj = 0.0, peak_to_peak_mm = 0.0;
};

/// A hand holds still where it would press with 1 N; the device begins at rest on the wall and is released.
Ring held_still(double k_n_per_mm, const lab::Grip& grip, double delay_ms, double damping,
                const GuardSettings& settings) {
  const lab::DeviceSettings device = lab::falcon({.damping_ns_per_m = damping});
  lab::TransportSettings transport;
  transport.delay_ms = delay_ms;
  const Vec3 start(0.0, 0.0, 0.05);
  lab::ClosedLoop loop(device, transport, grip, start, Vec3(0.3));
  Wall wall(k_n_per_mm, settings);
  loop.plant().intend(Vec3(0.0, 0.0, -1.0 / k_n_per_mm - 1.0 / grip.stiffness_n_per_mm), Vec3(0.0));
  lab::ContactEnergy energy;
  lab::Steadiness steady;
  for (int k = 0; k < 2000; ++k) {
    const lab::LoopTick tick = loop.tick(wall);
    energy.add(tick);
    steady.add(tick, k >= 1200 ? lab::Steadiness::Part::in_window : lab::Steadiness::Part::before_window);
  }
  return {energy.most_mj(), steady.peak_to_peak_mm()};
}

GuardSettings settings_for(double delay_ms) {
  GuardSettings settings;
  settings.ramp_in_ms = 0.0;
  settings.limit_n = 6.1;
  settings.delay_ms = delay_ms;
  return settings;
}

TEST(HandThatHoldsStill, is_fed_no_more_than_a_twentieth_of_a_millijoule) {
  double most = 0.0, most_off = 0.0;
  for (const lab::Grip& grip : {lab::kSoftGrip, lab::kFirmGrip})
    for (const double delay_ms : {0.0, 1.0, 3.0})
      for (const double damping : {0.5, 2.0, 5.0})
        for (const double k : {0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
          const Ring on = held_still(k, grip, delay_ms, damping, settings_for(delay_ms));
          EXPECT_LE(on.energy_mj, 0.05) << "K " << k << " delay " << delay_ms << " b " << damping << " grip "
                                        << grip.stiffness_n_per_mm;
          most = std::max(most, on.energy_mj);
          const GuardSettings off = settings_for(delay_ms).without(GuardPart::passivity);
          most_off = std::max(most_off, held_still(k, grip, delay_ms, damping, off).energy_mj);
        }
  RecordProperty("most_mj", std::to_string(most));
  RecordProperty("most_without_mj", std::to_string(most_off));
  std::printf("most with the controller %.4f mJ, without it %.2f mJ\n", most, most_off);
  EXPECT_GT(most_off, 1.0) << "without the controller these loops ring: else this test proves nothing";
}

TEST(UnguardedLoop, rings_with_three_milliseconds_of_delay_and_the_guarded_one_does_not) {
  const Ring off = held_still(1.5, lab::kSoftGrip, 3.0, 0.5, unguarded());
  EXPECT_GT(off.peak_to_peak_mm, 1.0) << "it rings by literature and eigenvalues";
  const Ring on = held_still(1.5, lab::kSoftGrip, 3.0, 0.5, settings_for(3.0));
  EXPECT_LT(on.peak_to_peak_mm, 0.1) << "two encoder steps";
}

lab::Reading reading_at(double z_mm) {
  lab::Reading reading;
  reading.z = 500 * static_cast<int>(std::floor(z_mm / 0.05));  // encoder steps of 0.05 mm
  return reading;
}

TEST(Controller, leaves_a_hand_that_comes_and_presses_the_exact_spring) {
  // What an encoder's steps seem to cost lies within the margin up to about 0.8 mm; a deeper press, one percent or two.
  for (const double mm_s : {5.0, 20.0}) {
    Wall wall(1.0, settings_for(0.0));
    for (int k = 0; k < 3000; ++k) {
      const lab::Reading reading = reading_at(std::max(0.2 - mm_s * 1e-3 * k, -1.5));
      const double exact = reading.z < 0 ? -reading.position_mm().z : 0.0;
      const Vec3 force = wall(reading);
      if (exact < 0.8) {
        ASSERT_EQ(force.z, exact) << k;
        ASSERT_EQ(wall.acts(), 0) << k;
      }
      ASSERT_NEAR(force.z, exact, 0.02 * exact) << k;
    }
  }
}

TEST(Controller, costs_a_hand_that_goes_in_and_out_little) {
  Wall wall(1.0, settings_for(0.0));
  double least = 1.0;
  for (int k = 0; k < 4000; ++k) {
    // In and out at 10 mm/s, 0.5 to 1.5 mm deep, without ever leaving: read in encoder steps, each of which a held
    // force pays for.
    wall(reading_at(k < 150 ? -0.01 * k : -1.0 - 0.005 * std::abs(100 - (k - 150) % 200)));
    least = std::min(least, wall.scale());
  }
  EXPECT_GE(least, 0.8) << "measured: 0.867 after twenty times";
}

TEST(Controller, takes_the_tremor_of_a_resting_hand_for_no_ringing) {
  Wall wall(1.0, settings_for(0.0));
  double least = 1.0;
  for (int k = 0; k < 10'000; ++k) {
    // 1 N, and 9 Hz of 0.04 mm to and fro across the edge of an encoder step.
    wall(reading_at(k < 100 ? -0.01 * k : -1.0 + 0.02 * std::sin(2.0 * 3.14159265 * 9.0 * k * 1e-3)));
    least = std::min(least, wall.scale());
  }
  EXPECT_GE(least, 0.95) << "measured: 0.982";
}

TEST(Controller, gives_never_more_than_the_method) {
  GuardSettings settings = settings_for(2.0);
  GuardState state;
  std::uint64_t dice = 1;
  for (int k = 0; k < 20'000; ++k) {
    dice = dice * 6364136223846793005ull + 1442695040888963407ull;
    const double z = -2.0 + 4.0 * static_cast<double>(dice >> 40) / 16777216.0;
    GuardTick tick;
    tick.device_mm = Vec3(0.0, 0.0, z);
    tick.contact = z < 0.0;
    tick.proxy_mm = Vec3(0.0, 0.0, std::max(z, 0.0));
    tick.stiffness_n_per_mm = tick.contact ? 2.0 : 0.0;
    tick.raw_n = (tick.proxy_mm - tick.device_mm) * 2.0;
    const Vec3 force = passive(settings, state.passivity, tick);
    hold(state.passivity, force, tick.proxy_mm - tick.device_mm);
    ASSERT_TRUE(force.z >= 0.0 && force.z <= tick.raw_n.z + 1e-12) << k;
  }
}

TEST(Controller, lets_a_stiffer_tissue_be_felt_at_once) {
  GuardSettings settings = settings_for(0.0);
  PassivityState state;
  GuardTick tick;
  tick.device_mm = Vec3(0.0, 0.0, -1.0);
  tick.contact = true;
  for (int k = 0; k < 200; ++k) {
    tick.stiffness_n_per_mm = k < 100 ? 1.0 : 2.0;
    tick.device_mm.z = -0.01 * std::min(k, 100);
    tick.raw_n = Vec3(0.0, 0.0, -tick.device_mm.z * tick.stiffness_n_per_mm);
    const Vec3 force = passive(settings, state, tick);
    hold(state, force, tick.proxy_mm - tick.device_mm);
    ASSERT_EQ(force, tick.raw_n) << k;
  }
}

}  // namespace
}  // namespace cusp::test
