// Each measure on motions whose answer is known.
#include "engine/lab/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cusp::engine::lab {
namespace {

TEST(ContactEnergy, is_the_largest_running_sum_of_an_episode) {
  ContactEnergy e;
  for (const double mj : {-0.3, 0.5, 0.1, -0.4}) e.add(ContactEnergy::Share{true, mj});
  EXPECT_NEAR(e.most_mj(), 0.3, 1e-15);
  EXPECT_NEAR(e.sum_mj(), -0.1, 1e-15);
  EXPECT_EQ(e.episodes(), 1);
}

TEST(ContactEnergy, of_a_spring_that_is_pressed_and_released_is_nothing) {
  ContactEnergy e;
  double x = 0.0, sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double next = std::sin((i + 1) * 3.14159265358979 / 200.0);
    const double given = 0.5 * (x * x - next * next);  // of a continuous spring of 1 N/mm
    e.add(ContactEnergy::Share{true, given});
    sum += given;
    x = next;
  }
  EXPECT_NEAR(e.most_mj(), 0.0, 1e-12);
  EXPECT_NEAR(sum, 0.0, 1e-12);
}

TEST(ContactEnergy, joins_gaps_under_twenty_milliseconds_and_no_longer_ones) {
  for (const int gap : {19, 20}) {
    ContactEnergy e;
    e.add(ContactEnergy::Share{true, 0.2});
    for (int i = 0; i < gap; ++i) e.add(ContactEnergy::Share{false, 0.0});
    e.add(ContactEnergy::Share{true, 0.2});
    EXPECT_NEAR(e.most_mj(), gap < 20 ? 0.4 : 0.2, 1e-15) << gap;
    EXPECT_EQ(e.episodes(), gap < 20 ? 1 : 2);
  }
}

constexpr Steadiness::Part kInWindow = Steadiness::Part::in_window;

LoopTick tick_at(Vec3 from, Vec3 to, Vec3 held) {
  LoopTick t;
  t.from_mm = from;
  t.to_mm = to;
  t.held_n = t.mean_n = held;
  t.energy_mj = glm::dot(held, to - from);
  return t;
}

Steadiness sine(double amplitude_mm, double hz, Vec3 direction) {
  Steadiness s(Vec3(0, 0, 1), Vec3(1, 0, 0));
  const auto at = [&](int i) { return direction * (amplitude_mm * std::sin(6.283185307179586 * hz * i * 1e-3 + 0.3)); };
  for (int i = 0; i < 800; ++i) s.add(tick_at(at(i), at(i + 1), Vec3(0.0)), kInWindow);
  return s;
}

TEST(Steadiness, knows_the_size_and_frequency_of_a_vibration) {
  for (const double hz : {5.0, 27.0, 110.0}) {
    const Steadiness s = sine(0.07, hz, Vec3(0, 0, 1));
    EXPECT_NEAR(s.peak_to_peak_mm(), 0.14, 0.14 * 0.03) << hz;  // 9 samples in a period of 110 Hz
    EXPECT_NEAR(s.cycle_hz(), hz, 0.02 * hz) << hz;
  }
}

TEST(Steadiness, allows_two_encoder_steps_and_not_more) {
  using Verdict = Steadiness::Verdict;
  EXPECT_EQ(sine(0.0499, 20.0, Vec3(0, 0, 1)).verdict(0.05), Verdict::steady);
  EXPECT_EQ(sine(0.0506, 20.0, Vec3(0, 0, 1)).verdict(0.05), Verdict::moves);
  EXPECT_EQ(sine(0.0506, 20.0, Vec3(0, 1, 0)).verdict(0.05), Verdict::moves);  // sideways as well
}

TEST(Steadiness, counts_what_a_wall_gives_to_a_vibration_and_not_what_a_drift_takes_with_it) {
  Steadiness drift(Vec3(0, 0, 1), Vec3(1, 0, 0)), fed = drift;
  for (int i = 0; i < 800; ++i)
    drift.add(tick_at(Vec3(0, 0, i * 5e-5), Vec3(0, 0, (i + 1) * 5e-5), Vec3(0, 0, 1)), kInWindow);
  EXPECT_NEAR(drift.energy_mj(), 0.0, 1e-12);  // 1 N over 40 um: 0.04 mJ, as a spring would
  EXPECT_EQ(drift.verdict(0.05), Steadiness::Verdict::steady);
  // 1 N out, 0.9 N in, 10 um each time: 1 uJ a stroke, 20 strokes.
  for (int i = 0; i < 800; ++i) {
    const bool out = i / 20 % 2 == 0;
    const double a = i % 20 * 5e-4, b = a + 5e-4;
    fed.add(out ? tick_at(Vec3(0, 0, a), Vec3(0, 0, b), Vec3(0, 0, 1))
                : tick_at(Vec3(0, 0, 0.01 - a), Vec3(0, 0, 0.01 - b), Vec3(0, 0, 0.9)),
            kInWindow);
  }
  EXPECT_NEAR(fed.energy_mj(), 0.02, 1e-12);
  EXPECT_EQ(fed.verdict(0.05), Steadiness::Verdict::feeds);
}

TEST(Steadiness, a_force_past_the_limit_counts_at_any_time) {
  Steadiness s;
  LoopTick t;
  t.over_limit = true;
  s.add(t, Steadiness::Part::before_window);
  t.over_limit = false;
  for (int i = 0; i < 800; ++i) s.add(t, kInWindow);
  EXPECT_EQ(s.verdict(0.05), Steadiness::Verdict::over_limit);
}

TEST(Steadiness, what_is_no_number_is_not_steady) {
  Steadiness s;
  LoopTick t;
  t.energy_mj = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 800; ++i) s.add(t, kInWindow);
  EXPECT_NE(s.verdict(0.05), Steadiness::Verdict::steady);
}

TEST(StuckWatch, sees_a_proxy_that_stays_where_the_exact_one_would_go) {
  StuckWatch w;
  int ms = 0;
  for (; ms < 200; ++ms) w.add(Vec3(ms * 0.01, 0, 0), Vec3(ms * 0.01, 0, 0));
  EXPECT_FALSE(w.stuck());
  for (; ms < 300; ++ms) w.add(Vec3(ms * 0.01, 0, 0), Vec3(1.99, 0, 0));
  for (; ms < 400; ++ms) w.add(Vec3(ms * 0.01, 0, 0), Vec3(ms * 0.01, 0, 0));
  // It stood still for 100 ms; the first 45 ms of it lack a tenth of 0.5 mm still, and so do the last.
  EXPECT_TRUE(w.stuck());
  EXPECT_NEAR(w.stuck_ms(), 100, 10);
}

TEST(StuckWatch, lets_a_proxy_lag_that_moves) {
  StuckWatch w;
  for (int ms = 0; ms < 500; ++ms) w.add(Vec3(ms * 0.01, 0, 0), Vec3(ms * 0.0015, 0, 0));
  EXPECT_FALSE(w.stuck());
}

TEST(StuckWatch, asks_nothing_where_the_exact_proxy_stays) {
  StuckWatch w;
  for (int ms = 0; ms < 500; ++ms) w.add(Vec3(ms * 0.0015, 0, 0), Vec3(0.0));
  EXPECT_FALSE(w.stuck());
}

TEST(Rise, is_the_push_in_a_change_and_not_the_release) {
  const Vec3 f(0.0, 0.0, 1.0);
  EXPECT_NEAR(rise_n(f, Vec3(0, 0, 1.2)), 0.2, 1e-15);
  EXPECT_NEAR(rise_n(f, Vec3(0, 0, 0.2)), 0.0, 1e-15);
  EXPECT_NEAR(rise_n(f, Vec3(0.0)), 0.0, 1e-15);
  EXPECT_NEAR(rise_n(f, Vec3(0.3, 0, 0.2)), 0.3, 1e-15);  // falls, and pushes sideways
  EXPECT_NEAR(rise_n(f, Vec3(0, 0, -0.4)), 0.4, 1e-15);   // falls to zero, then pushes back
  EXPECT_NEAR(rise_n(Vec3(0.0), f), 1.0, 1e-15);
}

TEST(ForceSteps, leave_out_first_contact_and_keep_the_guards_apart) {
  ForceSteps s;
  const Vec3 none(0.0);
  const auto up = [](double n) { return Vec3(0, 0, n); };
  EXPECT_FALSE(s.add({none, none, false}).has_value());
  EXPECT_FALSE(s.add({up(0.5), up(0.5), false}).has_value());  // first contact
  const auto first = s.add({up(0.53), up(0.51), false});
  ASSERT_TRUE(first.has_value());
  EXPECT_NEAR(*first, 20.0, 1e-9);
  EXPECT_FALSE(s.add({up(0.73), up(0.52), true}).has_value());
  EXPECT_NEAR(s.guard_step_mn(), 200.0, 1e-9);
  EXPECT_NEAR(*s.add({up(0.2), up(0.53), false}), -10.0, 1e-9);  // falls: no rise, the exact one's 10 mN taken off
  EXPECT_NEAR(s.force_step_mn(), 20.0, 1e-9);
  s.interrupt();
  EXPECT_FALSE(s.add({up(5.0), up(0.5), false}).has_value());
}

TEST(ForceSteps, count_a_force_that_fails_for_a_tick_and_comes_back) {
  const Vec3 none(0.0), half(0.0, 0.0, 0.5);
  ForceSteps s;
  s.add({none, none, false});
  s.add({half, half, false});
  EXPECT_NEAR(*s.add({none, half, false}), 0.0, 1e-9);    // falls
  EXPECT_NEAR(*s.add({half, half, false}), 500.0, 1e-9);  // and kicks
  EXPECT_NEAR(s.force_step_mn(), 500.0, 1e-9);
  // After 20 ms, or after a tick without the exact proxy's contact, it is a first contact again.
  ForceSteps late, both;
  late.add({half, half, false});
  for (int i = 0; i < ForceSteps::kGapMs; ++i) late.add({none, half, false});
  EXPECT_FALSE(late.add({half, half, false}).has_value());
  both.add({half, half, false});
  both.add({none, none, false});
  both.add({none, half, false});
  EXPECT_FALSE(both.add({half, half, false}).has_value());
}

TEST(Penetration, keeps_the_deepest_and_counts_what_is_no_number) {
  Penetration p;
  for (const double clearance : {0.1, -0.004, -0.002}) p.add(clearance);
  EXPECT_NEAR(p.most_um(), 4.0, 1e-12);
  p.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isnan(p.most_um()));
}

}  // namespace
}  // namespace cusp::engine::lab
