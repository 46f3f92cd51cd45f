// Spindle, vibration and heat as the step runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "engine/removal/spindle.h"
#include "engine/removal/vibration.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


constexpr Phenomena kAll{Handpiece::turbine, true, true};

/// A block of dentine 3 mm wide with its face at z = 1.5, under a bur of 0.5 mm radius; 1 N/mm, so a millimetre of
/// depth is a newton of push, and full wear at 1.5 N.
std::shared_ptr<Scene> block(const Phenomena& phenomena, Method method = Method::surface, double speed_mm_s = 0.5) {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.5)); }), method, 0.5, speed_mm_s);
  scene->full_force_n = 1.5;
  scene->phenomena = phenomena;
  return scene;
}

StepInput press(double depth_mm, std::uint16_t buttons, std::uint16_t pedal = 0, double x_mm = 0.0) {
  StepInput input = input_at({x_mm, 0.0, 2.0 - depth_mm});
  input.buttons = buttons;
  input.pedal = pedal;
  return input;
}

/// A push of constant force: the device follows the bur down.
struct Drilled {
  StepOutput last;
  double advanced_mm = 0.0, most_rpm = 0.0;
  int overheated = 0, dry_ticks = 0;
};
Drilled drill(StepState& state, double push_n, int ticks, std::uint16_t buttons, std::uint16_t pedal = 0) {
  Drilled out;
  if (state.last().tick == 0) approach(state, Vec3(0.0, 0.0, 2.3), Vec3(0.0, 0.0, 2.02));
  double z = state.last().proxy_mm.z;
  for (int k = 0; k < ticks; ++k) {
    StepInput input = input_at({0.0, 0.0, z - push_n});
    input.buttons = buttons;
    input.pedal = pedal;
    out.last = step(state, input);
    z = out.last.proxy_mm.z;
    out.advanced_mm += out.last.advance_mm;
    out.most_rpm = std::max(out.most_rpm, static_cast<double>(out.last.spindle_rpm));
    out.overheated += out.last.has(PhenomenonSign::overheated) ? 1 : 0;
    out.dry_ticks += out.last.has(PhenomenonSign::dry) ? 1 : 0;
  }
  return out;
}

class EveryMethod : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(Method::surface, Method::occupancy, Method::occupancy_pivot, Method::ray,
                                         Method::penalty, Method::gradient),
                         [](const auto& instance) {
                           std::string name(key_of(instance.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST_P(EveryMethod, removes_at_half_the_speed_when_the_spindle_turns_at_half) {
  if (GetParam() == Method::occupancy_pivot) GTEST_SKIP() << "its speed is none of eq. (6): the tool overlaps";
  // Electric, so that the load takes nothing: half the pedal is half the speed, once it has run up. 0.2 mm deep in
  // 5 N/mm: one newton, and no deeper than a shell of points bears.
  const auto scene = block({Handpiece::electric, false, false}, GetParam());
  for (TissueFeel& feel : scene->tissues) feel.stiffness_n_per_mm = 5.0;
  StepState whole(scene), half(scene);
  drill(whole, 0.2, 1000, 0, 65535);
  drill(half, 0.2, 1000, 0, 32768);
  const double fast = drill(whole, 0.2, 1000, 0, 65535).advanced_mm, slow = drill(half, 0.2, 1000, 0, 32768).advanced_mm;
  EXPECT_GT(slow, 0.05);
  EXPECT_NEAR(fast / slow, 2.0, 0.04) << fast << " and " << slow << " mm";
}

TEST_P(EveryMethod, a_bur_that_stands_removes_nothing) {
  StepState state(block({Handpiece::turbine, false, false}, GetParam()));
  const Drilled still = drill(state, 0.2, 500, 0, 0);
  EXPECT_EQ(still.advanced_mm, 0.0);
  EXPECT_TRUE(still.last.contact);
  EXPECT_EQ(still.last.spindle_rpm, 0.0f);
}

TEST(SpindleInTheStep, a_cut_button_is_the_whole_pedal_for_devices_without_one) {
  StepState state(block({Handpiece::electric, false, false}));
  for (int k = 0; k < 2000; ++k) step(state, press(-0.5, StepInput::kCut));
  EXPECT_NEAR(state.last().spindle_rpm, 200e3f, 100.0f);
}

TEST(SpindleInTheStep, a_turbine_sags_under_the_push_stalls_and_recovers) {
  StepState state(block({Handpiece::turbine, false, false}));
  const Drilled usual = drill(state, 1.0, 3000, StepInput::kCut);
  EXPECT_NEAR(usual.last.spindle_rpm, 210e3f, 2e3f);
  const Drilled hard = drill(state, 2.8, 1500, StepInput::kCut);
  EXPECT_TRUE(hard.last.has(PhenomenonSign::stalled));
  EXPECT_EQ(hard.last.spindle_rpm, 0.0f);
  EXPECT_EQ(hard.last.advance_mm, 0.0);
  const Drilled eased = drill(state, 0.5, 2000, StepInput::kCut);
  EXPECT_FALSE(eased.last.has(PhenomenonSign::stalled));
  EXPECT_GT(eased.last.spindle_rpm, 200e3f);
  EXPECT_GT(eased.last.advance_mm, 0.0);
}

TEST(SpindleInTheStep, stands_still_after_a_bur_was_changed) {
  auto scene = block({Handpiece::turbine, false, false});
  scene->burs.push_back(scene->burs.front());
  StepState state(scene);
  for (int k = 0; k < 1000; ++k) step(state, press(-0.5, StepInput::kCut));
  ASSERT_GT(state.last().spindle_rpm, 300e3f);
  StepInput changed = press(-0.5, 0);
  changed.bur = 1;
  // Near tissue one tick in sixteen looks whether it fits.
  for (int k = 0; k < 40 && state.last().bur != 1; ++k) step(state, changed);
  EXPECT_EQ(state.last().bur, 1);
  EXPECT_EQ(state.last().spindle_rpm, 0.0f);
}

TEST(SpindleInTheStep, stands_still_after_the_session_has_stood) {
  StepState state(block({Handpiece::turbine, false, false}));
  for (int k = 0; k < 1000; ++k) step(state, press(-0.5, StepInput::kCut));
  ASSERT_GT(state.last().spindle_rpm, 300e3f);
  step(state, press(-0.5, StepInput::kRearm));
  EXPECT_EQ(state.last().spindle_rpm, 0.0f) << "it would cut for 0.1 to 0.25 s without a button";
  step(state, press(-0.5, StepInput::kCut));
  EXPECT_GT(state.last().spindle_rpm, 0.0f);
}

TEST(SpindleInTheStep, turns_on_while_a_wanted_bur_waits_in_contact) {
  auto scene = block({Handpiece::turbine, false, false});
  scene->burs.push_back(scene->burs.front());
  StepState state(scene);
  const float turning = drill(state, 1.0, 2000, StepInput::kCut).last.spindle_rpm;
  ASSERT_GT(turning, 200e3f);
  StepInput waiting = press(0.0, StepInput::kCut);
  waiting.bur = 1;
  for (int k = 0; k < 100; ++k) {
    waiting.z = input_at({0.0, 0.0, state.last().proxy_mm.z - 1.0}).z;
    step(state, waiting);
  }
  EXPECT_EQ(state.last().bur, 0);
  EXPECT_NEAR(state.last().spindle_rpm, turning, 5e3f);
}

TEST(VibrationInTheStep, moves_the_force_by_no_more_than_60_mN_and_drag_by_no_more_than_60) {
  auto plain_scene = block({Handpiece::turbine, false, false});
  auto scene = block({Handpiece::turbine, true, false});
  for (auto& s : {plain_scene, scene})
    for (TissueFeel& feel : s->tissues) feel.speed_mm_s = 0.0;  // nothing recedes: the two stay together
  StepState plain(plain_scene), trembling(scene);
  double most = 0.0, drag = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const StepInput input = press(std::min(0.001 * k, 1.2), StepInput::kCut);
    const StepOutput a = step(plain, input), b = step(trembling, input);
    ASSERT_EQ(a.proxy_mm, b.proxy_mm);
    most = std::max(most, length(a.force_n - b.force_n));
    drag = std::max(drag, length(a.force_n - a.force_raw_n));
  }
  EXPECT_LE(most, kMostVibrationN + 1e-12);
  EXPECT_GT(most, 0.5 * kMostVibrationN);
  EXPECT_LE(drag, kMostDragN + 1e-12);
}

TEST(VibrationInTheStep, is_nothing_in_the_air_and_with_the_pedal_up) {
  auto scene = block(kAll);
  scene->guard = unguarded();
  StepState state(scene);
  for (int k = 0; k < 500; ++k) ASSERT_EQ(step(state, press(-0.3, StepInput::kCut)).force_n, Vec3(0.0));
  for (int k = 0; k < 2000; ++k) step(state, press(-0.3, 0));
  for (int k = 0; k < 500; ++k) {
    const StepOutput out = step(state, press(0.5, 0));
    ASSERT_EQ(out.force_n, out.force_raw_n);
  }
}

TEST(VibrationInTheStep, the_raw_force_that_metrics_use_has_none_of_it) {
  StepState state(block(kAll));
  for (int k = 0; k < 1500; ++k) {
    const StepOutput out = step(state, press(0.8, StepInput::kCut));
    if (!out.contact) continue;
    const Vec3 spring = (out.proxy_mm - out.device_mm) * out.stiffness_n_per_mm;
    ASSERT_LT(length(out.force_raw_n - spring), 1e-12) << k;
  }
}

TEST(VibrationInTheStep, the_force_for_the_hand_stays_within_the_guards_limit) {
  auto scene = block(kAll);
  scene->guard.limit_n = 1.0;
  StepState state(scene);
  for (int k = 0; k < 3000; ++k) {
    const double x = 0.4 * std::sin(0.01 * k);
    ASSERT_LE(length(step(state, press(2.0, StepInput::kCut, 0, x)).force_n), 1.0 * (1.0 + 1e-12)) << k;
  }
}

/// A hand that holds still on the cutting bur: the largest energy that it got, and its motion.
struct Held {
  double fed_mj, moves_mm;
};
Held held_on(const Phenomena& phenomena, const lab::Grip& grip, double k_n_per_mm) {
  auto scene = block(phenomena);
  for (TissueFeel& feel : scene->tissues) feel = {k_n_per_mm, 0.0};
  scene->guard = GuardSettings{};
  scene->guard.ramp_in_ms = 0.0;
  scene->guard.limit_n = 6.1;
  scene->guard.delay_ms = 1.0;
  StepState state(scene);
  lab::TransportSettings transport;
  transport.delay_ms = 1.0;
  lab::ClosedLoop loop(lab::falcon({}), transport, grip, Vec3(0.0, 0.0, 2.05));
  loop.plant().intend(Vec3(0.0, 0.0, 2.0 - 1.0 / k_n_per_mm - 1.0 / grip.stiffness_n_per_mm), Vec3(0.0));
  lab::ContactEnergy energy;
  lab::Steadiness steady;
  for (int k = 0; k < 3000; ++k) {
    const lab::LoopTick tick = loop.tick([&](const lab::Reading& reading) {
      StepInput input;
      input.x = reading.x, input.y = reading.y, input.z = reading.z;
      input.elapsed_us = reading.elapsed_us;
      input.buttons = StepInput::kCut;
      return step(state, input).force_n;
    });
    energy.add(tick);
    steady.add(tick, k >= 2000 ? lab::Steadiness::Part::in_window : lab::Steadiness::Part::before_window);
  }
  return {energy.most_mj(), steady.peak_to_peak_mm()};
}

TEST(VibrationInTheStep, feeds_a_hand_that_holds_still_next_to_nothing_and_lets_it_settle) {
  for (const lab::Grip& grip : {lab::kSoftGrip, lab::kFirmGrip}) {
    for (const double k : {1.0, 2.0}) {
      const Held without = held_on({}, grip, k), with = held_on(kAll, grip, k);
      std::printf("%g N/mm: fed %.4f mJ and %.3f mm without, %.4f and %.3f with\n", k, without.fed_mj, without.moves_mm,
                  with.fed_mj, with.moves_mm);
      EXPECT_LT(with.fed_mj, 0.05) << "what the guard's own tests allow";
      EXPECT_LT(with.moves_mm, without.moves_mm + 0.05) << "one encoder step";
    }
  }
}

TEST(HeatInTheStep, drilling_dry_raises_the_event_once_and_coolant_keeps_it_away) {
  // With coolant half of the way, then without.
  StepState state(block({Handpiece::none, false, true}, Method::surface, 0.02));
  const Drilled wet = drill(state, 1.0, 15'000, StepInput::kCut | StepInput::kCoolant);
  EXPECT_EQ(wet.overheated, 0);
  EXPECT_EQ(wet.dry_ticks, 0);
  EXPECT_TRUE(wet.last.has(PhenomenonSign::coolant));
  EXPECT_LT(wet.last.heat_k, 0.5f);
  const Drilled dry = drill(state, 1.0, 15'000, StepInput::kCut);
  EXPECT_EQ(dry.overheated, 1);
  EXPECT_GT(dry.dry_ticks, 14'900);
  EXPECT_GT(dry.last.heat_k, 5.5f);
}

TEST(HeatInTheStep, resting_on_the_tooth_without_cutting_warms_nothing) {
  StepState state(block({Handpiece::none, false, true}));
  const Drilled rest = drill(state, 1.0, 2000, 0);
  EXPECT_EQ(rest.last.heat_k, 0.0f);
  EXPECT_EQ(rest.dry_ticks, 0);
}

TEST(PhenomenaInTheStep, a_scene_that_asks_for_none_reports_none_and_hashes_as_before) {
  StepState state(block({}));
  const Drilled out = drill(state, 1.0, 500, StepInput::kCut | StepInput::kCoolant, 40000);
  EXPECT_EQ(out.last.spindle_rpm, 0.0f);
  EXPECT_EQ(out.last.heat_k, 0.0f);
  EXPECT_EQ(out.last.phenomena, 0);
  StepState heated(block({Handpiece::none, false, true}));
  drill(heated, 1.0, 500, StepInput::kCut | StepInput::kCoolant, 40000);
  EXPECT_EQ(heated.volume().hash(), state.volume().hash()) << "heat alone changes no removal";
  EXPECT_NE(heated.hash(), state.hash());
}

TEST(PhenomenaInTheStep, run_down_and_cool_while_the_guard_has_latched) {
  StepState state(block(kAll));
  const StepOutput before = drill(state, 1.0, 3000, StepInput::kCut).last;
  ASSERT_GT(before.heat_k, 0.5f);
  StepInput gone = press(1.0, StepInput::kCut | StepInput::kGone);
  StepOutput out;
  for (int k = 0; k < 3000; ++k) out = step(state, gone);
  EXPECT_EQ(out.force_n, Vec3(0.0));
  EXPECT_EQ(out.spindle_rpm, 0.0f);
  EXPECT_LT(out.heat_k, before.heat_k);
}

TEST_P(EveryMethod, a_key_state_goes_on_bit_for_bit_with_all_phenomena_on) {
  const auto scene = block(kAll, GetParam(), 2.0);
  const auto wander = [](int k) {
    StepInput input = press(k % 700 > 640 ? -0.4 : 0.4 + 0.0006 * k, k % 900 > 300 ? StepInput::kCoolant : std::uint16_t{0},
                            static_cast<std::uint16_t>(k % 500 < 420 ? 30000 + 70 * (k % 500) : 0), 0.6 * std::sin(0.01 * k));
    return input;
  };
  StepState whole(scene);
  for (int k = 0; k < 950; ++k) step(whole, wander(k));
  const std::vector<std::byte> bytes = whole.save();
  auto resumed = StepState::restore(scene, bytes);
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->hash(), whole.hash());
  EXPECT_EQ(resumed->save(), bytes);
  EXPECT_EQ(resumed->last().spindle_rpm, whole.last().spindle_rpm);
  EXPECT_EQ(resumed->last().phenomena, whole.last().phenomena);
  for (int k = 950; k < 2000; ++k) {
    const StepOutput x = step(whole, wander(k)), y = step(*resumed, wander(k));
    ASSERT_EQ(x.force_n, y.force_n) << k;
    ASSERT_EQ(x.spindle_rpm, y.spindle_rpm) << k;
    ASSERT_EQ(x.heat_k, y.heat_k) << k;
  }
  EXPECT_EQ(resumed->hash(), whole.hash());
}

TEST(PhenomenaInTheStep, a_key_state_of_a_scene_without_them_is_none_of_a_scene_with_them_and_the_other_way_round) {
  const auto with = block(kAll), without = block({});
  StepState a(with), b(without);
  drill(a, 1.0, 300, StepInput::kCut);
  drill(b, 1.0, 300, StepInput::kCut);
  EXPECT_FALSE(StepState::restore(without, a.save()));
  EXPECT_FALSE(StepState::restore(with, b.save()));
  EXPECT_TRUE(StepState::restore(with, a.save()));
}

TEST(PhenomenaInTheStep, a_key_state_with_an_impossible_speed_or_that_ends_early_is_refused) {
  const auto scene = block(kAll);
  StepState state(scene);
  drill(state, 1.0, 300, StepInput::kCut);
  std::vector<std::byte> bytes = state.save();
  for (std::size_t keep = 0; keep < bytes.size(); keep += 97) {
    EXPECT_FALSE(StepState::restore(scene, std::span(bytes).first(keep))) << keep;
  }
  // The speed stands as a double somewhere; as a float it is the speed of the last output.
  const auto speed_at = [&bytes, &state](std::size_t at) {
    double value = 0.0;
    std::memcpy(&value, &bytes[at], sizeof value);
    return value > 0.0 && static_cast<float>(value) == state.last().spindle_rpm;
  };
  std::size_t at = 0;
  while (at + sizeof(double) <= bytes.size() && !speed_at(at)) ++at;
  ASSERT_LE(at + sizeof(double), bytes.size());
  const double impossible = -1.0;
  std::memcpy(&bytes[at], &impossible, sizeof impossible);
  EXPECT_FALSE(StepState::restore(scene, bytes));
}

}  // namespace
}  // namespace cusp::test
