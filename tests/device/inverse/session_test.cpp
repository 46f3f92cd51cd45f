// The right next state for what the service does and does not do, under a clock in hand. No force whenever in doubt.
#include "device/inverse/inverse_session.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/full_run.h"

namespace cusp::device::inverse {
namespace {

using cusp::test::full_run;
using namespace std::chrono_literals;

std::string place(double x, const char* id = "049D") {
  return R"({"inverse3":[{"device_id":")" + std::string(id) + R"(","state":{"cursor_position":{"x":)" + std::to_string(x) +
         R"(,"y":0,"z":0.1}}}]})";
}

/// The same, with the report of a handle.
std::string place_with_handle(double x) {
  std::string out = place(x);
  out.pop_back();
  return out + R"(,"wireless_verse_grip":[{"state":{"orientation":{"x":0,"y":0,"z":0,"w":1}}}]})";
}

struct Rig {
  Session session;
  std::string answer = place(0.01);
  LinkTime now{std::chrono::hours(1)};

  explicit Rig(const std::string& device = {}) : session({}, device) {}
  void event(LinkEvent::Kind kind, const std::string& text = {}) { session.advance({kind, text}, now); }
  void pass(std::chrono::milliseconds time) {
    for (auto left = time; left > 0ms; left -= 1ms) {
      now += 1ms;
      event(LinkEvent::Kind::time);
    }
  }
  Session::LinkRequest request() { return session.take_request(now); }
  Phase phase() const { return session.state().phase; }
  /// The force of the message that is due; nothing when none is.
  std::optional<double> sent() {
    const auto message = session.take_message(now);
    if (!message) return std::nullopt;
    return nlohmann::json::parse(*message)["inverse3"][0]["commands"]["set_cursor_force"]["values"]["x"].get<double>();
  }
  void make_ready() {
    EXPECT_EQ(request(), Session::LinkRequest::open);
    event(LinkEvent::Kind::opened);
    event(LinkEvent::Kind::message, place(0.01));
    now += 1ms;
    EXPECT_EQ(phase(), Phase::ready);
  }
  /// One exchange a millisecond, with one newton wanted all the time.
  std::optional<double> exchange() {
    session.command({1, 0, 0}, now);
    const auto force = sent();
    event(LinkEvent::Kind::message, answer);
    now += 1ms;
    return force;
  }
};

/// What the hand feels while one newton is wanted: near zero at first, all of it only after the ramp of 500 ms.
void expect_it_rises_from_zero(Rig& rig) {
  for (int i = 0; i < 500; ++i) {
    const double force = rig.exchange().value();
    ASSERT_LE(force, 0.002 * (i + 1) + 1e-9) << i;  // 1 N in 500 ms, from at most 1 ms before
  }
  rig.exchange();
  EXPECT_DOUBLE_EQ(rig.exchange().value(), 1.0);
}

TEST(InverseSession, the_first_place_makes_it_ready_and_the_force_rises) {
  Rig rig;
  EXPECT_EQ(rig.phase(), Phase::closed);
  rig.make_ready();
  EXPECT_EQ(rig.session.state().device, "049D");
  const auto first = rig.exchange();
  ASSERT_TRUE(first);
  EXPECT_LT(*first, 0.01);
  double last = *first;
  for (int i = 0; i < 499; ++i) {
    const double force = rig.exchange().value();
    EXPECT_GE(force, last);
    EXPECT_LE(force - last, 0.0025);  // 1 N in 500 ms, a step of 1 ms
    last = force;
  }
  EXPECT_DOUBLE_EQ(rig.exchange().value(), 1.0);
}

TEST(InverseSession, asks_once_for_each_answer_and_no_faster_than_its_pace) {
  Rig rig;
  rig.make_ready();
  EXPECT_TRUE(rig.sent());
  EXPECT_FALSE(rig.sent());  // it has to answer first
  rig.event(LinkEvent::Kind::message, place(0.02));
  EXPECT_FALSE(rig.sent());  // not within the same millisecond
  rig.now += 1ms;
  EXPECT_TRUE(rig.sent());
}

TEST(InverseSession, nobody_listening_is_tried_again_after_a_pause) {
  Rig rig;
  EXPECT_EQ(rig.request(), Session::LinkRequest::open);
  rig.event(LinkEvent::Kind::refused);
  EXPECT_EQ(rig.phase(), Phase::pausing);
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_service);
  EXPECT_EQ(rig.request(), Session::LinkRequest::close);
  rig.pass(499ms);
  EXPECT_EQ(rig.request(), Session::LinkRequest::none);
  rig.pass(1ms);
  EXPECT_EQ(rig.request(), Session::LinkRequest::open);
  EXPECT_EQ(rig.phase(), Phase::connecting);
  rig.pass(2000ms);  // neither opened nor refused
  EXPECT_EQ(rig.phase(), Phase::pausing);
}

TEST(InverseSession, silence_takes_the_force_away_and_an_answer_lets_it_rise_anew) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  rig.session.command({1, 0, 0}, rig.now);
  EXPECT_DOUBLE_EQ(rig.sent().value(), 1.0);
  rig.pass(19ms);
  EXPECT_EQ(rig.phase(), Phase::ready);
  rig.pass(1ms);
  EXPECT_EQ(rig.phase(), Phase::silent);
  EXPECT_EQ(rig.session.state().silences, 1u);
  rig.session.command({1, 0, 0}, rig.now);
  EXPECT_EQ(rig.session.due(), rig.now - 20ms + 1ms);  // nothing waits: one message of no force leaves at once
  EXPECT_EQ(rig.sent(), 0.0);
  EXPECT_FALSE(rig.sent());
  rig.pass(99ms);
  EXPECT_FALSE(rig.sent());
  rig.pass(1ms);  // and another 100 ms after it
  EXPECT_EQ(rig.sent(), 0.0);
  rig.event(LinkEvent::Kind::message, place(0.03));
  EXPECT_EQ(rig.phase(), Phase::ready);
  rig.now += 1ms;
  EXPECT_LT(rig.exchange().value(), 0.01);
}

TEST(InverseSession, a_force_that_nobody_renews_is_none) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  for (int i = 0; i < 25; ++i) {
    const auto force = rig.sent();
    if (i == 15) {
      EXPECT_DOUBLE_EQ(force.value(), 1.0);
    } else if (i == 24) {
      EXPECT_DOUBLE_EQ(force.value(), 0.0);
    }
    rig.event(LinkEvent::Kind::message, place(0.01));
    rig.now += 1ms;
  }
}

TEST(InverseSession, after_a_stall_of_the_loop_the_force_rises_anew) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  for (int i = 0; i < 30; ++i) {  // the service answers on, the loop writes nothing
    rig.sent();
    rig.event(LinkEvent::Kind::message, place(0.01));
    rig.now += 1ms;
  }
  EXPECT_EQ(rig.phase(), Phase::ready);
  expect_it_rises_from_zero(rig);
}

TEST(InverseSession, after_a_time_without_a_force_it_rises_anew) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  LinkTime held{};
  for (int i = 0; i < 100; ++i) {  // the clutch, or a latched guard
    held = rig.now;
    rig.session.command({0, 0, 0}, held, held);
    EXPECT_EQ(rig.sent().value(), 0.0);
    rig.event(LinkEvent::Kind::message, place(0.01));
    rig.now += 1ms;
  }
  rig.session.command({1, 0, 0}, rig.now, held);
  EXPECT_NEAR(rig.sent().value(), 0.002, 1e-9);  // 1 ms of 500
  rig.event(LinkEvent::Kind::message, place(0.01));
  rig.now += 1ms;
  rig.session.command({1, 0, 0}, rig.now, held - 1h);  // an older time changes nothing
  EXPECT_NEAR(rig.sent().value(), 0.004, 1e-9);
  rig.event(LinkEvent::Kind::message, place(0.01));
  rig.now += 1ms;
  for (int ms = 3; ms < 500; ++ms) EXPECT_LT(rig.exchange().value(), 1.0) << ms;
  EXPECT_DOUBLE_EQ(rig.exchange().value(), 1.0);
}

TEST(InverseSession, one_that_stays_silent_is_gone_and_opened_anew) {
  Rig rig;
  rig.make_ready();
  EXPECT_TRUE(rig.sent());
  rig.pass(2100ms);
  EXPECT_EQ(rig.phase(), Phase::pausing);
  EXPECT_EQ(rig.session.state().trouble, Trouble::gone);
  EXPECT_EQ(rig.request(), Session::LinkRequest::close);
  rig.pass(500ms);
  EXPECT_EQ(rig.request(), Session::LinkRequest::open);
}

TEST(InverseSession, an_answer_without_a_place_is_no_place_to_push_from) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  for (const char* state : {"null", "{}", R"({"cursor_position":null})"}) {
    rig.event(LinkEvent::Kind::message, R"({"inverse3":[{"device_id":"049D","state":)" + std::string(state) + "}]}");
    EXPECT_EQ(rig.phase(), Phase::silent) << state;
    rig.session.command({1, 0, 0}, rig.now);
    EXPECT_EQ(rig.sent(), 0.0) << state;
    rig.event(LinkEvent::Kind::message, place(0.01));
    EXPECT_EQ(rig.phase(), Phase::ready) << state;
    rig.now += 1ms;
    expect_it_rises_from_zero(rig);
  }
}

TEST(InverseSession, without_the_reports_of_the_handle_that_turned_the_bur_there_is_no_place_to_push_from) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  EXPECT_EQ(rig.phase(), Phase::ready) << "no handle is none that is lost";
  rig.event(LinkEvent::Kind::message, place_with_handle(0.01));
  rig.now += 1ms;
  for (int ms = 1; ms < 100; ++ms) {
    rig.exchange();
    ASSERT_EQ(rig.phase(), Phase::ready) << ms;
  }
  rig.exchange();
  const std::uint64_t readings = rig.session.state().readings;
  for (int i = 0; i < 3000; ++i) {  // longer than it takes to give up a silent service
    ASSERT_EQ(rig.phase(), Phase::silent) << i;
    ASSERT_EQ(rig.exchange(), 0.0) << i;
    rig.event(LinkEvent::Kind::time);
  }
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_handle);
  EXPECT_EQ(rig.session.state().readings, readings);
  rig.answer = place_with_handle(0.01);
  rig.event(LinkEvent::Kind::message, rig.answer);
  EXPECT_EQ(rig.phase(), Phase::ready);
  EXPECT_EQ(rig.session.state().trouble, Trouble::none);
  rig.now += 1ms;
  expect_it_rises_from_zero(rig);
}

TEST(InverseSession, a_service_that_comes_back_without_the_handle_is_not_ready_before_it_reports) {
  Rig rig;
  rig.make_ready();
  rig.event(LinkEvent::Kind::message, place_with_handle(0.01));
  rig.event(LinkEvent::Kind::closed);
  EXPECT_EQ(rig.request(), Session::LinkRequest::close);
  rig.pass(500ms);
  EXPECT_EQ(rig.request(), Session::LinkRequest::open);
  rig.event(LinkEvent::Kind::opened);
  rig.event(LinkEvent::Kind::message, place(0.01));
  EXPECT_EQ(rig.phase(), Phase::greeting);
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_handle);
  rig.event(LinkEvent::Kind::message, place_with_handle(0.01));
  EXPECT_EQ(rig.phase(), Phase::ready);
}

TEST(InverseSession, garbage_is_no_place_to_push_from_and_too_much_of_it_closes) {
  Rig rig;
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  rig.event(LinkEvent::Kind::message, "}{");
  EXPECT_EQ(rig.phase(), Phase::silent);
  rig.session.command({1, 0, 0}, rig.now);
  EXPECT_EQ(rig.sent(), 0.0);
  rig.event(LinkEvent::Kind::message, place(0.01));
  EXPECT_EQ(rig.phase(), Phase::ready);
  EXPECT_EQ(rig.session.state().unread, 1u);
  for (int i = 0; i < 49; ++i) rig.event(LinkEvent::Kind::message, "no");
  EXPECT_EQ(rig.phase(), Phase::silent);
  rig.event(LinkEvent::Kind::message, "no");
  EXPECT_EQ(rig.phase(), Phase::pausing);
  EXPECT_EQ(rig.session.state().trouble, Trouble::garbage);
}

TEST(InverseSession, a_service_without_the_device_is_no_device_and_wakes_once_to_give_up) {
  for (const std::string& text : {std::string("{}"), place(0.01, "")}) {  // the second names none
    Rig none;
    none.request();
    none.event(LinkEvent::Kind::opened);
    none.event(LinkEvent::Kind::message, text);
    EXPECT_FALSE(none.sent()) << text;
    none.now = none.session.due();  // it sleeps until it gives up
    none.event(LinkEvent::Kind::time);
    EXPECT_EQ(none.phase(), Phase::pausing) << text;
    EXPECT_EQ(none.session.state().trouble, Trouble::no_device) << text;
  }
  Rig other("ABCD");
  other.request();
  other.event(LinkEvent::Kind::opened);
  other.event(LinkEvent::Kind::message, place(0.01));
  EXPECT_EQ(other.phase(), Phase::greeting);
  other.event(LinkEvent::Kind::message, place(0.01, "ABCD"));
  EXPECT_EQ(other.phase(), Phase::ready);
  Rig mute;
  mute.request();
  mute.event(LinkEvent::Kind::opened);
  mute.pass(2000ms);
  EXPECT_EQ(mute.session.state().trouble, Trouble::no_answer);
}

TEST(InverseSession, a_device_that_vanishes_from_the_list_is_silent_and_then_gone) {
  Rig rig;
  rig.make_ready();
  EXPECT_TRUE(rig.sent());
  rig.event(LinkEvent::Kind::message, R"({"inverse3":[]})");
  rig.pass(20ms);
  EXPECT_EQ(rig.phase(), Phase::silent);
  rig.pass(2000ms);
  EXPECT_EQ(rig.session.state().trouble, Trouble::gone);
}

TEST(InverseSession, the_other_side_going_away_is_loss_in_every_phase) {
  for (const int messages : {0, 1}) {
    Rig rig;
    rig.request();
    rig.event(LinkEvent::Kind::opened);
    if (messages == 1) rig.event(LinkEvent::Kind::message, place(0.01));
    rig.event(LinkEvent::Kind::closed);
    EXPECT_EQ(rig.phase(), Phase::pausing);
    EXPECT_EQ(rig.session.state().trouble, Trouble::gone);
    EXPECT_FALSE(rig.sent());
  }
}

TEST(InverseSession, after_a_loss_another_device_does_not_take_the_place_of_the_first) {
  Rig rig;
  rig.make_ready();
  rig.event(LinkEvent::Kind::closed);
  EXPECT_EQ(rig.request(), Session::LinkRequest::close);
  rig.pass(500ms);
  EXPECT_EQ(rig.request(), Session::LinkRequest::open);
  rig.event(LinkEvent::Kind::opened);
  rig.event(LinkEvent::Kind::message, place(0.01, "ABCD"));
  EXPECT_EQ(rig.phase(), Phase::greeting);
  EXPECT_EQ(rig.session.state().trouble, Trouble::no_device);
  rig.session.command({1, 0, 0}, rig.now);
  EXPECT_FALSE(rig.sent());
  rig.event(LinkEvent::Kind::message, place(0.01));
  EXPECT_EQ(rig.phase(), Phase::ready);
  EXPECT_EQ(rig.session.state().device, "049D");
}

TEST(InverseSession, its_closing_message_commands_zero_force) {
  Rig rig;
  EXPECT_FALSE(rig.session.closing_message());
  rig.make_ready();
  for (int i = 0; i < 600; ++i) rig.exchange();
  const auto closing = nlohmann::json::parse(rig.session.closing_message().value());
  EXPECT_EQ(closing["inverse3"][0]["commands"]["set_cursor_force"]["values"]["x"], 0.0);
}

TEST(InverseSession, whatever_happens_there_is_force_in_ready_alone_and_never_too_much) {
  std::mt19937 random(5);
  const std::string texts[] = {place(0.01), place(0.02), place(0.01, "ABCD"), "{}", "[]", "\xff", R"({"inverse3":[{"device_id":"049D"}]})"};
  Rig rig;
  double last = 0;
  std::uint64_t forced = 0;
  const int steps = full_run() ? 1'000'000 : 200'000;
  for (int i = 0; i < steps; ++i) {
    const unsigned what = random() % 1000;
    rig.request();
    if (what < 900) {
      rig.event(LinkEvent::Kind::message, texts[what < 880 ? 0 : random() % std::size(texts)]);
    } else {
      rig.event(what < 930   ? LinkEvent::Kind::opened
                : what < 931 ? LinkEvent::Kind::closed
                : what < 932 ? LinkEvent::Kind::refused
                             : LinkEvent::Kind::time);
    }
    if (random() % 50 != 0) rig.session.command({random() % 7 == 0 ? std::nan("") : 1.0, 0, 0}, rig.now);
    const Phase phase = rig.phase();
    if (const auto message = rig.session.take_message(rig.now)) {
      const double force = rig.session.state().force_n;
      ASSERT_TRUE(force == 0 || phase == Phase::ready);
      ASSERT_LE(force, 1.0);
      if (last == 0 && phase == Phase::ready) forced += force > 0;
      last = force;
    }
    rig.now += std::chrono::microseconds(random() % 2000);
  }
  EXPECT_GT(forced, static_cast<std::uint64_t>(steps) / 10'000);
}

}  // namespace
}  // namespace cusp::device::inverse
