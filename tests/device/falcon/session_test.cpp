// The state machine with an emulated Falcon and a clock that stands still until somebody waits.
#include "device/falcon/session.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/device/falcon/rig.h"

namespace cusp::falcon {
namespace {

using testing::image;
using testing::Rig;
using namespace std::chrono_literals;

constexpr std::array<std::int16_t, 3> kNoTorque{};

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
  EXPECT_EQ(rig.session.state().sent, 4u);
  EXPECT_FALSE(rig.seen.contains(Phase::arming));
}

TEST(FalconSession, waits_for_an_image_and_goes_on_when_one_is_given) {
  Rig rig;
  ASSERT_TRUE(rig.reach(Phase::needs_image));
  rig.run(5s);
  EXPECT_EQ(rig.session.phase(), Phase::needs_image);
  rig.session.give_image(image());
  EXPECT_TRUE(rig.reach(Phase::homing));
}

TEST(FalconSession, torque_grows_from_zero_over_half_a_second) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  const LinkTime start = rig.link.now();
  int before = 0;
  while (rig.link.now() < start + 600ms) {
    rig.run(1ms, {4000, 0, 0});
    const int now = rig.session.last_torque()[0];
    EXPECT_GE(now, before);
    EXPECT_LE(now - before, 60);  // 4000 counts over 500 ms is 8 a tick; a tick that was skipped makes it more
    const double due = 8.0 * static_cast<double>((rig.link.now() - start) / 1ms);
    EXPECT_LE(now, due + 60);
    before = now;
  }
  EXPECT_EQ(before, 4000);
  rig.session.restart_ramp(rig.link.now());
  rig.run(2ms, {4000, 0, 0});
  EXPECT_LT(rig.session.last_torque()[0], 60);
}

TEST(FalconSession, torque_beyond_the_limit_is_cut) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.run(600ms, {32767, -32768, 4096});
  EXPECT_EQ(rig.session.last_torque(), (std::array<std::int16_t, 3>{4095, -4095, 4095}));
}

TEST(FalconSession, frames_that_come_in_pieces_are_put_together) {
  // A late bridge: packets are cut wherever its timer falls.
  Rig rig({.firmware_running = true, .answer_delay = 900us});
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::homing));
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.run(2s);
  EXPECT_EQ(rig.session.state().dropped_bytes, 0u);
  EXPECT_EQ(rig.session.state().silences, 0u);
  EXPECT_GT(rig.session.state().replies, 1800u);
}

TEST(FalconSession, every_split_of_an_answer_reads_the_same) {
  const Frame answer{{100, -200, 300}, status::kHomed | status::kPlus};
  const auto bytes = encode(answer);
  for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
    Rig rig({.firmware_running = true});
    rig.reach(Phase::homing);
    for (int i = 0; i < 8; ++i) {
      for (const auto part : {std::span(bytes).first(cut), std::span(bytes).subspan(cut)}) {
        std::vector<std::uint8_t> packet = {0x01, 0x60};
        packet.insert(packet.end(), part.begin(), part.end());
        rig.session.advance({.kind = LinkEvent::Kind::received, .bytes = packet}, rig.link.now());
        const std::uint8_t idle[] = {0x01, 0x60};
        rig.session.advance({.kind = LinkEvent::Kind::received, .bytes = idle}, rig.link.now());
      }
    }
    ASSERT_EQ(rig.session.phase(), Phase::ready) << cut;
    EXPECT_EQ(rig.session.state().encoders, answer.words);
    EXPECT_EQ(rig.session.state().buttons, status::kPlus);
  }
}

TEST(FalconSession, a_fragment_of_14_bytes_homes_nothing_and_presses_nothing) {
  Rig rig({.firmware_running = true});
  ASSERT_TRUE(rig.reach(Phase::homing));
  rig.falcon.cut_answers(200, 14);
  rig.run(150ms);
  EXPECT_EQ(rig.session.state().homed, 0);
  EXPECT_EQ(rig.session.state().buttons, 0);
  EXPECT_FALSE(rig.forced_ever);
  EXPECT_EQ(rig.session.phase(), Phase::silent);  // no whole answer for 10 ms
  EXPECT_TRUE(rig.reach(Phase::homing, 2s));      // whole ones again
}

TEST(FalconSession, packets_of_status_alone_are_no_answers) {
  Rig rig({.firmware_running = true});
  ASSERT_TRUE(rig.reach(Phase::homing));
  const auto before = rig.session.state().replies;
  for (int i = 0; i < 100; ++i) {
    const std::uint8_t idle[] = {0x01, 0x60};
    rig.session.advance({.kind = LinkEvent::Kind::received, .bytes = idle}, rig.link.now());
  }
  EXPECT_EQ(rig.session.state().replies, before);
  EXPECT_EQ(rig.session.phase(), Phase::homing);
}

TEST(FalconSession, ten_milliseconds_of_silence_take_the_force_away) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.run(1s);
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.falcon.fall_mute(true);
  const LinkTime mute = rig.link.now();
  while (rig.session.phase() == Phase::ready && rig.link.now() < mute + 1s) rig.run(1ms);
  EXPECT_EQ(rig.session.phase(), Phase::silent);
  EXPECT_LE(rig.link.now() - mute, 12ms);
  EXPECT_EQ(rig.session.last_torque(), kNoTorque);
  rig.run(100ms);
  EXPECT_EQ(rig.falcon.torque_words(rig.link.now()), kNoTorque);  // zeros went out, although nothing came back
  rig.falcon.fall_mute(false);
  ASSERT_TRUE(rig.reach(Phase::homing, 1s));
  rig.run(12ms);  // still homed: the device kept its zero
  EXPECT_EQ(rig.session.phase(), Phase::ready);
  EXPECT_LT(std::abs(rig.session.last_torque()[0]), 60);  // and the force begins at zero again
  EXPECT_FALSE(rig.forced);
  EXPECT_EQ(rig.session.state().silences, 1u);
}

TEST(FalconSession, a_lost_answer_now_and_then_stops_nothing) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  for (int i = 0; i < 200; ++i) {
    rig.falcon.lose_answers(1);
    rig.run(20ms);
    ASSERT_EQ(rig.session.phase(), Phase::ready) << i;
  }
  // 4,000 ms, 200 answers lost: each may cost the exchanges of a few milliseconds, not more.
  EXPECT_GT(rig.session.state().replies, 3000u);
}

TEST(FalconSession, a_long_silence_begins_with_the_line_again_and_uploads_if_the_power_was_lost) {
  Rig rig;
  rig.session.give_image(image());
  rig.reach(Phase::homing);
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.falcon.cut_power();  // the adapter: the bridge lives on
  rig.run(50ms);
  EXPECT_EQ(rig.session.phase(), Phase::silent);
  rig.falcon.restore_power();
  rig.seen.clear();
  ASSERT_TRUE(rig.reach(Phase::homing));
  EXPECT_TRUE(rig.seen.contains(Phase::settling));
  EXPECT_TRUE(rig.seen.contains(Phase::uploading));
  rig.run(300ms);
  EXPECT_EQ(rig.session.phase(), Phase::homing);  // the zero is lost: a hand has to find it
  EXPECT_FALSE(rig.forced);
}

TEST(FalconSession, homing_lost_takes_the_force_away_at_once) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.run(1s);
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.falcon.lose_homing();
  rig.run(3ms);
  EXPECT_EQ(rig.session.phase(), Phase::homing);
  EXPECT_EQ(rig.session.last_torque(), kNoTorque);
  rig.run(200ms);
  EXPECT_EQ(rig.session.phase(), Phase::homing);
  EXPECT_FALSE(rig.forced);
  rig.home();
  EXPECT_EQ(rig.session.phase(), Phase::ready);
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

TEST(FalconSession, hellos_that_nobody_hears_are_said_again) {
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

TEST(FalconSession, a_wish_from_before_a_silence_is_forgotten) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.run(1s);
  rig.falcon.fall_mute(true);
  rig.run(50ms);
  ASSERT_EQ(rig.session.phase(), Phase::silent);
  rig.falcon.fall_mute(false);
  ASSERT_TRUE(rig.reach(Phase::homing, 1s));
  for (int i = 0; i < 700; ++i) {  // exchanges without a command, as before a loop's first step
    const LinkTime tick = rig.link.now() + 1ms;
    while (rig.link.now() < tick) rig.once(tick);
    rig.session.exchange(rig.link.now());
    rig.hand_over();
    ASSERT_EQ(rig.session.last_torque(), kNoTorque);
  }
  EXPECT_EQ(rig.session.phase(), Phase::ready);
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

TEST(FalconSession, a_falcon_without_its_adapter_says_no_hello) {
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

TEST(FalconSession, sends_that_fail_end_the_attempt) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.link.fail_sends(true);
  rig.run(5ms);
  EXPECT_NE(rig.session.phase(), Phase::ready);
  EXPECT_EQ(rig.session.state().trouble, Trouble::link_failed);
  rig.link.fail_sends(false);
  EXPECT_TRUE(rig.reach(Phase::homing));
}

TEST(FalconSession, a_device_that_may_not_be_opened_says_why_and_is_tried_again) {
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

TEST(FalconSession, unplugged_while_forcing_it_forces_again_only_from_zero) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.run(1s);
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.link.set_presence(Presence::absent);
  rig.run(5ms);
  EXPECT_EQ(rig.session.phase(), Phase::unplugged);
  EXPECT_EQ(rig.session.last_torque(), kNoTorque);
  EXPECT_EQ(rig.session.state().buttons, 0);
  rig.run(300ms);
  EXPECT_EQ(rig.falcon.torque_words(rig.link.now()), kNoTorque);  // the device's own hold time-out
  rig.link.set_presence(Presence::here);
  ASSERT_TRUE(rig.reach(Phase::homing, 5s));
  rig.run(15ms);
  EXPECT_EQ(rig.session.phase(), Phase::ready);  // the adapter kept it running and homed
  EXPECT_LT(std::abs(rig.session.last_torque()[0]), 100);
  EXPECT_FALSE(rig.forced);
}

TEST(FalconSession, buttons_are_told_and_released_when_reports_stop) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.falcon.set_buttons(status::kPlus | status::kMinus);
  rig.run(5ms);
  EXPECT_EQ(rig.session.state().buttons, status::kPlus | status::kMinus);
  rig.falcon.fall_mute(true);
  rig.run(20ms);
  EXPECT_EQ(rig.session.state().buttons, 0);
}

TEST(FalconSession, the_colours_that_were_asked_for_are_lit_while_ready) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  rig.session.set_leds(control::kGreen | 0xF0);
  rig.run(5ms);
  EXPECT_EQ(rig.falcon.leds(), control::kGreen);
}

TEST(FalconSession, never_more_than_two_packets_are_unanswered) {
  Rig rig({.firmware_running = true});
  ASSERT_TRUE(rig.reach(Phase::homing));
  rig.falcon.fall_mute(true);
  int sent = 0;
  for (int i = 0; i < 3; ++i) sent += rig.session.exchange(rig.link.now());
  EXPECT_EQ(sent, 2);
}

TEST(FalconSession, a_bridge_set_to_pass_on_each_frame_works_alike) {
  Rig rig({}, {}, {.event_character = true});
  rig.session.give_image(image());
  ASSERT_TRUE(rig.reach(Phase::homing));
  rig.home();
  rig.run(1s);
  EXPECT_EQ(rig.session.phase(), Phase::ready);
  EXPECT_GT(rig.session.state().replies, 950u);
}

}  // namespace
}  // namespace cusp::falcon
