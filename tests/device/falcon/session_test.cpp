// The state machine with an emulated Falcon and a clock that stands still until somebody waits: exchanges, silences,
// torque. How it comes to answer is in session_start_test.cpp.
#include "device/falcon/session.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/device/falcon/rig.h"

namespace cusp::device::falcon {
namespace {

using test::image;
using test::Rig;
using namespace std::chrono_literals;

constexpr std::array<std::int16_t, 3> kNoTorque{};

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

TEST(FalconSession, frames_that_come_in_parts_are_joined) {
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
      rig.session.exchange(rig.link.now());  // what comes is the answer to this
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
  rig.falcon.cut_answers(0, 14);                  // whole ones again
  EXPECT_TRUE(rig.reach(Phase::homing, 2s));
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

TEST(FalconSession, a_lost_answer_stops_nothing_and_many_drain_the_line) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  const auto before = rig.session.state();
  for (int i = 0; i < 2; ++i) {
    rig.falcon.lose_answers(1);
    rig.run(1s);
    ASSERT_EQ(rig.session.phase(), Phase::ready) << i;
  }
  // 2,000 ms: a lost answer may cost the exchanges of a few milliseconds.
  EXPECT_GT(rig.session.state().replies - before.replies, 1950u);
  EXPECT_EQ(rig.session.state().silences, before.silences);
  for (int i = 0; i < 20; ++i) {
    rig.falcon.lose_answers(1);
    rig.run(1s);
    EXPECT_EQ(rig.session.phase(), Phase::ready) << i;  // never for good: a silence is over within 0.6 s
  }
  EXPECT_GT(rig.session.state().silences, before.silences);
  EXPECT_LE(rig.session.state().silences - before.silences, 10u);
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

TEST(FalconSession, firmware_that_answers_again_after_a_long_silence_needs_no_image) {
  Rig rig({.firmware_running = true});
  rig.reach(Phase::homing);
  rig.home();
  ASSERT_EQ(rig.session.phase(), Phase::ready);
  rig.falcon.fall_mute(true);
  rig.run(50ms);
  ASSERT_TRUE(rig.reach(Phase::needs_image));
  rig.falcon.fall_mute(false);
  EXPECT_TRUE(rig.reach(Phase::homing, 5s));
  rig.run(1s);
  EXPECT_EQ(rig.session.phase(), Phase::ready);  // it has kept its zero
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

TEST(FalconSession, buttons_are_reported_and_released_when_reports_stop) {
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
}  // namespace cusp::device::falcon
