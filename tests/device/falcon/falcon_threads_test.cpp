// The port on the haptic thread, with a screen that reads its view, lights its LEDs, and moves an emulated grip.
#include <gtest/gtest.h>

#include <thread>

#include "device/falcon/emulated_falcon_port.h"
#include "engine/loop/haptic_loop.h"
#include "tests/device/falcon/images.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;

TEST(FalconThreads, a_screen_looks_on_while_the_loop_runs) {
  EmulatedFalconPort port([](const Feedback&, double) { return EmulatedHandPose{.position_mm = Vec3(0, 0, 1)}; });
  ASSERT_TRUE(port.open());
  HapticLoop loop(port, StepState(test::block_scene()), {.ask_realtime = false});
  loop.start();
  std::uint64_t replies = 0;
  EXPECT_TRUE(test::eventually([&] {
    const FalconView& view = port.view();
    EXPECT_GE(view.session.replies, replies);  // never a torn or an older one
    replies = view.session.replies;
    if (loop.hand_over().phase.load() == LoopPhase::held)
      loop.resume();  // a machine so busy that a device seems silent
    return loop.hand_over().ticks.load() >= 300;
  }));
  loop.stop();
  EXPECT_GT(replies, 0u);
}

TEST(FalconThreads, opening_can_be_given_up) {
  falcon::Emulator dark({.powered = false});
  FalconPort port(
      std::make_unique<falcon::EmulatedLink>(dark, falcon::EmulatedLinkSettings{.time = falcon::EmulatedTime::runs}));
  port.give_image(*falcon::FirmwareImage::from_bytes(test::boot_image()));
  std::thread screen([&port] {
    EXPECT_TRUE(test::eventually([&port] { return port.view().session.phase == falcon::Phase::greeting; }));
    port.cancel();
  });
  const auto opened = port.open();  // nobody answers hello: without cancel() this would take a minute
  screen.join();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().detail, "cancelled");
}

TEST(FalconThreads, another_thread_moves_the_grip_and_lights_the_colours) {
  falcon::Emulator falcon({.firmware_running = true});
  auto made =
      std::make_unique<falcon::EmulatedLink>(falcon, falcon::EmulatedLinkSettings{.time = falcon::EmulatedTime::runs});
  falcon::EmulatedLink& link = *made;
  FalconPort port(std::move(made));
  ASSERT_TRUE(port.open());
  std::atomic<bool> stop{false};
  std::atomic<int> fresh{0};
  std::thread haptic([&] {
    while (!stop.load()) {
      const Sample sample = port.wait(std::chrono::steady_clock::now() + 2ms);
      if (sample.status == Sample::Status::fresh) ++fresh;
      port.write({.force_n = Vec3(0.1)});
    }
  });
  int step = 0;
  EXPECT_TRUE(test::eventually([&] {
    const int at = ++step % 400;
    link.set_grip({.grip_m = {0, 0, 0.100 + 0.07 * (at < 200 ? at : 400 - at) / 200.0}, .set = true});
    port.set_leds(falcon::control::kGreen);
    return fresh.load() >= 100;
  }));
  stop = true;
  haptic.join();
  // A stall of this machine may just have made it red: a few exchanges later it is what was asked for.
  for (int i = 0; i < 2000 && falcon.leds() != falcon::control::kGreen; ++i) {
    port.wait(std::chrono::steady_clock::now() + 2ms);
    port.write({});
  }
  EXPECT_EQ(falcon.leds(), falcon::control::kGreen);
}

}  // namespace
}  // namespace cusp::test
