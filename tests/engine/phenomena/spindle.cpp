// The spindle by itself. Expected speeds are the straight line of spindle.h, computed here.
#include "engine/removal/spindle.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cusp::test {
namespace {

constexpr double kTickS = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr SpindleSettings kTurbine = settings_of(Handpiece::turbine);
constexpr SpindleSettings kElectric = settings_of(Handpiece::electric);
constexpr SpindleSettings kSlow = settings_of(Handpiece::slow);

SpindleState after(const SpindleSettings& settings, double pedal, double push_n, double seconds,
                   SpindleState state = {}, double radius_mm = kStallRadiusMm) {
  for (int k = 0; k < seconds / kTickS; ++k) advance(state, settings, pedal, push_n, radius_mm, kTickS);
  return state;
}

TEST(Spindle, a_turbine_runs_up_to_350000_a_minute_when_the_pedal_is_down_and_nothing_is_touched) {
  EXPECT_NEAR(after(kTurbine, 1.0, 0.0, 3.0).rpm, 350e3, 30.0);  // e^-10 is left
}

TEST(Spindle, a_turbine_keeps_sixty_per_cent_under_the_usual_load) {
  EXPECT_NEAR(after(kTurbine, 1.0, 1.0, 3.0).rpm, 0.6 * 350e3, 30.0);
}

TEST(Spindle, a_turbine_stalls_under_load_and_stays_so_until_the_load_is_halved) {
  SpindleState state = after(kTurbine, 1.0, 2.6, 2.0, after(kTurbine, 1.0, 0.0, 2.0));
  EXPECT_TRUE(state.stalled);
  EXPECT_EQ(state.rpm, 0.0);
  state = after(kTurbine, 1.0, 1.3, 1.0, state);  // 1.25 N is half
  EXPECT_TRUE(state.stalled);
  EXPECT_EQ(state.rpm, 0.0);
  state = after(kTurbine, 1.0, 1.2, 3.0, state);
  EXPECT_FALSE(state.stalled);
  EXPECT_NEAR(state.rpm, (1.0 - 1.2 / 2.5) * 350e3, 30.0);
}

TEST(Spindle, a_short_blow_beyond_the_stall_only_slows_it) {
  const SpindleState state = after(kTurbine, 1.0, 4.0, 0.05, after(kTurbine, 1.0, 0.0, 2.0));
  EXPECT_FALSE(state.stalled);
  EXPECT_GT(state.rpm, 150e3);
}

TEST(Spindle, letting_the_pedal_go_ends_a_stall) {
  SpindleState state = after(kTurbine, 1.0, 3.0, 2.0);
  ASSERT_TRUE(state.stalled);
  state = after(kTurbine, 0.0, 3.0, kTickS, state);
  EXPECT_FALSE(state.stalled);
}

TEST(Spindle, a_wider_bur_stalls_a_turbine_sooner_in_proportion_to_its_radius) {
  EXPECT_FALSE(after(kTurbine, 1.0, 1.2, 3.0, {}, 2.0 * kStallRadiusMm).stalled);
  EXPECT_TRUE(after(kTurbine, 1.0, 1.3, 3.0, {}, 2.0 * kStallRadiusMm).stalled);
}

TEST(Spindle, half_the_pedal_gives_a_turbine_half_its_speed_and_half_its_stall) {
  EXPECT_NEAR(after(kTurbine, 0.5, 0.0, 3.0).rpm, 175e3, 30.0);
  EXPECT_TRUE(after(kTurbine, 0.5, 1.3, 3.0).stalled);
}

TEST(Spindle, an_electric_one_holds_200000_a_minute_until_its_torque_is_spent) {
  EXPECT_NEAR(after(kElectric, 1.0, 0.0, 3.0).rpm, 200e3, 30.0);
  EXPECT_NEAR(after(kElectric, 1.0, 4.9, 3.0).rpm, 200e3, 30.0);
  EXPECT_TRUE(after(kElectric, 1.0, 5.0, 3.0).stalled);
}

TEST(Spindle, a_slow_one_goes_from_20000_to_40000_a_minute_with_the_pedal) {
  EXPECT_NEAR(after(kSlow, 1e-6, 0.0, 3.0).rpm, 20e3, 10.0);
  EXPECT_NEAR(after(kSlow, 0.5, 0.0, 3.0).rpm, 30e3, 10.0);
  EXPECT_NEAR(after(kSlow, 1.0, 0.0, 3.0).rpm, 40e3, 10.0);
}

TEST(Spindle, coasts_to_a_stand_without_pedal) {
  const SpindleState state = after(kTurbine, 0.0, 0.0, 2.0, after(kTurbine, 1.0, 0.0, 2.0));
  EXPECT_EQ(state.rpm, 0.0);
  EXPECT_FALSE(state.stalled);
}

TEST(Spindle, comes_to_the_same_speed_whatever_the_length_of_a_tick) {
  for (const double dt_s : {0.00025, 0.001, 0.004, 0.05}) {
    SpindleState state;
    for (int k = 0; k < 4.0 / dt_s; ++k) advance(state, kTurbine, 1.0, 1.0, 0.5, dt_s);
    EXPECT_NEAR(state.rpm, 210e3, 100.0) << dt_s;
  }
}

TEST(Spindle, removal_goes_in_proportion_to_the_speed) {
  EXPECT_EQ(removal_factor({350e3, false}, kTurbine), 1.0);
  EXPECT_DOUBLE_EQ(removal_factor({87.5e3, false}, kTurbine), 0.25);
  EXPECT_EQ(removal_factor({0.0, true}, kTurbine), 0.0);
  EXPECT_EQ(removal_factor({}, settings_of(Handpiece::none)), 1.0) << "no spindle: the tissue's own speed";
}

TEST(Spindle, a_bur_of_one_millimetre_at_350000_a_minute_runs_18_metres_a_second_at_its_surface) {
  // pi * 1 mm * 350000 / 60 s.
  EXPECT_NEAR(surface_speed_mm_s(350e3, 0.5), 18326.0, 0.5);
}

TEST(Spindle, drag_stands_across_force_and_axis_and_pushes_a_bur_that_turns_clockwise_the_other_way) {
  // Handpiece upright, wall to the left of the bur (force to the right, +x). Seen from above it turns clockwise: at its
  // left side it moves up the page (+y), so the tissue drags it down the page.
  const Vec3 drag = drag_n(Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0), 1.0);
  EXPECT_NEAR(drag.x, 0.0, 1e-15);
  EXPECT_NEAR(drag.y, -kDragShare, 1e-15);
  EXPECT_NEAR(drag.z, 0.0, 1e-15);
}

TEST(Spindle, drag_is_none_where_the_end_cuts_and_grows_with_the_sine) {
  EXPECT_EQ(drag_n(Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.0), 1.0), Vec3(0.0));
  const double s = std::sqrt(0.5);
  const Vec3 drag = drag_n(Vec3(0.0, 0.0, 1.0), Vec3(s, 0.0, s), 1.0);
  EXPECT_NEAR(std::sqrt(glm::dot(drag, drag)), kDragShare * s, 1e-12);
}

TEST(Spindle, drag_never_goes_beyond_its_limit_and_is_none_at_a_stand) {
  const Vec3 most = drag_n(Vec3(50.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0), 1.0);
  EXPECT_NEAR(std::sqrt(glm::dot(most, most)), kMostDragN, 1e-12);
  EXPECT_EQ(drag_n(Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0), 0.0), Vec3(0.0));
}

TEST(Spindle, values_that_are_no_numbers_leave_a_speed_within_its_range) {
  for (const double bad : {kNan, kInf, -kInf, -1.0, 1e300}) {
    SpindleState state = after(kTurbine, 1.0, 0.0, 0.5);
    advance(state, kTurbine, bad, 1.0, 0.5, kTickS);
    advance(state, kTurbine, 1.0, bad, 0.5, kTickS);
    advance(state, kTurbine, 1.0, 1.0, bad, kTickS);
    advance(state, kTurbine, 1.0, 1.0, 0.5, bad);
    EXPECT_GE(state.rpm, 0.0) << bad;
    EXPECT_LE(state.rpm, 350e3) << bad;
    const Vec3 drag = drag_n(Vec3(bad, 0.0, 0.0), Vec3(0.0, 0.0, 1.0), bad);
    EXPECT_LE(std::sqrt(glm::dot(drag, drag)), kMostDragN + 1e-12) << bad;
  }
  SpindleState none;
  advance(none, settings_of(Handpiece::none), 1.0, 0.0, 0.5, kTickS);
  EXPECT_EQ(none.rpm, 0.0);
}

}  // namespace
}  // namespace cusp::test
