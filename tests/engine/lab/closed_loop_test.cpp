// Sampling, hold, delay, jitter, losses, encoder and motors of the laboratory's loop.
#include "engine/lab/closed_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/engine/lab/bound.h"

namespace cusp::engine::lab {
namespace {

DeviceSettings ideal(double mass_kg = 0.1, double damping = 0.0) {
  DeviceSettings s;
  s.mass_kg = mass_kg;
  s.damping_ns_per_m = damping;
  s.encoder_step_mm = 0.0;
  s.force_quantum_n = 0.0;
  return s;
}

TransportSettings delayed(double delay_ms, double jitter_ms = 0.0, double lost = 0.0, std::uint64_t seed = 1) {
  return {delay_ms, jitter_ms, lost, seed};
}

const auto kNothing = [](const Reading&) { return Vec3(0.0); };

TEST(ClosedLoop, holds_the_answer_to_a_sample_until_the_next) {
  ClosedLoop loop(ideal(), {}, kNoGrip, Vec3(0.0));
  // 1 N in the first tick, nothing after: 0.1 kg reaches 10 mm/s in 1 ms and keeps it.
  int n = 0;
  const auto controller = [&](const Reading&) { return n++ == 0 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0); };
  const LoopTick first = loop.tick(controller);
  EXPECT_EQ(first.answers, 1);
  EXPECT_EQ(first.held_n, Vec3(1.0, 0.0, 0.0));
  EXPECT_NEAR(first.velocity_mm_s.x, 10.0, bound(1e-12));
  EXPECT_NEAR(first.to_mm.x, 0.005, bound(1e-15));
  EXPECT_NEAR(first.energy_mj, 0.005, bound(1e-15));  // 1 N over 5 um
  const LoopTick second = loop.tick(controller);
  EXPECT_NEAR(second.to_mm.x, 0.015, bound(1e-15));
  EXPECT_EQ(second.energy_mj, 0.0);
}

TEST(ClosedLoop, a_force_comes_after_the_delay_there_and_back_and_not_before) {
  for (const double delay : {1.0, 2.5, 3.0}) {
    ClosedLoop loop(ideal(), delayed(delay), kNoGrip, Vec3(0.0));
    const auto controller = [](const Reading&) { return Vec3(1.0, 0.0, 0.0); };
    LoopTick tick;
    for (int t = 0; t < 5; ++t) tick = loop.tick(controller);
    // From the first sample at 0: accelerated from the delay on, at 10,000 mm/s2.
    const double t = 5e-3 - delay * 1e-3;
    EXPECT_NEAR(tick.to_mm.x, 5000.0 * t * t, bound(1e-12)) << delay;
    EXPECT_NEAR(tick.velocity_mm_s.x, 10000.0 * t, bound(1e-11)) << delay;
  }
}

TEST(ClosedLoop, an_encoder_reads_steps_that_begin_at_its_phase) {
  DeviceSettings s = ideal();
  s.encoder_step_mm = 0.05;
  for (const double phase : {0.0, 0.3}) {
    ClosedLoop loop(s, {}, kNoGrip, Vec3(0.0), Vec3(phase));
    double most = 0.0;
    std::vector<std::int32_t> seen;
    for (int i = 0; i < 400; ++i) {
      const double at = -0.1 + i * 0.0005;
      loop.plant().place(Vec3(at), Vec3(0.0));
      loop.tick([&](const Reading& r) {
        most = std::max(most, std::fabs(r.position_mm().x - at));
        if (seen.empty() || seen.back() != r.x) seen.push_back(r.x);
        return Vec3(0.0);
      });
    }
    EXPECT_LE(most, 0.025 + 0.00005 + 1e-12);  // half a step, and rounding to 0.1 um
    for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_EQ(seen[i] - seen[i - 1], 500);
    EXPECT_EQ(((seen.back() + static_cast<int>(phase * 500) - 250) % 500 + 500) % 500, 0);
  }
}

TEST(ClosedLoop, motors_give_multiples_of_their_quantum_and_no_more_than_their_limit_in_the_same_direction) {
  DeviceSettings s = ideal();
  s.force_quantum_n = 0.004;
  s.limit_n = 6.0;
  ClosedLoop loop(s, {}, kFirmGrip, Vec3(0.0));
  LoopTick tick = loop.tick([](const Reading&) { return Vec3(0.0101, -0.0019, 0.0021); });
  EXPECT_NEAR(tick.held_n.x, 0.012, 1e-15);
  EXPECT_NEAR(tick.held_n.y, 0.0, 1e-15);
  EXPECT_NEAR(tick.held_n.z, 0.004, 1e-15);
  EXPECT_FALSE(tick.over_limit);
  tick = loop.tick([](const Reading&) { return Vec3(30.0, 40.0, 0.0); });
  EXPECT_TRUE(tick.over_limit);
  EXPECT_NEAR(tick.held_n.x, 3.6, 0.002 + 1e-12);
  EXPECT_NEAR(tick.held_n.y, 4.8, 0.002 + 1e-12);
}

TEST(ClosedLoop, an_answer_that_is_no_number_holds_nothing_and_counts_as_over_the_limit) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ClosedLoop loop(ideal(), {}, kNoGrip, Vec3(0.0));
    const LoopTick tick = loop.tick([&](const Reading&) { return Vec3(0.0, bad, 1.0); });
    EXPECT_EQ(tick.held_n, Vec3(0.0));
    EXPECT_TRUE(tick.over_limit);
  }
}

struct Trace {
  std::vector<std::uint32_t> elapsed;
  std::vector<double> x;
  int answers = 0;
  bool ordered = true;
};

Trace trace(const TransportSettings& transport, int ticks) {
  Trace out;
  DeviceSettings device = ideal(0.1, 2.0);
  device.limit_n = 1e6;
  ClosedLoop loop(device, transport, kNoGrip, Vec3(0.0));
  loop.plant().drive(Vec3(10.0, 0.0, 0.0));
  std::int32_t last = -1;
  for (int t = 0; t < ticks; ++t) {
    const LoopTick tick = loop.tick([&](const Reading& r) {
      out.elapsed.push_back(r.elapsed_us);
      out.ordered = out.ordered && r.x > last;
      last = r.x;
      return Vec3(r.position_mm());
    });
    out.answers += tick.answers;
    out.x.push_back(tick.held_n.x);
  }
  return out;
}

TEST(ClosedLoop, jitter_moves_readings_about_but_keeps_their_order_and_their_time) {
  const Trace t = trace(delayed(1.0, 3.0), 5000);
  EXPECT_TRUE(t.ordered);
  std::uint32_t least = 1000000, most = 0;
  double sum = 0.0;
  for (const std::uint32_t e : t.elapsed) {
    least = std::min(least, e);
    most = std::max(most, e);
    sum += e;
  }
  // One way takes 0.5 to 2 ms: two readings arrive up to 2.5 ms apart. All time is accounted for.
  EXPECT_LT(least, 500u);
  EXPECT_GT(most, 1500u);
  EXPECT_LE(most, 2500u);
  EXPECT_NEAR(sum, 5000e3, 3000.0);
}

TEST(ClosedLoop, lost_packets_are_missing_and_the_next_reading_spans_them) {
  const int ticks = 20000;
  const double share = 0.2;
  const Trace t = trace(delayed(0.0, 0.0, share), ticks);
  // Half of the losses are on the way up: binomial, five standard deviations.
  const double lost = 0.5 * share * ticks;
  EXPECT_NEAR(ticks - t.answers, lost, 5.0 * std::sqrt(lost * (1.0 - 0.5 * share)));
  double sum = 0.0;
  int doubles = 0;
  for (const std::uint32_t e : t.elapsed) {
    EXPECT_EQ(e % 1000, 0u);
    doubles += e == 2000 ? 1 : 0;
    sum += e;
  }
  EXPECT_GT(doubles, 1000);
  EXPECT_NEAR(sum, ticks * 1e3, 10e3);
  // The other half on the way down: the force stays what it was.
  int held = 0;
  for (std::size_t i = 1; i < t.x.size(); ++i) held += t.x[i] == t.x[i - 1] ? 1 : 0;
  const double both = (1.0 - (1.0 - 0.5 * share) * (1.0 - 0.5 * share)) * ticks;
  EXPECT_NEAR(held, both, 5.0 * std::sqrt(both));
}

TEST(ClosedLoop, the_same_seed_gives_the_same_run_and_another_seed_another) {
  const Trace a = trace(delayed(1.0, 2.0, 0.1, 7), 3000), b = trace(delayed(1.0, 2.0, 0.1, 7), 3000);
  EXPECT_EQ(a.elapsed, b.elapsed);
  EXPECT_EQ(a.x, b.x);
  EXPECT_NE(a.elapsed, trace(delayed(1.0, 2.0, 0.1, 8), 3000).elapsed);
}

TEST(ClosedLoop, a_host_that_wakes_late_meets_the_newest_reading_and_the_time_it_slept) {
  ClosedLoop loop(ideal(), {}, kNoGrip, Vec3(0.0));
  loop.plant().drive(Vec3(100.0, 0.0, 0.0));
  loop.tick(kNothing);
  loop.stall_ms(30.0);
  for (int t = 0; t < 30; ++t) EXPECT_EQ(loop.tick(kNothing).answers, 0) << t;
  std::vector<Reading> met;
  loop.tick([&](const Reading& r) {
    met.push_back(r);
    return Vec3(0.0);
  });
  ASSERT_EQ(met.size(), 1u);
  EXPECT_EQ(met[0].elapsed_us, 31000u);
  EXPECT_EQ(met[0].x, 31000);  // 3.1 mm
}

TEST(ClosedLoop, a_cable_that_is_out_leaves_no_force_and_no_reading) {
  ClosedLoop loop(ideal(), delayed(3.0), kFirmGrip, Vec3(0.0));
  const auto controller = [](const Reading&) { return Vec3(1.0, 0.0, 0.0); };
  for (int t = 0; t < 10; ++t) loop.tick(controller);
  EXPECT_EQ(loop.held_n(), Vec3(1.0, 0.0, 0.0));
  loop.unplug();
  for (int t = 0; t < 10; ++t) {
    const LoopTick tick = loop.tick(controller);
    EXPECT_EQ(tick.answers, 0);
    EXPECT_EQ(tick.held_n, Vec3(0.0));
  }
  loop.plug_in();
  int answers = 0;
  for (int t = 0; t < 10; ++t) answers += loop.tick(controller).answers;
  EXPECT_GE(answers, 8);
}

TEST(ClosedLoop, what_the_held_force_gives_is_what_the_mass_gets) {
  // No damping, no hand: all energy is kinetic. With jitter and losses besides.
  ClosedLoop loop(ideal(0.2), delayed(1.0, 2.0, 0.1), kNoGrip, Vec3(1.0, 0.5, -0.3));
  double given = 0.0;
  for (int t = 0; t < 500; ++t) {
    const LoopTick tick = loop.tick([](const Reading& r) { return -0.3 * r.position_mm(); });
    given += tick.energy_mj;
    ASSERT_NEAR(given, loop.plant().kinetic_mj(), bound(1e-9)) << t;
  }
  EXPECT_GT(given, 0.01);
}

}  // namespace
}  // namespace cusp::engine::lab
