// The guard as the last stage of the step: a fault sets the force to zero until re-armed, and each part has the effect
// that step/README.md lists.
#include "engine/step/guard.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/step/state.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


constexpr double kRadiusMm = 0.3;
constexpr double kDepthMm = 0.4;  // 0.4 N at 1 N/mm
const Vec3 kPressed{0.0, 0.0, 1.0 + kRadiusMm - kDepthMm};

std::shared_ptr<Scene> ball_scene(Method method = Method::surface) {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.0; }), method, kRadiusMm);
  scene->burs.push_back(Bur{"larger", 0.5, 0.3, 4.0, 0.8, 12.0});
  scene->guard = GuardSettings{};
  return scene;
}

Sample sample_at(Vec3 place) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = place;
  return sample;
}

/// Down to where it presses, then still for half a second: the ramp is over.
void press(StepState& state) {
  approach(state, {0, 0, 2.0}, kPressed);
  for (int k = 0; k < 500; ++k) step(state, input_at(kPressed));
}

struct Faulty {
  const char* name;
  Fault fault;
  StepInput (*input)(const StepInput& last);
};

const Faulty kFaulty[] = {
    {"jump_of_20_mm", Fault::jump,
     [](const StepInput& last) {
       return quantise(sample_at({0, 20, 0}), 1000, last);
     }},
    {"not_a_number", Fault::not_finite,
     [](const StepInput& last) {
       return quantise(sample_at({0, std::numeric_limits<double>::quiet_NaN(), 0}), 1000, last);
     }},
    {"infinite", Fault::not_finite,
     [](const StepInput& last) {
       return quantise(sample_at({-std::numeric_limits<double>::infinity(), 0, 0}), 1000, last);
     }},
    {"out_of_range", Fault::not_finite,
     [](const StepInput& last) {
       return quantise(sample_at({0, 0, -1e9}), 1000, last);
     }},
    {"orientation_not_a_number", Fault::not_finite,
     [](const StepInput& last) {
       Sample sample = sample_at(kPressed);
       sample.orientation.x = std::numeric_limits<double>::quiet_NaN();
       return quantise(sample, 1000, last);
     }},
    {"vanished", Fault::gone,
     [](const StepInput& last) {
       Sample sample = sample_at(kPressed);
       sample.status = Sample::Status::gone;
       return quantise(sample, 1000, last);
     }},
    {"tick_51_ms_late", Fault::late, [](const StepInput& last) { return quantise(sample_at(kPressed), 51'000, last); }},
};

class FaultyInput : public testing::TestWithParam<Faulty> {};

TEST_P(FaultyInput, takes_the_force_away_in_its_tick_until_it_is_rearmed) {
  StepState state(ball_scene());
  press(state);
  const double before = length(state.last().force_n);
  ASSERT_GT(before, 0.95 * kDepthMm);
  StepOutput out = step(state, GetParam().input(input_at(kPressed)));
  EXPECT_EQ(out.force_n, Vec3(0.0));
  EXPECT_EQ(state.fault(), GetParam().fault);
  for (int k = 0; k < 100; ++k) out = step(state, input_at(kPressed));
  EXPECT_EQ(out.force_n, Vec3(0.0)) << "a good input does not clear it";

  StepInput again = input_at(kPressed);
  again.buttons |= StepInput::kRearm;
  double last = length(step(state, again).force_n);
  int back = -1;
  for (int k = 0; k < 500; ++k) {
    const double now = length(step(state, input_at(kPressed)).force_n);
    EXPECT_LE(now - last, 0.3 + 1e-12);
    last = now;
    if (back < 0 && now > 0.95 * before) back = k;
  }
  EXPECT_EQ(state.fault(), Fault::none);
  EXPECT_GE(back, 180) << "it ramps in over 200 ms";
  EXPECT_GE(last, 0.999 * before);
}

INSTANTIATE_TEST_SUITE_P(Inputs, FaultyInput, testing::ValuesIn(kFaulty),
                         [](const auto& p) { return std::string(p.param.name); });

TEST(FrozenDevice, is_one_without_a_new_sample_for_longer_than_ten_milliseconds) {
  StepState state(ball_scene());
  press(state);
  StepInput repeated = input_at(kPressed);
  repeated.buttons |= StepInput::kLate;
  StepOutput out;
  for (int k = 1; k <= 10; ++k) {
    out = step(state, repeated);
    ASSERT_EQ(state.fault(), Fault::none) << k << " ms: a few lost packets are none";
  }
  out = step(state, repeated);
  EXPECT_EQ(state.fault(), Fault::stale);
  EXPECT_EQ(out.force_n, Vec3(0.0));
}

TEST(FrozenDevice, is_not_a_hand_at_rest_whose_reading_never_changes) {
  StepState state(ball_scene());
  press(state);
  const Vec3 before = state.last().force_n;
  for (int k = 0; k < 5000; ++k) step(state, input_at(kPressed));
  EXPECT_EQ(state.fault(), Fault::none);
  EXPECT_EQ(state.last().force_n, before);
}

TEST(LateTick, of_up_to_50_ms_goes_on_and_earns_no_more_rise_than_one_in_time) {
  for (const std::uint32_t late_us : {2'000u, 10'000u, 50'000u}) {
    StepState state(ball_scene());
    press(state);
    const double before = length(state.last().force_n);
    const StepOutput out = step(state, input_at(kPressed - Vec3(0, 0, 2.0), CutButton::up, late_us));
    EXPECT_EQ(state.fault(), Fault::none) << late_us;
    EXPECT_LE(length(out.force_n) - before, 0.3 + 1e-12) << late_us;
    EXPECT_GT(length(out.force_raw_n), 2.0);
  }
}

TEST(Exchange, of_the_bur_waits_for_the_air_and_begins_from_no_force) {
  StepState state(ball_scene());
  press(state);
  StepInput other = input_at(kPressed), lifted = input_at(kPressed + Vec3(0, 0, 2.0));
  other.bur = lifted.bur = 1;
  EXPECT_EQ(step(state, other).bur, 0);
  step(state, lifted);
  EXPECT_EQ(step(state, lifted).bur, 1);
  double last = length(step(state, other).force_n);
  EXPECT_LE(last, 0.3 / 200.0 * 10.0) << "the first millisecond of the ramp, of a push that grew with the bur";
  for (int k = 0; k < 400; ++k) {
    const double now = length(step(state, other).force_n);
    EXPECT_LE(now - last, 0.3 + 1e-12);
    last = now;
  }
  EXPECT_GT(last, 0.95 * length(state.last().force_raw_n));
}

TEST(Exchange, of_the_specimen_in_contact_begins_from_no_force) {
  StepState state(ball_scene(Method::surface));
  double last = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double now = length(step(state, input_at(kPressed)).force_n);
    EXPECT_LE(now - last, 0.3 + 1e-12);
    if (k == 0) {
      EXPECT_LT(now, 0.01);
    }
    last = now;
  }
}

GuardTick tick_of(Vec3 raw_n, Vec3 device_mm = Vec3(0.0)) {
  GuardTick tick;
  tick.raw_n = raw_n;
  tick.device_mm = device_mm;
  tick.proxy_mm = device_mm + raw_n;
  tick.stiffness_n_per_mm = 1.0;
  tick.contact = raw_n != Vec3(0.0);
  return tick;
}

TEST(Parts, switched_off_leave_the_methods_own_force_to_the_bit) {
  GuardState state;
  for (int k = 0; k < 200; ++k) {
    const Vec3 raw(0.37 * k, k % 7 == 0 ? 11.0 : -3.0, 1.0 / (k + 1.0));
    std::uint16_t acts = 1;
    EXPECT_EQ(guarded(unguarded(), state, tick_of(raw), Vec3(3.0, 0.0, 0.0), acts), raw);
    EXPECT_EQ(acts, 0);
  }
}

TEST(Parts, switched_off_faults_are_none_but_a_lost_device_and_no_number_always_are) {
  const GuardSettings off = unguarded();
  EXPECT_EQ(judge(off, input_at(Vec3(0.0), CutButton::up, 900'000), {50.0, 500.0, InputPlace::later}), Fault::none);
  StepInput gone = input_at(Vec3(0.0));
  gone.buttons |= StepInput::kGone;
  EXPECT_EQ(judge(off, gone, {0.0, 0.0, InputPlace::later}), Fault::gone);
  GuardState state;
  std::uint16_t acts = 0;
  EXPECT_EQ(guarded(off, state, tick_of(Vec3(std::numeric_limits<double>::infinity(), 0, 0)), Vec3(0.0), acts),
            Vec3(0.0));
  EXPECT_EQ(state.fault, Fault::not_finite);
}

TEST(VelocityBound, releases_a_device_that_the_force_throws_and_holds_one_that_pushes) {
  GuardSettings only = unguarded().with(GuardPart::speed);
  const Vec3 force(0.0, 0.0, 2.0);
  const auto given = [&](double mm_s) {
    GuardState state;
    std::uint16_t acts = 0;
    Vec3 out;
    for (int k = 0; k < 100; ++k) out = guarded(only, state, tick_of(force), Vec3(0.0, 0.0, mm_s * 1e-3), acts);
    return out.z;
  };
  EXPECT_EQ(given(-1000.0), 2.0) << "a wall is hit at 1 m/s";
  EXPECT_EQ(given(300.0), 2.0) << "nobody drills at 300 mm/s";
  EXPECT_NEAR(given(600.0), 1.0, 1e-9) << "half way between 400 and 800";
  EXPECT_EQ(given(900.0), 0.0);
}

TEST(VelocityBound, takes_one_encoder_step_for_no_throw) {
  GuardSettings only = unguarded().with(GuardPart::speed);
  GuardState state;
  std::uint16_t acts = 0;
  // Encoders of 0.2 mm, coarser than any: 200 mm/s for a tick.
  guarded(only, state, tick_of(Vec3(0, 0, 2.0)), Vec3(0.0), acts);
  EXPECT_EQ(guarded(only, state, tick_of(Vec3(0, 0, 2.0)), Vec3(0, 0, 0.2), acts).z, 2.0);
}

TEST(Slew, holds_a_force_that_turns_aside) {
  const GuardSettings only = unguarded().with(GuardPart::slew);
  GuardState state;
  std::uint16_t acts = 0;
  for (int k = 0; k < 20; ++k) guarded(only, state, tick_of(Vec3(0, 0, 3.0)), Vec3(0.0), acts);
  const Vec3 turned = guarded(only, state, tick_of(Vec3(3.0, 0, 0)), Vec3(0.0), acts);
  EXPECT_NEAR(turned.x, 0.3, 1e-12);
  EXPECT_NEAR(turned.z, 0.0, 1e-12) << "the force that ends falls at once";
  EXPECT_TRUE(acts & static_cast<std::uint16_t>(GuardPart::slew));
}

TEST(KeyState, holds_all_of_a_guard_that_acts) {
  auto scene = ball_scene();
  for (TissueFeel& feel : scene->tissues) feel.stiffness_n_per_mm = 6.0;
  scene->guard.delay_ms = 2.0;
  // Bounces hard, so that the controller softens.
  const auto bounce = [](int k) { return input_at({0, 0, 1.2 + 0.4 * std::sin(0.15 * k)}); };
  StepState whole(scene);
  for (int k = 0; k < 400; ++k) step(whole, bounce(k));
  ASSERT_LT(whole.inner().guard.passivity.scale, 1.0);
  auto resumed = StepState::restore(scene, whole.save());
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->hash(), whole.hash());
  for (int k = 400; k < 800; ++k) ASSERT_EQ(step(whole, bounce(k)).force_n, step(*resumed, bounce(k)).force_n) << k;
  EXPECT_EQ(resumed->hash(), whole.hash());
}

}  // namespace
}  // namespace cusp::test
