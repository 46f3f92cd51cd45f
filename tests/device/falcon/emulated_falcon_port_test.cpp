// The device that is chosen where there is none: real bytes, an emulated Falcon, and a hand that is a mouse's or a
// script's.
#include "device/falcon/emulated_falcon_port.h"

#include <gtest/gtest.h>

#include <iostream>

#include "device/pointer/pointer_motion.h"
#include "engine/loop/haptic_loop.h"
#include "tests/device/toy_tissue.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using falcon::EmulatedTime;
using test::ToyTissue;

std::chrono::steady_clock::time_point in_2ms(EmulatedFalconPort& port) {
  return std::chrono::steady_clock::time_point(port.link().now() + 2ms);
}

TEST(EmulatedFalcon, a_mouse_presses_with_it) {
  PointerHand hand(Vec3(0, 0, 2));
  PointerMotion motion(hand.wish().target_mm);
  EmulatedFalconPort port(
      [&](const Feedback& felt, double dt_s) {
        const PointerWish& wish = hand.latest();
        return EmulatedHandPose{motion.advance(wish, felt, dt_s), wish.cut, wish.bur};
      },
      {.cold = true, .time = EmulatedTime::stands});
  ASSERT_TRUE(port.open());
  EXPECT_TRUE(port.falcon().firmware_running());
  EXPECT_EQ(port.falcon().loaded_words(), 2048u);
  hand.set_push(1.5);
  hand.set_cut(true);
  hand.set_bur(2);
  ToyTissue tissue;
  double least = 9, most = 0;
  Sample sample;
  for (int i = 0; i < 4000; ++i) {
    sample = port.wait(in_2ms(port));
    ASSERT_EQ(sample.status, Sample::Status::fresh) << i;
    const Feedback felt = tissue.feel(sample.position_mm);
    port.write(felt);
    if (i < 2000) continue;
    least = std::min(least, glm::length(felt.force_n));
    most = std::max(most, glm::length(felt.force_n));
  }
  std::cout << "a push of 1.5 N is " << least << " to " << most << " N\n";
  // 2 N/mm over encoder steps of 0.057 mm at half scale: 0.057 N a step, half of it either way, and a step of creep.
  EXPECT_NEAR(least, 1.5, 0.12);
  EXPECT_NEAR(most, 1.5, 0.12);
  EXPECT_EQ(sample.buttons, 1);
  EXPECT_EQ(sample.bur, 2);
}

TEST(EmulatedFalcon, drills_a_block_in_virtual_time_without_a_late_sample) {
  // A script's hand, the driver, the emulated bytes, and the engine's own step on one clock that stands still.
  std::uint64_t tick = 0;
  EmulatedFalconPort port(
      [&tick](const Feedback&, double) {
        const Sample wanted = test::drilling_sample(tick++);
        return EmulatedHandPose{wanted.position_mm, (wanted.buttons & 1) != 0, 0};
      },
      {.time = EmulatedTime::stands});
  ASSERT_TRUE(port.open());
  VirtualLoop loop(port, StepState(test::block_scene()));
  constexpr std::uint64_t kTicks = 3000;
  EXPECT_EQ(loop.run(kTicks), kTicks);
  std::vector<StepInput> inputs;
  StepInput input;
  std::uint64_t late = 0, gone = 0;
  while (loop.hand_over().inputs.pop(input)) {
    inputs.push_back(input);
    late += (input.buttons & StepInput::kLate) != 0;
    gone += (input.buttons & StepInput::kGone) != 0;
  }
  EXPECT_EQ(inputs.size(), kTicks);
  EXPECT_EQ(late, 0u);
  EXPECT_EQ(gone, 0u);
  EXPECT_LT(loop.state().last().proxy_mm.z, -0.3);  // it drilled itself in
  EXPECT_FALSE(loop.state().last().faulted);
  StepState again(test::block_scene());
  for (const StepInput& one : inputs) step(again, one);
  EXPECT_EQ(again.hash(), loop.state().hash());
}

TEST(EmulatedFalcon, a_device_that_dies_ends_the_virtual_run) {
  EmulatedFalconPort port([](const Feedback&, double) { return EmulatedHandPose{}; }, {.time = EmulatedTime::stands});
  ASSERT_TRUE(port.open());
  VirtualLoop loop(port, StepState(test::block_scene()));
  EXPECT_EQ(loop.run(100), 100u);
  port.link().set_presence(falcon::Presence::absent);
  EXPECT_LT(loop.run(100), 100u);
  EXPECT_EQ(loop.hand_over().end.load(), LoopEnd::port_over);
}

TEST(EmulatedFalcon, is_no_device_of_the_real_one_s_class) {
  const EmulatedFalconPort port([](const Feedback&, double) { return EmulatedHandPose{}; });
  EXPECT_EQ(port.limits().device_class, "emulated-falcon");
  EXPECT_FALSE(port.limits().closed_loop);
  EXPECT_TRUE(port.limits().has_own_clock);
}

}  // namespace
}  // namespace cusp::test
