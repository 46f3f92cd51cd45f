// Purity, key states, the guard and the quantised input.
#include <gtest/gtest.h>

#include <limits>

#include "engine/step/guard.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


std::shared_ptr<const Scene> two_tissue_scene(Method method) {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.5)); },
                                      [](Vec3 p) { return p.z > 1.0 ? Tissue::enamel : Tissue::dentine; }),
                        method, 0.3, 3.0);
  scene->tissues[index_of(Tissue::enamel)] = {1.4, 1.5};
  scene->friction = true;
  scene->guard = GuardSettings{};
  scene->guard.ramp_in_ms = 20.0;
  return scene;
}

/// Wanders, presses and cuts; lifts now and then.
StepInput wander(int k) {
  const double a = 0.011 * k;
  const bool lifted = k % 700 > 640;
  return input_at({0.7 * std::sin(a), 0.6 * std::cos(0.7 * a), lifted ? 2.2 : 1.5 - 0.00015 * k},
                  lifted ? CutButton::up : CutButton::pressed);
}

class EveryMethod : public testing::TestWithParam<Method> {};

TEST_P(EveryMethod, is_pure_in_state_and_input) {
  StepState a(two_tissue_scene(GetParam()));
  StepState b(two_tissue_scene(GetParam()));
  for (int k = 0; k < 1500; ++k) {
    const StepInput input = wander(k);
    const StepOutput x = step(a, input);
    const StepOutput y = step(b, input);
    ASSERT_EQ(x.proxy_mm, y.proxy_mm) << k;
    ASSERT_EQ(x.force_n, y.force_n) << k;
  }
  EXPECT_EQ(a.hash(), b.hash());
  EXPECT_FALSE(a.volume().cut_bricks().empty());
}

TEST_P(EveryMethod, goes_on_from_a_key_state_bit_for_bit) {
  const auto scene = two_tissue_scene(GetParam());
  StepState whole(scene);
  for (int k = 0; k < 900; ++k) step(whole, wander(k));
  const std::vector<std::byte> bytes = whole.save();
  auto resumed = StepState::restore(scene, bytes);
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->hash(), whole.hash());
  EXPECT_EQ(resumed->save(), bytes);
  for (int k = 900; k < 2000; ++k) {
    const StepOutput x = step(whole, wander(k));
    const StepOutput y = step(*resumed, wander(k));
    ASSERT_EQ(x.proxy_mm, y.proxy_mm) << k;
    ASSERT_EQ(x.force_n, y.force_n) << k;
  }
  EXPECT_EQ(resumed->hash(), whole.hash());
}

/// Everything that is kept from tick to tick for speed alone is thrown away every 23 ticks; slow and fast, over edges, in
/// its own holes, cutting, hovering and away from the specimen.
TEST_P(EveryMethod, what_is_kept_for_speed_never_changes_an_answer) {
  const auto scene = two_tissue_scene(GetParam());
  StepState whole(scene);
  auto forgetful = StepState::restore(scene, whole.save());
  ASSERT_TRUE(forgetful);
  for (int k = 0; k < 3000; ++k) {
    const double pace = k < 1000 ? 0.002 : k < 2000 ? 0.03 : 0.11;  // about 1.5, 20 and 80 mm/s
    const double a = pace * k;
    const int phase = k % 500;
    const double z = phase < 250 ? 1.45 - 0.0006 * phase : phase < 350 ? 1.3 : phase < 430 ? 1.95 : 2.6;
    const StepInput input =
        input_at({1.5 * std::sin(a), 1.2 * std::cos(0.7 * a), z}, phase < 250 ? CutButton::pressed : CutButton::up);
    const StepOutput x = step(whole, input);
    const StepOutput y = step(*forgetful, input);
    ASSERT_EQ(x.proxy_mm, y.proxy_mm) << k;
    ASSERT_EQ(x.force_n, y.force_n) << k;
    if (k % 23 == 0) {
      forgetful = StepState::restore(scene, forgetful->save());
      ASSERT_TRUE(forgetful) << k;
    }
  }
  EXPECT_EQ(whole.hash(), forgetful->hash());
}

TEST_P(EveryMethod, refuses_a_key_state_that_is_cut_short_or_of_another_specimen) {
  const auto scene = two_tissue_scene(GetParam());
  StepState state(scene);
  for (int k = 0; k < 300; ++k) step(state, wander(k));
  std::vector<std::byte> bytes = state.save();
  const auto other = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.0; }), GetParam(), 0.3);
  EXPECT_FALSE(StepState::restore(other, bytes));
  // Each prefix lies on the heap in exactly its size, so ASan reports a read beyond it. The head takes 17 bytes; of the rest
  // some 64 lengths are cut, for each restore() reserves a whole state.
  const std::size_t stride = bytes.size() / 64 + 1;
  for (std::size_t keep = 0; keep < bytes.size(); keep += keep < 32 ? 1 : stride) {
    const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(keep));
    EXPECT_FALSE(StepState::restore(scene, cut)) << keep << " of " << bytes.size();
  }
  EXPECT_FALSE(StepState::restore(scene, std::span(bytes).first(bytes.size() - 1)));
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(StepState::restore(scene, bytes));
}

TEST_P(EveryMethod, wants_no_more_room_than_was_reserved) {
  StepState state(two_tissue_scene(GetParam()));
  for (int k = 0; k < 3000; ++k) ASSERT_FALSE(step(state, wander(k)).overflow) << k;
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(Method::surface, Method::occupancy, Method::occupancy_pivot, Method::ray,
                                         Method::penalty, Method::gradient),
                         [](const auto& p) {
                           std::string name(key_of(p.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

Vec3 given_for(const GuardSettings& settings, GuardState& state, Vec3 raw_n) {
  std::uint16_t acts = 0;
  GuardTick tick;
  tick.raw_n = raw_n;
  return guarded(settings, state, tick, Vec3(0.0), acts);
}

TEST(Guard, a_jump_latches_a_fault_until_it_is_rearmed) {
  auto scene = scene_of(from_distance(3.0, 0.1, [](Vec3 p) { return length(p) - 1.0; }), Method::surface, 0.3);
  StepState state(scene);
  approach(state, {0, 0, 2.5}, {0, 0, 1.2});
  EXPECT_GT(length(state.last().force_n), 0.0);
  StepOutput out = step(state, input_at({0, 0, 20.0}));
  EXPECT_TRUE(out.faulted);
  EXPECT_EQ(out.force_n, Vec3(0.0));
  out = step(state, input_at({0, 0, 1.2}));
  EXPECT_TRUE(out.faulted) << "going back does not clear it";
  EXPECT_EQ(state.fault(), Fault::jump);
  StepInput again = input_at({0, 0, 1.2});
  again.buttons |= StepInput::kRearm;
  out = step(state, again);
  EXPECT_FALSE(out.faulted);
}

TEST(Guard, force_rises_no_faster_than_the_slew_and_falls_at_once) {
  const GuardSettings settings{8.9, 0.3, 0.0, 5.0, 50.0};
  GuardState state;
  double last = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double given = length(given_for(settings, state, Vec3(0, 0, 20.0)));
    EXPECT_LE(given - last, 0.3 + 1e-12);
    EXPECT_LE(given, 8.9 + 1e-12);
    last = given;
  }
  EXPECT_DOUBLE_EQ(last, 8.9);
  EXPECT_EQ(given_for(settings, state, Vec3(0.0)), Vec3(0.0));
}

TEST(Guard, not_a_number_gives_no_force) {
  const GuardSettings settings;
  GuardState state;
  EXPECT_EQ(given_for(settings, state, Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0)), Vec3(0.0));
  EXPECT_EQ(state.fault, Fault::not_finite);
}

TEST(Guard, a_device_that_is_late_or_gone_is_a_fault) {
  const GuardSettings settings;
  StepInput late = input_at(Vec3(0.0));
  late.elapsed_us = 60000;
  EXPECT_EQ(judge(settings, late, {0.0, 0.0, InputPlace::later}), Fault::late);
  StepInput gone = input_at(Vec3(0.0));
  gone.buttons |= StepInput::kGone;
  EXPECT_EQ(judge(settings, gone, {0.0, 0.0, InputPlace::first}), Fault::gone);
  EXPECT_EQ(judge(settings, input_at(Vec3(0.0)), {6.0, 0.0, InputPlace::later}), Fault::jump);
  EXPECT_EQ(judge(settings, input_at(Vec3(0.0)), {6.0, 0.0, InputPlace::first}), Fault::none)
      << "the first input has come from nowhere";
}

TEST(Input, a_position_that_is_not_finite_is_marked_and_repeats_the_last) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
    sample.position_mm = {0.0, bad, 0.0};
    const StepInput last = input_at({1, 2, 3});
    const StepInput input = quantise(sample, 1000, last);
    EXPECT_EQ(input.buttons & StepInput::kNotFinite, StepInput::kNotFinite);
    EXPECT_EQ(input.y, last.y);
  }
}

TEST(Input, a_tenth_of_a_micrometre_survives) {
  Sample sample;
  sample.status = Sample::Status::fresh;
  sample.position_mm = {1.23456, -0.00014, 9.99999};
  const StepInput input = quantise(sample, 1000, StepInput{});
  EXPECT_EQ(input.x, 12346);
  EXPECT_EQ(input.y, -1);
  EXPECT_EQ(input.z, 100000);
}

}  // namespace
}  // namespace cusp::test
