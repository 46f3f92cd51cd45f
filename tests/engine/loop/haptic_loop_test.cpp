#include "engine/loop/haptic_loop.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using test::DrillingPort;
using test::eventually;

LoopSettings quiet() {
  LoopSettings settings;
  settings.ask_realtime = false;
  return settings;
}

std::vector<StepInput> drain(HandOver& hand_over) {
  std::vector<StepInput> inputs;
  StepInput input;
  while (hand_over.inputs.pop(input)) inputs.push_back(input);
  return inputs;
}

TEST(VirtualLoop, RunsEachSampleOnceAndEndsWithThePort) {
  DrillingPort port(500);
  VirtualLoop loop(port, StepState(test::block_scene()));
  EXPECT_EQ(loop.run(10'000), 500u);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::port_over);
  EXPECT_EQ(loop.state().last().tick, 500u);
  EXPECT_EQ(loop.state().last().elapsed_us, 500'000u);
  EXPECT_EQ(drain(loop.hand_over()).size(), 500u);
}

/// Loses its device from sample 100 to 104, and is over after `ticks` samples.
class LosingPort final : public DrillingPort {
 public:
  explicit LosingPort(std::uint64_t ticks) : DrillingPort(ticks), end_(ticks) {}
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    const Sample sample = DrillingPort::wait(deadline);
    const std::uint64_t at = at_++;
    return at >= 100 && at < 105 ? Sample{} : sample;
  }
  bool over() const noexcept override { return at_ > end_; }

 private:
  std::uint64_t end_, at_ = 0;
};

TEST(VirtualLoop, StepsALossThatThePortOutlivesAndRearmsAfterIt) {
  LosingPort port(300);
  VirtualLoop loop(port, StepState(test::block_scene()));
  EXPECT_EQ(loop.run(10'000), 300u);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::port_over);
  EXPECT_FALSE(loop.state().last().faulted);
  const auto inputs = drain(loop.hand_over());
  ASSERT_EQ(inputs.size(), 300u);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    EXPECT_EQ((inputs[i].buttons & StepInput::kGone) != 0, i >= 100 && i < 105) << i;
    EXPECT_EQ((inputs[i].buttons & StepInput::kRearm) != 0, i > 100 && i <= 105) << i;
  }
}

TEST(VirtualLoop, WhatItStoredRebuildsItsStateBitForBit) {
  const auto scene = test::block_scene();
  DrillingPort port(400);
  VirtualLoop loop(port, StepState(scene));
  loop.run(400);
  StepState again(scene);
  for (const StepInput& input : drain(loop.hand_over())) step(again, input);
  EXPECT_EQ(again.hash(), loop.state().hash());
  EXPECT_GT(loop.state().volume().cut_bricks().size(), 0u) << "without a cut the test shows nothing";
}

TEST(VirtualLoop, AskedForTheLengthOfEachTickItTakesThat) {
  DrillingPort port(10);
  VirtualLoop loop(port, StepState(test::block_scene()));
  loop.take_elapsed_from([] { return 1500u; });
  loop.run(10);
  EXPECT_EQ(loop.state().last().elapsed_us, 15'000u);
}

TEST(VirtualLoop, AFullRingEndsItAndNoStepIsMissingFromTheRecord) {
  DrillingPort port(10'000);
  LoopSettings settings = quiet();
  settings.ring_inputs = 256;
  VirtualLoop loop(port, StepState(test::block_scene()), settings);
  EXPECT_EQ(loop.run(10'000), 256u);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::ring_full);
  EXPECT_EQ(loop.state().last().tick, 256u);
  EXPECT_EQ(port.last_force_n(), 0.0) << "the force goes to zero first";
  EXPECT_EQ(drain(loop.hand_over()).size(), 256u);
}

TEST(VirtualLoop, WarnsAtThreeQuartersOfTheRing) {
  DrillingPort port(10'000);
  LoopSettings settings = quiet();
  settings.ring_inputs = 256;
  VirtualLoop loop(port, StepState(test::block_scene()), settings);
  loop.run(190);
  EXPECT_FALSE(loop.hand_over().latest.read().ring_warning);
  loop.run(2);
  EXPECT_TRUE(loop.hand_over().latest.read().ring_warning);
}

TEST(Ticker, PausedItGivesNoForceAndStoresNothing) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  for (std::uint64_t i = 0; i < 300; ++i) ticker.tick(test::drilling_sample(i), 1000);
  ASSERT_GT(glm::length(ticker.tick(test::drilling_sample(300), 1000).force_n), 0.0);
  const auto stored = hand_over.inputs.size();
  ticker.pause();
  for (int i = 0; i < 50; ++i) EXPECT_EQ(glm::length(ticker.tick(test::drilling_sample(300), 1000).force_n), 0.0);
  EXPECT_EQ(hand_over.inputs.size(), stored);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::paused);
  ticker.resume();
  ticker.tick(test::drilling_sample(300), 1000);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::running);
  EXPECT_EQ(hand_over.inputs.size(), stored + 1);
}

TEST(Ticker, ALostDeviceHoldsWithZeroForceUntilResumed) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  for (std::uint64_t i = 0; i < 300; ++i) ticker.tick(test::drilling_sample(i), 1000);
  EXPECT_EQ(glm::length(ticker.tick({}, 1000).force_n), 0.0);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::held);
  EXPECT_EQ(hand_over.latest.read().fault, Fault::gone);
  EXPECT_EQ(hand_over.latest.read().device, Sample::Status::gone);
  const auto stored = hand_over.inputs.size();
  ticker.tick(test::drilling_sample(300), 1000);
  EXPECT_EQ(hand_over.inputs.size(), stored) << "the clock stands still while held";
  ticker.resume();
  ticker.tick(test::drilling_sample(300), 1000);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::running);
  EXPECT_EQ(hand_over.latest.read().fault, Fault::none);
}

TEST(Ticker, ADeviceThatOnlyRepeatsItselfHoldsWithZeroForceUntilResumed) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  for (std::uint64_t i = 0; i < 300; ++i) ticker.tick(test::drilling_sample(i), 1000);
  Sample repeated = test::drilling_sample(299);
  repeated.status = Sample::Status::late;
  int ticks = 0;
  while (hand_over.phase.load() == LoopPhase::running && ticks < 100) {
    ++ticks;
    ticker.tick(repeated, 1000);
  }
  EXPECT_EQ(ticks, 11) << "10 ms may be lost packets";
  EXPECT_EQ(hand_over.latest.read().fault, Fault::stale);
  EXPECT_EQ(glm::length(hand_over.latest.read().output.force_n), 0.0);
  ticker.resume();
  ticker.tick(test::drilling_sample(300), 1000);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::running);
}

TEST(Ticker, APositionThatIsNoNumberHoldsWithZeroForce) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  for (std::uint64_t i = 0; i < 300; ++i) ticker.tick(test::drilling_sample(i), 1000);
  Sample bad = test::drilling_sample(300);
  bad.position_mm.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(glm::length(ticker.tick(bad, 1000).force_n), 0.0);
  EXPECT_EQ(hand_over.phase.load(), LoopPhase::held);
  EXPECT_EQ(hand_over.latest.read().fault, Fault::not_finite);
}

TEST(Ticker, CoolantAskedForStandsInTheRecordBesideTheDevicesOwn) {
  HandOver hand_over(64);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  Sample sample = test::drilling_sample(0);
  StepInput input;
  const auto runs = [&] {
    ticker.tick(sample, 1000);
    EXPECT_TRUE(hand_over.inputs.pop(input));
    return (input.buttons & StepInput::kCoolant) != 0;
  };
  EXPECT_FALSE(runs());
  ticker.set_coolant(true);
  EXPECT_TRUE(runs());
  ticker.set_coolant(false);
  EXPECT_FALSE(runs());
  sample.buttons |= StepInput::kCoolant;
  EXPECT_TRUE(runs());
}

TEST(Ticker, TheLaterChoiceOfABurWins) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  const auto bur_after = [&](Sample sample) {
    ticker.tick(sample, 1000);
    return hand_over.latest.read().output.bur;
  };
  Sample sample = test::drilling_sample(0);
  sample.position_mm.z = 5.0;  // far from the block, where a bur is changed at once
  EXPECT_EQ(bur_after(sample), 0);
  ticker.change_bur(1);
  EXPECT_EQ(bur_after(sample), 1);
  EXPECT_EQ(bur_after(sample), 1) << "a port that still sends 0 does not take it back";
  sample.bur = 1;
  bur_after(sample);
  sample.bur = 0;
  EXPECT_EQ(bur_after(sample), 0) << "a port that changes its mind does";
  ticker.change_bur(9);
  EXPECT_EQ(bur_after(sample), 0) << "an instrument that the scene lacks is not taken";
}

TEST(Ticker, AgainstTissueTheWantedBurWaitsAndTheRecordNamesTheOneThatCuts) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  for (std::uint64_t i = 0; i < 300; ++i) ticker.tick(test::drilling_sample(i), 1000);
  ASSERT_TRUE(hand_over.latest.read().output.contact);
  drain(hand_over);
  ticker.change_bur(1);
  Sample sample = test::drilling_sample(300);
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 1) << "a device's buttons count from what was wanted";
  EXPECT_EQ(hand_over.latest.read().wanted_bur, 1);
  EXPECT_EQ(hand_over.latest.read().output.bur, 0);
  EXPECT_EQ(drain(hand_over).front().bur, 0);
  for (int i = 0; i < 100; ++i) {
    sample.position_mm.z += 0.02;
    ticker.tick(sample, 1000);
  }
  EXPECT_EQ(hand_over.latest.read().output.bur, 1);
  EXPECT_EQ(drain(hand_over).back().bur, 1);
}

TEST(Ticker, ItsFeedbackNamesTheBurWantedLastAlsoWithoutAForce) {
  HandOver hand_over(4096);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  Sample sample = test::drilling_sample(0);
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 0);
  ticker.change_bur(1);
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 1);
  ticker.pause();
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 1);
  ticker.change_bur(0);
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 0) << "chosen while paused";
  sample.bur = 1;
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 1);
  ticker.end(LoopEnd::asked);
  EXPECT_EQ(ticker.tick(sample, 1000).bur, 1);
}

TEST(Ticker, ARearmOfARecordedMotionStandsInTheRecord) {
  HandOver hand_over(64);
  Ticker ticker(StepState(test::block_scene()), hand_over);
  Sample sample = test::drilling_sample(0);
  StepInput input;
  for (const std::uint16_t mark : {std::uint16_t{0}, StepInput::kRearm, std::uint16_t{0}}) {
    sample.buttons = mark;
    ticker.tick(sample, 1000);
    ASSERT_TRUE(hand_over.inputs.pop(input));
    EXPECT_EQ(input.buttons, mark);
  }
}

TEST(HapticLoop, AtItsEndTheLastForceIsZeroAndItsRecordRebuildsIt) {
  const auto scene = test::block_scene();
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  HapticLoop loop(port, StepState(scene), quiet());
  loop.start();
  ASSERT_TRUE(eventually([&] { return port.peak_force_n() > 0.0 && loop.hand_over().ticks.load() > 200; }));
  loop.stop();
  EXPECT_EQ(port.last_force_n(), 0.0);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::asked);
  StepState again(scene);
  for (const StepInput& input : drain(loop.hand_over())) step(again, input);
  EXPECT_EQ(again.hash(), loop.state().hash());
  EXPECT_EQ(loop.times().ticks, again.last().tick);
}

TEST(HapticLoop, ALostDeviceKeepsThePaceAndComesBack) {
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  port.lose();
  HapticLoop loop(port, StepState(test::block_scene()), quiet());
  loop.start();
  ASSERT_TRUE(eventually([&] { return loop.hand_over().phase.load() == LoopPhase::held; }));
  const auto start = std::chrono::steady_clock::now();
  const auto before = port.writes();
  ASSERT_TRUE(eventually([&] { return port.writes() >= before + 20; }));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(18)) << "it must not spin";
  port.find();
  ASSERT_TRUE(eventually([&] { return loop.hand_over().latest.read().device == Sample::Status::fresh; }));
  EXPECT_EQ(loop.hand_over().phase.load(), LoopPhase::held) << "it does not go on by itself";
  loop.resume();
  EXPECT_TRUE(eventually([&] { return loop.hand_over().phase.load() == LoopPhase::running; }));
  loop.stop();
}

/// As a Falcon after opening: its first samples are late and name the origin, its hand is 9 mm above.
class RejectingPort final : public DrillingPort {
 public:
  RejectingPort() : DrillingPort(1u << 30, Pace::to_deadline) {}
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    Sample sample;
    if (late_ > 0) {
      --late_;
      std::this_thread::sleep_until(deadline);
      sample.status = Sample::Status::late;
      return sample;
    }
    sample = DrillingPort::wait(deadline);
    sample.position_mm.z += 9.0;
    return sample;
  }

 private:
  int late_ = 2;
};

TEST(HapticLoop, BeginsAtTheFirstNewSampleAndNotAtTheOrigin) {
  RejectingPort port;
  HapticLoop loop(port, StepState(test::block_scene()), quiet());
  loop.start();
  EXPECT_TRUE(eventually([&] { return loop.hand_over().ticks.load() >= 10 || loop.hand_over().phase.load() == LoopPhase::held; }));
  loop.stop();
  EXPECT_EQ(loop.state().fault(), Fault::none);
  const auto inputs = drain(loop.hand_over());
  ASSERT_FALSE(inputs.empty());
  EXPECT_EQ(inputs.front().buttons & StepInput::kLate, 0);
  EXPECT_GT(inputs.front().position_mm().z, 9.0);
}

/// A driver that takes a wait and does not come back until it is let to.
class StuckPort final : public DrillingPort {
 public:
  StuckPort() : DrillingPort(1u << 30, Pace::to_deadline) {}
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    if (++waits_ == 20) stuck.wait(true);
    return DrillingPort::wait(deadline);
  }
  std::atomic<bool> stuck{true};

 private:
  int waits_ = 0;
};

TEST(HapticLoop, SaysHowLongItsDriverHasStoodStill) {
  StuckPort port;
  HapticLoop loop(port, StepState(test::block_scene()), quiet());
  EXPECT_EQ(loop.silence().count(), 0) << "before the first tick";
  loop.start();
  const bool still = eventually([&] { return loop.silence() > std::chrono::milliseconds(200); });
  port.stuck = false;
  port.stuck.notify_all();
  EXPECT_TRUE(still);
  EXPECT_TRUE(eventually([&] { return loop.silence() < std::chrono::milliseconds(50); }));
  loop.stop();
}

TEST(HapticLoop, TheLatestValueIsNeverTorn) {
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  LoopSettings settings = quiet();
  settings.period = std::chrono::microseconds(100);
  HapticLoop loop(port, StepState(test::block_scene()), settings);
  loop.start();
  std::uint64_t last = 0, seen = 0;
  ASSERT_TRUE(eventually([&] {
    for (int i = 0; i < 100; ++i) {
      const LoopLatest& latest = loop.hand_over().latest.read();
      const std::uint64_t tick = latest.output.tick;
      if (tick == 0) continue;
      // Sample i is stepped as tick i + 1: every field of one value belongs to one tick.
      const Vec3 expected = quantise(test::drilling_sample(tick - 1), 1000, {}).position_mm();
      if (latest.output.device_mm != expected || tick < last) return true;
      if (tick != last) ++seen;
      last = tick;
    }
    return seen > 300;
  }));
  loop.stop();
  EXPECT_GT(seen, 300u);
}

TEST(TimeHistogram, PercentilesLieWithinABucketOfTheTruth) {
  TimeHistogram histogram;
  for (std::uint64_t us = 1; us <= 1000; ++us) histogram.add_ns(us * 1000);
  EXPECT_EQ(histogram.count(), 1000u);
  EXPECT_NEAR(histogram.percentile_us(0.5), 500.0, 500.0 * 0.032 + 0.1);
  EXPECT_NEAR(histogram.percentile_us(0.99), 990.0, 990.0 * 0.032 + 0.1);
  EXPECT_DOUBLE_EQ(histogram.max_us(), 1000.0);
}

TEST(TimeHistogram, AnEmptyOneSaysZeroAndAHugeOneKeepsItsMaximum) {
  TimeHistogram histogram;
  EXPECT_EQ(histogram.percentile_us(0.5), 0.0);
  histogram.add_ns(3'600'000'000'000);
  EXPECT_DOUBLE_EQ(histogram.max_us(), 3.6e9);
  EXPECT_GT(histogram.percentile_us(0.5), 1e6);
}

}  // namespace
}  // namespace cusp::test
