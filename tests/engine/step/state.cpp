// Purity, key states, the guard and the quantised input.
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "engine/step/guard.h"
#include "engine/step/state.h"
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

std::shared_ptr<const Scene> ball_scene() {
  return scene_of(from_distance(4.0, 0.1, [](Vec3 p) { return box_distance(p, Vec3(1.8, 1.8, 1.4)); }), Method::surface, 0.4, 4.0);
}
/// A shaking ball that sinks along a circle.
StepInput spiral(int k) {
  return input_at({0.9 * std::sin(0.02 * k) + 0.004 * std::sin(2.1 * k), 0.9 * std::cos(0.02 * k) + 0.004 * std::sin(1.7 * k), 1.65 - 0.0005 * k},
                  CutButton::pressed);
}

/// Adds short ways of a tiny ball until so many are left. Nothing is carved: no voxel names them.
void fill(Sweeps& sweeps, int left) {
  for (int ways = 0; sweeps.size() + left < static_cast<int>(Sweeps::kMost); ++ways) {
    const Vec3 low(1.7, 1.7, -1.7), high = low + Vec3(1e-4, 0.0, 0.0);
    sweeps.seal();
    sweeps.add(ways % 2 == 0 ? low : high, ways % 2 == 0 ? high : low, 1e-4);
  }
  sweeps.break_path();
}

TEST(SweepRoom, is_made_between_strokes_and_changes_no_answer) {
  const auto scene = ball_scene();
  StepState full(scene), empty(scene);
  for (StepState* state : {&full, &empty}) approach(*state, {0.0, 0.9, 2.6}, {0.0, 0.9, 1.81});
  const auto both = [&](int from, int to) {
    for (int k = from; k < to; ++k) {
      // Every stroke ends in the air.
      const StepInput input = k % 100 < 80 ? spiral(k) : input_at({0.0, 0.0, 2.6});
      const StepOutput a = step(full, input), b = step(empty, input);
      ASSERT_FALSE(a.overflow) << k;
      ASSERT_EQ(a.proxy_mm, b.proxy_mm) << k;
      ASSERT_EQ(a.force_n, b.force_n) << k;
    }
  };
  both(0, 400);
  fill(full.inner().sweeps, static_cast<int>(Sweeps::kMost / 8) + 40);
  both(400, 1200);
  EXPECT_LT(full.inner().sweeps.size(), 2000) << "what no voxel names is forgotten";
  EXPECT_EQ(full.volume().hash(), empty.volume().hash());
  const auto again = StepState::restore(scene, full.save());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->hash(), full.hash());
}

TEST(SweepRoom, that_ran_out_in_a_stroke_is_flagged) {
  const auto scene = ball_scene();
  StepState state(scene);
  approach(state, {0.0, 0.9, 2.6}, {0.0, 0.9, 1.81});
  fill(state.inner().sweeps, 40);
  int flagged = 0;
  for (int k = 0; k < 500; ++k) flagged += step(state, spiral(k)).overflow;
  EXPECT_GT(flagged, 100);
}

TEST(KeyState, is_whole_where_the_store_of_ways_fills_up_in_a_stroke) {
  const auto scene = ball_scene();
  StepState state(scene);
  approach(state, {0.0, 0.9, 2.6}, {0.0, 0.9, 1.81});
  fill(state.inner().sweeps, 40);
  const std::vector<std::byte> bytes = state.save();
  int filled_amid_a_sweep = 0;
  for (int left = 33; left < 40; ++left) {
    auto cuts = StepState::restore(scene, bytes);
    ASSERT_TRUE(cuts);
    StepState::Inner& inner = cuts->inner();
    fill(inner.sweeps, left);
    for (int k = 0; k < 500; ++k) {
      const bool growing = inner.cut_pending && inner.cut_last != Sweeps::kNone;
      step(*cuts, spiral(k));
      if (!growing || inner.cut_last != Sweeps::kNone) continue;
      ++filled_amid_a_sweep;
      EXPECT_EQ(inner.cut_first, Sweeps::kNone) << "what was swept before has lost its end";
      const auto again = StepState::restore(scene, cuts->save());
      ASSERT_TRUE(again);
      EXPECT_EQ(again->hash(), cuts->hash());
      break;
    }
  }
  EXPECT_GT(filled_amid_a_sweep, 0);
}

TEST(KeyState, is_refused_if_a_voxel_or_a_run_names_the_gap_between_two_ways) {
  const auto scene = ball_scene();
  StepState state(scene);
  approach(state, {0.0, 0.9, 2.6}, {0.0, 0.9, 1.81});
  for (int k = 0; k < 200; ++k) step(state, k % 60 < 50 ? spiral(k) : input_at({0.0, 0.9, 2.6}));
  StepState::Inner& inner = state.inner();
  std::int32_t gap = 0;
  while (!inner.sweeps.gap(gap)) ++gap;
  ASSERT_TRUE(StepState::restore(scene, state.save()));
  const auto refuses_with = [&](std::int32_t& id) {
    const std::int32_t was = std::exchange(id, gap);
    const bool refuses = !StepState::restore(scene, state.save());
    id = was;
    return refuses;
  };
  EXPECT_TRUE(refuses_with(inner.cut_last));
  EXPECT_TRUE(refuses_with(inner.volume.sweeps_for_writing(inner.volume.cut_bricks()[0])[100]));
  EXPECT_TRUE(StepState::restore(scene, state.save()));
}

TEST(KeyState, is_refused_if_a_way_that_is_carved_has_too_few_vertices_or_too_many) {
  const auto scene = ball_scene();
  StepState state(scene);
  approach(state, {0.0, 0.9, 2.6}, {0.0, 0.9, 1.81});
  StepState::Inner& inner = state.inner();
  for (int k = 0; k < 200 && !inner.cut_pending; ++k) step(state, spiral(k));
  ASSERT_TRUE(inner.cut_pending);
  const auto restores_with = [&](int& count, int vertices) {
    const int was = std::exchange(count, vertices);
    const bool restores = StepState::restore(scene, state.save()).has_value();
    count = was;
    return restores;
  };
  EXPECT_TRUE(restores_with(inner.cut_way.count, Polyline::kMost - 1));
  for (const int vertices : {-1, 0, Polyline::kMost}) EXPECT_FALSE(restores_with(inner.cut_way.count, vertices)) << vertices;
  inner.pending_sweep.waits = true;
  EXPECT_TRUE(restores_with(inner.pending_sweep.way.count, 2));
  for (const int vertices : {-1, 1, Polyline::kMost + 1}) EXPECT_FALSE(restores_with(inner.pending_sweep.way.count, vertices)) << vertices;
}

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
