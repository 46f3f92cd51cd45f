// The tooth's warmth by itself.
#include "engine/removal/heat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/removal/spindle.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

enum class Coolant : std::uint8_t { off, on };

/// A turbine with a bur of 1 mm under the usual load.
HeatTick usual(Coolant coolant, double push_n = 1.0, double dt_s = 0.001) {
  return {push_n, surface_speed_mm_s(kUnknownRpm, 0.5), coolant == Coolant::on, dt_s};
}

/// Seconds until the event, or -1.
double until_event(HeatState& state, const HeatTick& tick, double most_s) {
  for (int k = 1; k <= most_s / tick.dt_s; ++k)
    if (advance(state, tick)) return k * tick.dt_s;
  return -1.0;
}

TEST(Heat, dry_cutting_under_the_usual_load_comes_to_the_criterion_in_ten_seconds) {
  HeatState state;
  EXPECT_NEAR(until_event(state, usual(Coolant::off), 20.0), 10.0, 0.05);  // dental.md 3.3, [M]
  EXPECT_NEAR(state.rise_k, kPulpCriterionK, 0.001);
}

TEST(Heat, whatever_the_length_of_a_tick) {
  for (const double dt_s : {0.00025, 0.004, 0.05}) {
    HeatState state;
    EXPECT_NEAR(until_event(state, usual(Coolant::off, 1.0, dt_s), 20.0), 10.0, 0.1) << dt_s;
  }
}

TEST(Heat, coolant_keeps_the_tooth_cool_however_long_one_cuts) {
  HeatState state;
  EXPECT_LT(until_event(state, usual(Coolant::on), 600.0), 0.0);
  EXPECT_LT(state.rise_k, 0.5);
}

TEST(Heat, less_push_takes_longer) {
  HeatState light, hard;
  const double slow_s = until_event(light, usual(Coolant::off, 0.5), 60.0),
               fast_s = until_event(hard, usual(Coolant::off, 2.0), 60.0);
  EXPECT_GT(slow_s, 20.0);
  EXPECT_LT(fast_s, 5.0);
  EXPECT_GT(fast_s, 0.0);
}

TEST(Heat, short_dry_touches_with_rests_between_do_not_raise_the_event) {
  HeatState state;
  bool raised = false;
  for (int k = 0; k < 120'000; ++k)
    raised = advance(state, k % 10'000 < 2'000 ? usual(Coolant::off) : usual(Coolant::off, 0.0)) || raised;
  EXPECT_FALSE(raised);
  EXPECT_GT(state.rise_k, 1.0);
}

TEST(Heat, the_event_comes_once_for_each_time_that_the_criterion_is_reached) {
  HeatState state;
  int events = 0;
  for (int k = 0; k < 20'000; ++k) events += advance(state, usual(Coolant::off)) ? 1 : 0;
  EXPECT_EQ(events, 1);
  for (int k = 0; k < 20'000; ++k) events += advance(state, usual(Coolant::on, 0.0)) ? 1 : 0;  // cooled
  EXPECT_EQ(events, 1);
  for (int k = 0; k < 20'000; ++k) events += advance(state, usual(Coolant::off)) ? 1 : 0;
  EXPECT_EQ(events, 2);
}

TEST(Heat, a_tooth_left_alone_cools_by_e_in_thirty_seconds_and_under_coolant_in_five) {
  HeatState dry{5.0, false}, wet{5.0, false};
  for (int k = 0; k < 30'000; ++k) advance(dry, usual(Coolant::off, 0.0));
  for (int k = 0; k < 5'000; ++k) advance(wet, usual(Coolant::on, 0.0));
  EXPECT_NEAR(dry.rise_k, 5.0 * std::exp(-1.0), 0.01);
  EXPECT_NEAR(wet.rise_k, 5.0 * std::exp(-1.0), 0.01);
}

TEST(Heat, values_that_are_no_numbers_warm_nothing_and_leave_a_number) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, -inf, -1.0}) {
    HeatState state{1.0, false};
    advance(state, {bad, 1e4, false, 0.001});
    advance(state, {1.0, bad, false, 0.001});
    advance(state, {1.0, 1e4, false, bad});
    EXPECT_LE(state.rise_k, 1.0) << bad;
    EXPECT_GT(state.rise_k, 0.9) << bad;
  }
  HeatState hot{1.0, false};
  for (int k = 0; k < 1000; ++k) advance(hot, {inf, inf, false, inf});
  EXPECT_LE(hot.rise_k, 1000.0);
}

}  // namespace
}  // namespace cusp::test
