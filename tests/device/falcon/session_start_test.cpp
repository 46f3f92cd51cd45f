// From plugged in to answering, with an emulated Falcon and a clock that stands still until somebody waits: what goes
// wrong with the line, the loader, the echo and the plug.
#include "device/falcon/session.h"

#include <gtest/gtest.h>

#include "tests/device/falcon/rig.h"

namespace cusp::device::falcon {
namespace {

using test::image;
using test::Rig;
using namespace std::chrono_literals;

TEST(FalconSession, uploads_homes_and_then_gives_force) {
  Rig rig;
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::homing));
  EXPECT_TRUE(rig.falcon.firmware_running());
  EXPECT_EQ(rig.falcon.loaded_blocks(), 3);
  EXPECT_EQ(rig.falcon.loaded_words(), 2500u);
  EXPECT_EQ(rig.session.state().uploaded, image().bytes().size());
  for (const Phase phase : {Phase::opening, Phase::settling, Phase::probing, Phase::arming, Phase::greeting,
                            Phase::locking, Phase::uploading, Phase::switching}) {
    EXPECT_TRUE(rig.seen.contains(phase)) << key_of(phase);
  }
  EXPECT_EQ(rig.session.state().attempt, 0);
  rig.run(300ms);
  EXPECT_EQ(rig.session.phase(), Phase::homing);  // nobody moved it
  EXPECT_EQ(rig.falcon.leds(), control::kRed);
  EXPECT_FALSE(rig.forced_ever);
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.run(1s);
  EXPECT_EQ(rig.falcon.leds(), control::kBlue);
  EXPECT_EQ(rig.falcon.torque_words(rig.link.now()), (std::array<std::int16_t, 3>{1000, -2000, 500}));
  EXPECT_FALSE(rig.forced);
}

TEST(FalconSession, finds_firmware_that_runs_already_and_leaves_it) {
  Rig rig({.firmware_running = true});
  ASSERT_TRUE(rig.reach(Phase::homing, 1s));
  EXPECT_FALSE(rig.seen.contains(Phase::arming));
  EXPECT_EQ(rig.falcon.loaded_words(), 0u);
}

TEST(FalconSession, finds_it_although_the_first_answers_are_lost) {
  Rig rig({.firmware_running = true});
  rig.session.give_image(image());
  rig.falcon.lose_answers(3);
  ASSERT_TRUE(rig.reach(Phase::homing, 1s));
  EXPECT_FALSE(rig.seen.contains(Phase::arming));
  // The fourth is answered. A drained line shows which packet the answer belongs to: three zeros, then one packet at a time.
  EXPECT_EQ(rig.session.state().sent, 4u + 3u + 8u);
}

TEST(FalconSession, waits_for_an_image_and_goes_on_when_one_is_given) {
  Rig rig;
  ASSERT_TRUE(rig.reach(Phase::needs_image));
  rig.run(5s);
  EXPECT_EQ(rig.session.phase(), Phase::needs_image);
  rig.session.give_image(image());
  EXPECT_TRUE(rig.reach(Phase::homing));
}

TEST(FalconSession, a_wrong_echo_ends_the_attempt_and_the_next_one_succeeds) {
  for (const std::size_t at : {0u, 1u, 61u, 62u, 63u, 2500u, 5039u}) {
    Rig rig;
    rig.session.give_image(image());
    rig.falcon.spoil_echo_at(at);
    while (rig.session.state().attempt == 0 && rig.session.phase() != Phase::homing) rig.once(rig.link.now() + 1s);
    EXPECT_EQ(rig.session.state().trouble, Trouble::wrong_echo) << at;
    ASSERT_TRUE(rig.reach(Phase::homing)) << at;
    EXPECT_EQ(rig.falcon.loaded_words(), 2500u);
  }
}

TEST(FalconSession, an_echo_that_stays_away_ends_the_attempt_and_the_next_one_succeeds) {
  Rig rig;
  rig.session.give_image(image());
  rig.falcon.swallow_echo_at(3000);
  while (rig.session.state().attempt == 0 && rig.session.phase() != Phase::homing) rig.once(rig.link.now() + 1s);
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_echo);
  EXPECT_TRUE(rig.reach(Phase::homing));
}

TEST(FalconSession, hellos_that_nobody_hears_are_sent_again) {
  Rig rig;
  rig.session.give_image(image());
  rig.falcon.ignore_hellos(4);  // three in the first attempt, one in the second
  ASSERT_TRUE(rig.reach(Phase::homing));
  EXPECT_TRUE(rig.falcon.firmware_running());
}

TEST(FalconSession, a_bridge_that_keeps_another_speed_fails_and_forces_nothing) {
  Rig rig;
  rig.session.give_image(image());
  rig.falcon.control(ftdi::kBaudRun, rig.link.now());
  rig.falcon.stick_speed(true);
  EXPECT_TRUE(rig.reach(Phase::failed, 300s));
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_hello);
  EXPECT_EQ(rig.session.state().attempt, 10);
  EXPECT_FALSE(rig.forced_ever);
  rig.run(4s);
  EXPECT_EQ(rig.session.phase(), Phase::failed);  // rests
  rig.falcon.stick_speed(false);
  EXPECT_TRUE(rig.reach(Phase::homing, 30s));
}

TEST(FalconSession, rests_no_longer_when_it_is_asked_again) {
  Rig rig({.powered = false});
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::failed, 300s));
  rig.falcon.restore_power();
  const LinkTime asked = rig.link.now();
  rig.session.retry();
  EXPECT_TRUE(rig.reach(Phase::homing, 30s));
  EXPECT_LT(rig.link.now() - asked, 4s);
}

TEST(FalconSession, probes_that_nobody_answered_take_no_place_in_the_window) {
  Rig rig;
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::homing));
  const auto lost = rig.session.state().lost;
  EXPECT_EQ(lost, 10u);  // the ten probes before the upload
  rig.home();
  rig.run(1s);
  EXPECT_EQ(rig.session.state().lost, lost);
}

TEST(FalconSession, firmware_that_hangs_after_the_upload_is_loaded_again) {
  Rig rig;
  rig.session.give_image(image());
  rig.falcon.hang_after_load(true);
  while (rig.session.state().attempt == 0 && rig.session.phase() != Phase::homing) rig.once(rig.link.now() + 1s);
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_answer);
  rig.falcon.hang_after_load(false);
  EXPECT_TRUE(rig.reach(Phase::homing));
}

TEST(FalconSession, a_falcon_without_its_adapter_answers_no_hello) {
  Rig rig({.powered = false});
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::failed, 300s));
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_hello);
}

TEST(FalconSession, refused_requests_end_the_attempt) {
  for (const std::uint8_t request : {0x00, 0x01, 0x02, 0x03, 0x04, 0x09}) {
    Rig rig;
    rig.session.give_image(image());
    rig.falcon.refuse(request);
    while (rig.session.state().attempt == 0 && rig.session.phase() != Phase::homing) rig.once(rig.link.now() + 1s);
    EXPECT_EQ(rig.session.state().trouble, Trouble::link_failed) << int(request);
    rig.falcon.refuse(0xFF);
    EXPECT_TRUE(rig.reach(Phase::homing)) << int(request);
  }
}

TEST(FalconSession, a_device_that_may_not_be_opened_reports_why_and_is_tried_again) {
  for (const auto& [presence, trouble] :
       {std::pair{Presence::absent, Trouble::absent}, std::pair{Presence::denied, Trouble::denied},
        std::pair{Presence::busy, Trouble::busy}}) {
    Rig rig({.firmware_running = true});
    rig.link.set_presence(presence);
    rig.run(1900ms);
    EXPECT_EQ(rig.session.phase(), Phase::unplugged);
    EXPECT_EQ(rig.session.state().trouble, trouble);
    rig.link.set_presence(Presence::here);
    EXPECT_TRUE(rig.reach(Phase::homing, 2s));
    EXPECT_EQ(rig.session.state().trouble, Trouble::none);
  }
}

TEST(FalconSession, unplugged_at_any_step_it_comes_back_by_itself) {
  // How many asks an undisturbed start takes.
  Rig whole;
  whole.session.give_image(image());
  ASSERT_TRUE(whole.reach(Phase::homing));
  const int asks = whole.link.asks();
  ASSERT_GT(asks, 100);
  for (int at = 0; at <= asks + 5; ++at) {
    Rig rig;
    rig.session.give_image(image());
    rig.link.unplug_after(at);
    for (int i = 0; i < 100000 && rig.link.presence() == Presence::here; ++i) {
      if (rig.session.phase() == Phase::homing) {
        rig.run(1ms);
      } else {
        rig.once(rig.link.now() + 1s);
      }
    }
    rig.once(rig.link.now() + 1ms);
    ASSERT_EQ(rig.session.phase(), Phase::unplugged) << at;
    ASSERT_EQ(rig.session.state().trouble, Trouble::absent) << at;
    rig.run(700ms);
    ASSERT_EQ(rig.session.phase(), Phase::unplugged) << at;
    rig.link.set_presence(Presence::here);
    ASSERT_TRUE(rig.reach(Phase::homing)) << at;
    ASSERT_TRUE(rig.falcon.firmware_running()) << at;
    ASSERT_FALSE(rig.forced_ever) << at;
  }
}

}  // namespace
}  // namespace cusp::device::falcon
