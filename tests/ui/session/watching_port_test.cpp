// What a device gives and gets while a question of an assessment is open.
#include "ui/session/watching_port.h"

#include <gtest/gtest.h>

#include "engine/step/input.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A hand that presses the button, until the test releases it, and wants the coolant, and what its device last got.
class PressedPort final : public HapticPort {
 public:
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point) noexcept override {
    const auto cut = pressed ? StepInput::kCut : std::uint16_t{0};
    const auto pedal = pressed ? std::uint16_t{40'000} : std::uint16_t{0};
    return {.status = Sample::Status::fresh, .buttons = static_cast<std::uint16_t>(cut | StepInput::kCoolant), .pedal = pedal};
  }
  void write(const Feedback& feedback) noexcept override { got = feedback; }
  DeviceLimits limits() const override { return {}; }
  void close() noexcept override {}
  bool pressed = true;
  Feedback got;
};

/// The port of a loop that is not started: nobody but the test reads it.
struct Pressed {
  explicit Pressed(std::shared_ptr<const PedalSource> pedal = nullptr) : port(device, std::move(pedal), HeldCut()) { port.watch(loop); }
  PressedPort device;
  WatchingPort port;
  HapticLoop loop{port, StepState(block_scene())};
};

/// A pedal that is pressed down.
class PressedPedal final : public PedalSource {
 public:
  PedalReading latest(std::chrono::steady_clock::time_point) const noexcept override { return {.pressed = 65535}; }
};

TEST(WatchingPort, TakesCutAndForceOffTheDeviceAndKeepsTheRest) {
  Pressed pressed;
  WatchingPort& port = pressed.port;
  EXPECT_EQ(port.wait({}).buttons, StepInput::kCut | StepInput::kCoolant);
  port.write({.force_n = {0, 0, 2}, .in_contact = true});
  EXPECT_EQ(pressed.device.got.force_n, Vec3(0, 0, 2));
  port.set_idle(true);
  const Sample idle = port.wait({});
  EXPECT_EQ(idle.status, Sample::Status::fresh);
  EXPECT_EQ(idle.buttons, StepInput::kCoolant);
  EXPECT_EQ(idle.pedal, 0);
  port.write({.force_n = {0, 0, 2}, .in_contact = true});
  EXPECT_EQ(pressed.device.got.force_n, Vec3(0.0));
  EXPECT_TRUE(pressed.device.got.in_contact) << "the mouse's hand reads what it touches";
}

TEST(WatchingPort, RearmsWithTheFirstSampleAfterwardsAlone) {
  Pressed pressed;
  WatchingPort& port = pressed.port;
  EXPECT_EQ(port.wait({}).buttons & StepInput::kRearm, 0);
  port.set_idle(true);
  EXPECT_EQ(port.wait({}).buttons & StepInput::kRearm, 0);
  port.set_idle(false);
  EXPECT_NE(port.wait({}).buttons & StepInput::kRearm, 0) << "the force ramps in, as after a pause";
  EXPECT_EQ(port.wait({}).buttons & StepInput::kRearm, 0);
}

TEST(WatchingPort, GivesNoForceBeforeTheSampleThatRearms) {
  Pressed pressed;
  WatchingPort& port = pressed.port;
  port.set_idle(true);
  port.wait({});
  port.set_idle(false);  // between the tick's sample and its force
  port.write({.force_n = {0, 0, 2}});
  EXPECT_EQ(pressed.device.got.force_n, Vec3(0.0));
  EXPECT_NE(port.wait({}).buttons & StepInput::kRearm, 0);
  port.write({.force_n = {0, 0, 2}});
  EXPECT_EQ(pressed.device.got.force_n, Vec3(0, 0, 2));
}

TEST(WatchingPort, ACutThatIsHeldOverTheQuestionCountsOnlyOnceItWasReleased) {
  Pressed pressed;
  WatchingPort& port = pressed.port;
  port.set_idle(true);
  port.wait({});
  EXPECT_FALSE(port.ignores_cut()) << "nobody is to release it under the question";
  port.set_idle(false);
  for (int i = 0; i < 1000; ++i) {  // longer than the force ramps in
    const Sample held = port.wait({});
    ASSERT_EQ(held.buttons & StepInput::kCut, 0);
    ASSERT_EQ(held.pedal, 0);
    ASSERT_TRUE(port.ignores_cut());
  }
  pressed.device.pressed = false;
  port.wait({});
  EXPECT_FALSE(port.ignores_cut());
  pressed.device.pressed = true;
  const Sample anew = port.wait({});
  EXPECT_NE(anew.buttons & StepInput::kCut, 0);
  EXPECT_EQ(anew.pedal, 40'000);
}

TEST(WatchingPort, TakesTheCutOffThePedalToo) {
  Pressed pressed(std::make_shared<PressedPedal>());
  WatchingPort& port = pressed.port;
  EXPECT_EQ(port.wait({}).pedal, 65535);
  port.set_idle(true);
  EXPECT_EQ(port.wait({}).buttons & StepInput::kCut, 0);
  EXPECT_EQ(port.wait({}).pedal, 0);
}

}  // namespace
}  // namespace cusp::test
