// The port when something is in doubt: not there, unplugged, silent, nonsense, clutched. There is no force then, and it
// waits no longer than its deadline.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/device/falcon/port_bench.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using falcon::EmulatorSettings;
using falcon::LinkTime;
using falcon::Phase;
using falcon::Presence;
using test::image;
using Bench = test::PortBench;

TEST(FalconPort, reports_why_it_does_not_open) {
  const auto error_of = [](Presence presence) {
    Bench bench;
    bench.link->set_presence(presence);
    const auto opened = bench.port->open();
    EXPECT_FALSE(opened);
    return opened ? PortError::io : opened.error().code;
  };
  EXPECT_EQ(error_of(Presence::absent), PortError::not_found);
  EXPECT_EQ(error_of(Presence::denied), PortError::no_permission);
  EXPECT_EQ(error_of(Presence::busy), PortError::busy);
  Bench no_image{EmulatorSettings{}};
  const auto needs = no_image.port->open();
  ASSERT_FALSE(needs);
  EXPECT_EQ(needs.error().code, PortError::bad_file);
  EXPECT_EQ(needs.error().detail, "needs_image");
  Bench off{EmulatorSettings{.powered = false}};
  off.port->give_image(image());
  const auto dark = off.port->open();
  ASSERT_FALSE(dark);
  EXPECT_EQ(dark.error().code, PortError::io);
  EXPECT_EQ(dark.error().detail, "no_hello");
}

TEST(FalconPort, opens_again_after_it_was_closed) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  EXPECT_GT(glm::length(bench.falcon.force_n(bench.link->now())), 1.0);
  bench.port->close();
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()),
            (std::array<std::int16_t, 3>{}));  // its last packets were zero
  EXPECT_EQ(bench.falcon.leds(), 0);
  EXPECT_EQ(bench.port->wait(bench.in(2ms)).status, Sample::Status::gone);
  ASSERT_TRUE(bench.port->open());
  for (int i = 0; i < 50 && bench.tick().status != Sample::Status::fresh; ++i) continue;
  EXPECT_EQ(bench.tick().status, Sample::Status::fresh);  // still homed
}

TEST(FalconPort, unplugged_while_drilling_it_is_gone_and_comes_back) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.falcon.set_buttons(falcon::status::kCentre);
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  EXPECT_EQ(bench.tick().buttons, 1);
  bench.link->set_presence(Presence::absent);
  Sample sample = bench.tick({.force_n = Vec3(1)});
  sample = bench.tick({.force_n = Vec3(1)});
  EXPECT_EQ(sample.status, Sample::Status::gone);
  EXPECT_EQ(sample.buttons, 0);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(bench.tick().status, Sample::Status::gone);
  EXPECT_EQ(bench.falcon.force_n(bench.link->now()), Vec3(0.0));
  bench.link->set_presence(Presence::here);
  int until = 0;
  while (until < 2000 && bench.tick({.force_n = Vec3(1)}).status != Sample::Status::fresh) ++until;
  EXPECT_LT(until, 600);  // within 0.5 s of looking, 2 ms a tick, and the probe
  EXPECT_LT(glm::length(bench.falcon.force_n(bench.link->now())), 0.1);
}

TEST(FalconPort, shows_that_it_cannot_be_distinguished_from_another_at_its_usb_port) {
  for (const bool by_port : {false, true}) {
    Bench bench({.firmware_running = true}, {}, {.by_port = by_port});
    ASSERT_TRUE(bench.port->open());
    EXPECT_EQ(bench.port->view().by_port, by_port);
    bench.link->set_presence(Presence::absent);
    for (int i = 0; i < 300; ++i) bench.tick();
    EXPECT_NE(bench.port->view().session.phase, Phase::ready);
    EXPECT_EQ(bench.port->view().by_port, by_port) << "also while it is away";
  }
}

TEST(FalconPort, silence_is_gone_with_no_force) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  bench.falcon.fall_mute(true);
  const LinkTime mute = bench.link->now();
  while (bench.tick({.force_n = Vec3(1)}).status != Sample::Status::gone) {
    ASSERT_LT(bench.link->now() - mute, 20ms);
  }
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
}

TEST(FalconPort, readings_that_no_place_has_give_no_force) {
  FalconSettings settings;
  settings.calibration.trim_rad = Vec3(-3.0);  // far beyond any trim: the angles are nonsense
  Bench bench({.firmware_running = true}, settings);
  ASSERT_TRUE(bench.port->open());
  EXPECT_FALSE(bench.home());
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  EXPECT_EQ(bench.port->view().session.phase, Phase::ready);
  EXPECT_GT(bench.port->view().unsolved, 600u);
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
}

TEST(FalconPort, a_firmware_file_that_is_lacking_matters_only_if_none_runs) {
  const PortFailure why{PortError::bad_file, "/nowhere/firmware.bin", "unreadable"};
  Bench off{EmulatorSettings{}};
  off.port->lack_image(why);
  const auto refused = off.port->open();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, PortError::bad_file);
  EXPECT_EQ(refused.error().where, why.where);
  EXPECT_EQ(refused.error().detail, why.detail);
  Bench runs;
  runs.port->lack_image(why);
  EXPECT_TRUE(runs.port->open());
  EXPECT_TRUE(runs.home());
}

TEST(FalconPort, a_fault_or_a_force_that_is_none_gives_no_torque) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  for (int i = 0; i < 3; ++i) bench.tick({.force_n = Vec3(1), .faulted = true});
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});  // the ramp takes 500 ms
  EXPECT_NE(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
  for (int i = 0; i < 3; ++i) bench.tick({.force_n = Vec3(std::nan(""), 0, 0)});
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
}

TEST(FalconPort, the_clutch_takes_the_force_away_and_leaves_the_bur) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.falcon.set_grip({0.01, 0, 0.12});
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  const Vec3 stood = bench.tick({.force_n = Vec3(1)}).position_mm;
  bench.falcon.set_buttons(falcon::status::kForward);
  for (int i = 0; i < 5; ++i) bench.tick({.force_n = Vec3(1)});
  EXPECT_TRUE(bench.port->view().clutched);
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
  bench.falcon.set_grip({-0.02, 0.01, 0.13});
  for (int i = 0; i < 5; ++i) EXPECT_LT(glm::length(bench.tick().position_mm - stood), 1e-9);
  bench.falcon.set_buttons(0);
  for (int i = 0; i < 5; ++i) {
    EXPECT_LT(glm::length(bench.tick({.force_n = Vec3(1)}).position_mm - stood), 1e-9);
    EXPECT_LT(glm::length(bench.falcon.force_n(bench.link->now())), 0.1);  // begins at zero again
  }
}

TEST(FalconPort, one_answer_with_the_clutch_s_bit_shifts_nothing) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  const auto space = *falcon::Workspace::from({});
  double x = 0;
  const auto move = [&](std::uint8_t buttons) {
    bench.falcon.set_buttons(buttons);
    bench.falcon.set_grip({x += 0.001, 0, 0.12});
    return bench.tick();
  };
  bench.falcon.set_grip({x, 0, 0.12});
  for (int i = 0; i < 50; ++i) bench.tick();
  move(falcon::status::kForward);
  for (int i = 0; i < 5; ++i) move(0);
  // An answer is of the exchange before. Half an encoder step at half scale.
  const Vec3 before_mm = space.specimen_mm({x, 0, 0.12});
  EXPECT_LT(glm::length(move(0).position_mm - before_mm), 0.03);
}

TEST(FalconPort, waits_no_longer_than_its_deadline_whatever_happens) {
  std::mt19937 random(23);
  Bench bench(EmulatorSettings{});
  bench.port->give_image(image());
  ASSERT_TRUE(bench.port->open());
  for (int i = 0; i < 20000; ++i) {
    switch (random() % 400) {
      case 0:
        bench.link->set_presence(Presence::absent);
        break;
      case 1:
      case 2:
        bench.link->set_presence(Presence::here);
        break;
      case 3:
        bench.falcon.fall_mute(true);
        break;
      case 4:
        bench.falcon.fall_mute(false);
        break;
      case 5:
        bench.falcon.cut_power();
        break;
      case 6:
      case 7:
        bench.falcon.restore_power();
        break;
      case 8:
        bench.falcon.spoil_answers(5);
        break;
      case 9:
        bench.link->fail_sends(random() % 2 == 0);
        break;
      default:
        break;
    }
    const LinkTime before = bench.link->now();
    const Sample sample = bench.port->wait(bench.in(2ms));
    ASSERT_LE(bench.link->now() - before, 2ms);
    ASSERT_TRUE(std::isfinite(glm::dot(sample.position_mm, Vec3(1.0))));
    bench.port->write({.force_n = Vec3(1)});
    if (bench.falcon.homed() != falcon::status::kHomed) {
      ASSERT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
    }
    if (random() % 20 == 0) bench.falcon.set_grip({0, 0, 0.08 + 0.09 * (random() % 100) / 100.0});
  }
  LinkTime now = bench.link->now();
  bench.port->wait(std::chrono::steady_clock::time_point::min());
  EXPECT_EQ(bench.link->now(), now);
  now = bench.link->now();
  bench.port->wait(std::chrono::steady_clock::time_point::max());
  EXPECT_LE(bench.link->now() - now, 20ms);
}

}  // namespace
}  // namespace cusp::test
