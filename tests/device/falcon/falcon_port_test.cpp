// The port as the loop sees it, closed over an emulated Falcon that a hand holds, at 1 kHz in a time of its own.
#include "device/falcon/falcon_port.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "tests/device/counted_new.h"
#include "tests/device/falcon/rig.h"
#include "tests/device/toy_tissue.h"

namespace cusp {
namespace {

using namespace std::chrono_literals;
using falcon::EmulatedLink;
using falcon::EmulatedLinkSettings;
using falcon::Emulator;
using falcon::EmulatorSettings;
using falcon::LinkTime;
using falcon::Phase;
using falcon::Presence;
using testing::image;
using testing::allocations;
using testing::armed;
using testing::ToyTissue;

/// A port over an emulated Falcon, with deadlines two periods ahead as the loop gives them.
struct Bench {
  explicit Bench(const EmulatorSettings& device = {.firmware_running = true}, const FalconSettings& settings = {},
                 const EmulatedLinkSettings& line = {})
      : falcon(device) {
    auto made = std::make_unique<EmulatedLink>(falcon, line);
    link = made.get();
    port = std::make_unique<FalconPort>(std::move(made), settings);
  }
  Emulator falcon;
  EmulatedLink* link = nullptr;
  std::unique_ptr<FalconPort> port;
  int fresh = 0, late = 0, gone = 0;

  std::chrono::steady_clock::time_point in(LinkTime time) const {
    return std::chrono::steady_clock::time_point(link->now() + time);
  }
  Sample tick(const Feedback& feedback = {}) {
    const Sample sample = port->wait(in(2ms));
    fresh += sample.status == Sample::Status::fresh;
    late += sample.status == Sample::Status::late;
    gone += sample.status == Sample::Status::gone;
    port->write(feedback);
    return sample;
  }
  /// Out and in, until the samples come fresh.
  bool home() {
    double z = 0.100, step = 0.001;
    for (int i = 0; i < 2000; ++i) {
      z += step;
      if (z > 0.172 || z < 0.080) step = -step;
      falcon.set_grip({0, 0, z});
      if (tick().status == Sample::Status::fresh) return true;
    }
    return false;
  }
};

TEST(FalconPort, uploads_on_opening_homes_by_hand_and_then_follows_the_grip) {
  Bench bench(EmulatorSettings{});
  bench.port->give_image(image());
  ASSERT_TRUE(bench.port->open());
  EXPECT_TRUE(bench.falcon.firmware_running());
  EXPECT_EQ(bench.port->view().session.upload_size, image().bytes().size());
  for (int i = 0; i < 200; ++i) EXPECT_EQ(bench.tick().status, Sample::Status::gone);  // not homed: no place
  ASSERT_TRUE(bench.home());
  const auto space = *falcon::Workspace::from({});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 place(unit(random) * 0.04, unit(random) * 0.04, 0.12 + unit(random) * 0.03);
    bench.falcon.set_grip(place);
    bench.tick();
    bench.tick();
    const Sample sample = bench.tick();
    ASSERT_EQ(sample.status, Sample::Status::fresh);
    // Half an encoder step an arm; a step is at most 0.057 mm at the grip (facts 1.13), 0.0285 at half scale.
    ASSERT_LT(glm::length(sample.position_mm - space.specimen_mm(place)), 0.03);
  }
}

TEST(FalconPort, the_hand_feels_the_force_that_was_written) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  const auto space = *falcon::Workspace::from({});
  for (const Vec3 place : {Vec3(0, 0, 0.125), Vec3(0.03, -0.02, 0.11), Vec3(-0.02, 0.03, 0.14)}) {
    bench.falcon.set_grip(place);
    const Vec3 force(0.3, -0.8, 1.1);
    for (int i = 0; i < 600; ++i) bench.tick({.force_n = force});
    // Torque words are whole counts of 1e-4 Nm: 0.5e-4 / 0.06 m is under 1 mN an arm; the encoder's half step tilts the
    // Jacobian by less than a thousandth.
    EXPECT_LT(glm::length(bench.falcon.force_n(bench.link->now()) - space.device_n(force)), 4e-3);
  }
}

TEST(FalconPort, a_force_too_large_is_felt_in_its_direction) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.falcon.set_grip({0.01, 0.02, 0.12});
  const Vec3 wanted(30, 20, -10);
  for (int i = 0; i < 600; ++i) bench.tick({.force_n = wanted});
  const Vec3 given = bench.falcon.force_n(bench.link->now());
  const Vec3 direction = falcon::Workspace::from({})->device_n(wanted);
  EXPECT_GT(glm::dot(glm::normalize(given), glm::normalize(direction)), 0.9999);
  EXPECT_LT(glm::length(given), 20.0);
}

TEST(FalconPort, the_force_that_it_promises_is_to_be_had_everywhere) {
  const double promised = Bench().port->limits().max_force_n;
  const falcon::Geometry geometry;
  double least = 1e9;
  for (double z = 0.080; z <= 0.1701; z += 0.005)
    for (int r = 0; r <= 4; ++r)
      for (int a = 0; a < 24; ++a) {
        const Vec3 place(r * 0.01 * std::cos(a * 0.2618), r * 0.01 * std::sin(a * 0.2618), z);
        const auto rows = falcon::jacobian(geometry, *falcon::inverse(geometry, place));
        for (int i = 0; i < 300; ++i) {
          const double up = 1 - 2 * (i + 0.5) / 300, turn = i * 2.399963, across = std::sqrt(1 - up * up);
          const Vec3 t = falcon::torque_nm(*rows, {across * std::cos(turn), across * std::sin(turn), up});
          least = std::min(least, 0.4095 / std::max({std::abs(t.x), std::abs(t.y), std::abs(t.z)}));
        }
      }
  EXPECT_GE(least, promised);
  EXPECT_LT(least, promised + 0.3);
}

/// A hand of 150 g on a spring of 0.5 N/mm, critically damped, stepped with the emulated time.
struct Hand {
  Emulator& falcon;
  Vec3 wanted_m;
  Vec3 at_m, speed{0.0};
  LinkTime before{0};
  bool begun = false;

  void live(LinkTime now) {
    if (!begun) before = now;
    begun = true;
    while (before < now) {
      const LinkTime step = std::min<LinkTime>(now - before, 100us);
      const double dt = std::chrono::duration<double>(step).count();
      constexpr double kMass = 0.15, kSpring = 500.0, kDamping = 2.0 * 8.66;  // 2 sqrt(k m) = 17.3 N s/m
      const Vec3 force = falcon.force_n(before) + (wanted_m - at_m) * kSpring - speed * kDamping;
      speed += force / kMass * dt;
      at_m += speed * dt;
      before += step;
      falcon.set_grip(at_m);
    }
  }
};

TEST(FalconPort, a_hand_rests_on_a_wall_at_a_thousand_samples_a_second) {
  FalconSettings settings;
  settings.workspace.scale = 1.0;
  Bench bench({.firmware_running = true}, settings);
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  // 1 N/mm at specimen z = 0, which is the device's y = 0; the hand wants to be 2 mm below.
  ToyTissue tissue;
  tissue.stiffness_n_per_mm = 1.0;
  Hand hand{bench.falcon, {0, -0.002, 0.125}, {0, 0.010, 0.125}};
  bench.link->on_time([&hand](LinkTime now) { hand.live(now); });
  bench.fresh = bench.late = bench.gone = 0;
  const LinkTime start = bench.link->now();
  Feedback felt;
  while (bench.link->now() < start + 10s) {
    const Sample sample = bench.tick(felt);
    felt = tissue.feel(sample.position_mm);
  }
  std::cout << bench.fresh << " fresh, " << bench.late << " late, " << bench.gone << " gone in 10 s; rests at "
            << hand.at_m.y * 1e3 << " mm\n";
  EXPECT_GE(bench.fresh, 9900);
  EXPECT_LE(bench.fresh, 10001);
  EXPECT_EQ(bench.gone, 0);
  // Rest: 0.5 N/mm * (2 - d) = 1 N/mm * d, d = 2/3 mm; an encoder step is 0.05 mm.
  EXPECT_NEAR(hand.at_m.y * 1e3, -0.667, 0.05);
}

TEST(FalconPort, answers_slower_than_a_millisecond_still_come_a_thousand_a_second) {
  Bench bench({.firmware_running = true}, {}, {.transfer = 700us, .jitter = 100us});
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.fresh = bench.late = bench.gone = 0;
  const LinkTime start = bench.link->now();
  while (bench.link->now() < start + 2s) bench.tick();
  std::cout << bench.fresh << " fresh, " << bench.late << " late in 2 s\n";
  EXPECT_GE(bench.fresh, 1950);
  EXPECT_LE(bench.fresh, 2001);
  EXPECT_EQ(bench.gone, 0);
}

TEST(FalconPort, ten_thousand_exchanges_lose_nothing_and_allocate_nothing) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  const auto before = bench.port->view().session;
  armed = true;
  allocations = 0;
  for (int i = 0; i < 10000; ++i) bench.tick({.force_n = Vec3(0.5)});
  armed = false;
  EXPECT_EQ(allocations, 0);
  const auto after = bench.port->view().session;
  EXPECT_GE(after.replies - before.replies, 10000u);
  EXPECT_EQ(after.lost, before.lost);
  EXPECT_EQ(after.dropped_bytes, before.dropped_bytes);
  EXPECT_EQ(after.silences, before.silences);
}

TEST(FalconPort, says_why_it_does_not_open) {
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
            (std::array<std::int16_t, 3>{}));  // zeros were its last words
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

TEST(FalconPort, a_fault_or_a_force_that_is_none_gives_no_torque) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(1)});
  for (int i = 0; i < 3; ++i) bench.tick({.force_n = Vec3(1), .faulted = true});
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
  for (int i = 0; i < 3; ++i) bench.tick({.force_n = Vec3(1)});
  EXPECT_NE(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
  for (int i = 0; i < 3; ++i) bench.tick({.force_n = Vec3(std::nan(""), 0, 0)});
  EXPECT_EQ(bench.falcon.torque_words(bench.link->now()), (std::array<std::int16_t, 3>{}));
}

TEST(FalconPort, the_clutch_takes_the_force_away_and_leaves_the_burr) {
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

TEST(FalconPort, a_new_force_gain_holds_from_the_next_packet_on) {
  Bench bench;
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.falcon.set_grip({0, 0, 0.12});
  const auto pushed = [&bench] {
    for (int i = 0; i < 700; ++i) bench.tick({.force_n = Vec3(0, 1, 0)});  // past the ramp of half a second
    return glm::length(bench.falcon.force_n(bench.link->now()));
  };
  const double usual = pushed();
  EXPECT_NEAR(usual, 1.0, 0.01);  // torque words are whole numbers
  bench.port->set_force_gain(1.5);
  EXPECT_NEAR(pushed(), 1.5 * usual, 0.01);
}

TEST(FalconPort, buttons_cut_and_change_the_burr_once_a_press) {
  FalconSettings settings;
  settings.burrs = 3;
  Bench bench({.firmware_running = true}, settings);
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  const auto press = [&bench](std::uint8_t button, int ticks) {
    bench.falcon.set_buttons(button);
    for (int i = 0; i < ticks; ++i) bench.tick();
    bench.falcon.set_buttons(0);
    for (int i = 0; i < 4; ++i) bench.tick();
    return bench.tick().burr;
  };
  EXPECT_EQ(press(falcon::status::kPlus, 5), 0);    // a bounce
  EXPECT_EQ(press(falcon::status::kPlus, 300), 1);  // held: one burr on
  EXPECT_EQ(press(falcon::status::kPlus, 60), 2);
  EXPECT_EQ(press(falcon::status::kPlus, 60), 2);  // the last one
  EXPECT_EQ(press(falcon::status::kMinus, 60), 1);
  bench.falcon.set_buttons(falcon::status::kCentre);
  for (int i = 0; i < 4; ++i) bench.tick();
  const Sample sample = bench.tick();
  EXPECT_EQ(sample.buttons, 1);
  EXPECT_EQ(sample.pedal, 65535);
}

TEST(FalconPort, carries_the_weight_that_was_calibrated) {
  FalconSettings settings;
  settings.gravity = {0.2, 0.003};
  Bench bench({.firmware_running = true}, settings);
  ASSERT_TRUE(bench.port->open());
  ASSERT_TRUE(bench.home());
  bench.falcon.set_grip({0, 0, 0.125});
  for (int i = 0; i < 700; ++i) bench.tick();
  const auto legs = falcon::inverse({}, {0, 0, 0.125});
  const falcon::Pose pose{{0, 0, 0.125}, *legs, *falcon::jacobian({}, *legs)};
  const Vec3 due = falcon::force_n(pose.rows, falcon::gravity_torque_nm({}, pose, settings.gravity));
  EXPECT_GT(due.y, 1.0);
  EXPECT_LT(glm::length(bench.falcon.force_n(bench.link->now()) - due), 5e-3);
}

TEST(FalconPort, waits_no_longer_than_it_was_told_whatever_happens) {
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
}  // namespace cusp
