// The port on a line that delays, stalls, loses, doubles and spoils: whatever it does, no torque leaves and no place is
// reported that rests on an answer of more than 10 ms ago, and when it is well again so is the port.
// ./check runs the first 500 seconds of link time. CUSP_LINK_SECONDS=100000 runs more, CUSP_LINK_SEED begins there (and
// runs that seed alone without CUSP_LINK_SECONDS), CUSP_LINK_ONCE=1 leaves out answers that come twice.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "device/falcon/falcon_port.h"
#include "tests/device/falcon/rough_link.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using namespace std::chrono_literals;
using falcon::LinkTime;
using test::RoughLink;
using test::Truth;
using test::Weather;

constexpr LinkTime kFresh = 10ms;
constexpr LinkTime kWithin = 600ms;  // from the end of a spell to the next fresh sample; measured: see the output
constexpr double kHandMPerS = falcon::Reach::kMostMPerS;
constexpr double kGripMPerS = 0.9;   // RoughLink's grip, at the most
constexpr double kStepM = 2e-4;      // the guard's step and the encoders' own rounding

struct Count {
  std::uint64_t packets = 0, torque = 0, fresh = 0, spells = 0;
  std::uint64_t old_torque = 0, old_samples = 0, reported = 0, unknown = 0, wrong_places = 0, late_recoveries = 0;
  std::uint64_t stale = 0, unasked = 0, flawed = 0, unreached = 0, lost = 0, silences = 0;
  LinkTime oldest_torque{0}, oldest_sample{0}, longest_recovery{0};
  double farthest_m = 0;
  std::uint64_t violations() const {
    return old_torque + old_samples + reported + unknown + wrong_places + late_recoveries;
  }
};

/// Whether the line may deliver an answer twice.
enum class Answers : std::uint8_t { once, may_repeat };

/// One seed: ten seconds of spells of bad weather with calm between them.
class Voyage {
 public:
  Voyage(std::uint64_t seed, Answers answers, Count& count) : random_(seed * 7919 + 17), answers_(answers), count_(count) {
    auto made = std::make_unique<RoughLink>(seed);
    link_ = made.get();
    port_ = std::make_unique<FalconPort>(std::move(made));
    link_->on_packet([this](const std::array<std::int16_t, 3>& torque) { check(torque); });
  }
  void sail(LinkTime time) {
    ASSERT_TRUE(port_->open());
    for (int i = 0; i < 2000 && !rests_on_; ++i) tick();
    const LinkTime end = link_->now() + time;
    while (link_->now() < end) {
      run(700ms + some(400ms));  // calm: past the ramp of the torque, so that there is something to see
      spell();
    }
    const falcon::SessionState& state = port_->view().session;
    count_.packets += link_->packets();
    count_.lost += state.lost;
    count_.silences += state.silences;
#ifndef CUSP_BEFORE
    count_.stale += state.stale;
    count_.unasked += state.unasked;
    count_.flawed += state.flawed;
    count_.unreached += port_->view().unreached;
#endif
  }

 private:
  LinkTime some(LinkTime most) { return LinkTime(static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(most.count()))); }
  double chance(double most) { return random_() % 3 == 0 ? most * static_cast<double>(random_() % 1000) / 1000.0 : 0.0; }

  Weather weather() {
    Weather out;
    switch (random_() % 4) {
      case 0: out.in = some(60ms); break;
      case 1: out.in = some(12ms); break;
      default: break;
    }
    out.in_later = random_() % 2 == 0 ? out.in : some(40ms);
    if (random_() % 4 == 0) out.out = some(15ms);
    if (random_() % 3 == 0) out.jitter = some(random_() % 2 == 0 ? 2ms : 25ms);
    out.lost_packet = chance(0.2);
    out.lost_answer = chance(0.3);
    const double twice = chance(0.2);
    if (answers_ == Answers::may_repeat) out.twice = twice;
    out.together = chance(0.5);
    out.parts = chance(0.5);
    out.cut = chance(0.1);
    out.reported = chance(0.2);
    out.false_alarm = chance(0.1);
    out.flipped = chance(0.1);
    return out;
  }
  LinkTime stall() {
    constexpr LinkTime kMost[] = {6ms, 15ms, 60ms, 300ms};
    const LinkTime most = kMost[random_() % 4];
    return random_() % 200 == 0 ? LinkTime(10s) : some(most) + 1us;
  }
  void spell() {
    ++count_.spells;
    const LinkTime lasts = 5ms + some(random_() % 4 == 0 ? 2500ms : 400ms);
    link_->set_weather(weather(), lasts);
    const LinkTime end = link_->now() + lasts;
    const unsigned stalls = static_cast<unsigned>(random_() % 3) * 20;  // of a thousand ticks
    while (link_->now() < end) {
      if (random_() % 1000 < stalls) {
        switch (random_() % 5) {
          case 0: link_->stall_device(std::min<LinkTime>(stall(), 400ms)); break;
          case 1: link_->stall_line(std::min<LinkTime>(stall(), 400ms)); break;
          case 2: link_->stall_host(stall()); break;
          case 3: link_->stall_host_in_wait(stall()); break;
          default: before_write_ = stall(); break;
        }
      }
      tick();
    }
    link_->set_weather({}, 1ms);
    const LinkTime settled = link_->settled();
    while (link_->now() < settled) tick();
    const LinkTime well = link_->now();
    const std::uint64_t before = count_.fresh;
    while (count_.fresh < before + 10 && link_->now() < well + 5s) tick();
    const LinkTime took = link_->now() - well;
    count_.longest_recovery = std::max(count_.longest_recovery, took);
    count_.late_recoveries += took > kWithin;
  }
  void run(LinkTime time) {
    const LinkTime end = link_->now() + time;
    while (link_->now() < end) tick();
  }
  void tick() {
    const Sample sample = port_->wait(std::chrono::steady_clock::time_point(link_->now() + 2ms));
    if (sample.status == Sample::Status::fresh) check(sample);
    if (before_write_ > LinkTime(0)) link_->stall_host(std::exchange(before_write_, LinkTime(0)));
    port_->write({.force_n = {0.6, -0.8, 1.1}});
  }
  void check(const Sample& sample) {
    ++count_.fresh;
    const Truth* truth = link_->truth_of(port_->view().session.encoders);
    if (truth == nullptr) {
      ++count_.unknown;
      return;
    }
    const LinkTime age = link_->now() - truth->sent;
    count_.oldest_sample = std::max(count_.oldest_sample, age);
    count_.old_samples += age > kFresh;
    count_.reported += truth->reported;
    const double off = glm::length(sample.position_mm - space_.specimen_mm(truth->grip_m)) / 1e3 / space_.scale();
    const LinkTime tick = rests_on_ ? std::max(truth->sent - *rests_on_, link_->now() - reported_at_) : LinkTime(0);
    const double since = std::chrono::duration<double>(tick).count();
    reported_at_ = link_->now();
    count_.farthest_m = std::max(count_.farthest_m, off);
    // The last reported place was off by so much; since then the reported place and the true one have both moved.
    count_.wrong_places += off > off_m_ + (kHandMPerS + kGripMPerS) * since + kStepM;
    off_m_ = off;
    rests_on_ = truth->sent;
  }
  void check(const std::array<std::int16_t, 3>& torque) {
    if (torque == std::array<std::int16_t, 3>{}) return;
    ++count_.torque;
    const LinkTime age = rests_on_ ? link_->now() - *rests_on_ : LinkTime::max();
    count_.oldest_torque = std::max(count_.oldest_torque, age);
    count_.old_torque += age > kFresh;
  }

  std::mt19937_64 random_;
  Answers answers_;
  Count& count_;
  RoughLink* link_ = nullptr;
  std::unique_ptr<FalconPort> port_;
  falcon::Workspace space_ = *falcon::Workspace::from({});
  std::optional<LinkTime> rests_on_;  // when the device sent what the newest fresh sample reports
  LinkTime before_write_{0}, reported_at_{0};
  double off_m_ = 0.0;  // of the newest fresh sample, from where the grip was
};

double ms(LinkTime time) { return std::chrono::duration<double, std::milli>(time).count(); }

/// Ready, with the whole torque.
struct Ready {
  Ready() {
    auto made = std::make_unique<RoughLink>(1);
    link = made.get();
    port = std::make_unique<FalconPort>(std::move(made));
    EXPECT_TRUE(port->open());
    for (int i = 0; i < 1000; ++i) tick();
    link->on_packet([this](const std::array<std::int16_t, 3>& torque) { forced += torque != std::array<std::int16_t, 3>{}; });
  }
  Sample tick() {
    const Sample sample = port->wait(std::chrono::steady_clock::time_point(link->now() + 2ms));
    fresh += sample.status == Sample::Status::fresh;
    port->write({.force_n = {0.6, -0.8, 1.1}});
    return sample;
  }
  RoughLink* link = nullptr;
  std::unique_ptr<FalconPort> port;
  int forced = 0, fresh = 0;
};

TEST(FalconPort, after_a_stall_of_the_host_no_old_torque_leaves_and_no_old_answer_is_fresh) {
  for (const LinkTime stall : {LinkTime(200ms), LinkTime(10s)}) {
    Ready ready;
    ASSERT_EQ(ready.tick().status, Sample::Status::fresh);
    ready.link->stall_host(stall);
    ready.forced = 0;
    const Sample first = ready.port->wait(std::chrono::steady_clock::time_point(ready.link->now() + 2ms));
    EXPECT_EQ(ready.forced, 0);
    if (first.status == Sample::Status::fresh) {
      EXPECT_LE(ready.link->now() - ready.link->truth_of(ready.port->view().session.encoders)->sent, kFresh);
    }
    ready.fresh = 0;
    for (int i = 0; i < 300; ++i) ready.tick();
    EXPECT_GT(ready.fresh, 100);  // it comes back by itself
  }
}

TEST(FalconPort, on_a_line_of_30_ms_nothing_is_fresh_and_no_force_leaves) {
  Ready ready;
  ready.link->set_weather({.in = 30ms, .in_later = 30ms}, 1s);
  for (int i = 0; i < 10; ++i) ready.tick();
  ready.forced = ready.fresh = 0;
  for (int i = 0; i < 1500; ++i) ready.tick();
  EXPECT_EQ(ready.fresh, 0);
  EXPECT_EQ(ready.forced, 0);
  ready.link->set_weather({}, 1s);
  for (int i = 0; i < 400; ++i) ready.tick();
  EXPECT_GT(ready.fresh, 100);
}

TEST(FalconPort, on_a_line_of_30_ms_it_does_not_open_and_reports_why) {
  auto made = std::make_unique<RoughLink>(1);
  RoughLink* const link = made.get();
  link->set_weather({.in = 30ms, .in_later = 30ms}, 1s);
  FalconPort port(std::move(made));
  // A packet every 230 ms: some 45 until it gives up. One that never does is cancelled.
  link->on_packet([&](const std::array<std::int16_t, 3>&) {
    if (link->packets() >= 1000) port.cancel();
  });
  const auto opened = port.open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, PortError::io);
  EXPECT_EQ(opened.error().detail, "late_answers");
  EXPECT_EQ(opened.error().where, "rough");
}

TEST(FalconPort, an_answer_beside_a_line_error_is_dropped_and_counted) {
  Ready ready;
  const auto before = ready.port->view().session.flawed;
  ready.link->set_weather({.reported = 1.0}, 1s);
  ready.fresh = 0;
  for (int i = 0; i < 5; ++i) ready.tick();
  EXPECT_LE(ready.fresh, 1);
  EXPECT_GT(ready.port->view().session.flawed, before);
}

TEST(FalconPort, a_place_that_no_hand_reaches_in_a_tick_is_not_believed_until_time_allows_it) {
  falcon::Reach reach;
  EXPECT_FALSE(reach.accepts({0, 0, 0.12}, 0ms));  // by itself
  EXPECT_TRUE(reach.accepts({0, 0, 0.12}, 1ms));
  EXPECT_FALSE(reach.accepts({0.0032, 0, 0.12}, 2ms));  // a bit of 64 counts
  EXPECT_FALSE(reach.accepts({0, 0, std::nan("")}, 2ms));
  EXPECT_TRUE(reach.accepts({0.0019, 0, 0.12}, 2ms));
  EXPECT_FALSE(reach.accepts({0.0419, 0, 0.12}, 3ms));
  EXPECT_TRUE(reach.accepts({0.0419, 0, 0.12}, 22ms));  // 20 ms at 2 m/s
  EXPECT_FALSE(reach.accepts({-0.05, 0, 0.12}, 100ms));  // after a gap two have to agree
  EXPECT_TRUE(reach.accepts({-0.05, 0, 0.12}, 101ms));
}

TEST(FalconPort, no_line_however_rough_brings_torque_or_a_place_from_an_old_answer) {
  const char* wanted = std::getenv("CUSP_LINK_SECONDS");
  const char* only = std::getenv("CUSP_LINK_SEED");
  const std::uint64_t seconds = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 500;
  const std::uint64_t first = only != nullptr ? std::strtoull(only, nullptr, 10) : 1;
  const std::uint64_t seeds = only != nullptr && wanted == nullptr ? 1 : (seconds + 9) / 10;
  const Answers answers = std::getenv("CUSP_LINK_ONCE") == nullptr ? Answers::may_repeat : Answers::once;
  Count count;
  int printed = 0;
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    const std::uint64_t before = count.violations();
    Voyage(seed, answers, count).sail(10s);
    if (count.violations() > before && printed++ < 10) std::cout << "seed " << seed << " violates\n";
  }
  std::cout << seeds << " seeds from " << first << " of 10 s, " << count.spells << " spells: " << count.packets << " packets, "
            << count.torque << " with torque, " << count.fresh << " fresh samples; " << count.stale << " stale, "
            << count.unasked << " unasked, " << count.flawed << " flawed, " << count.unreached << " unreached, " << count.lost
            << " lost, " << count.silences << " silences\noldest torque " << ms(count.oldest_torque) << " ms, oldest sample "
            << ms(count.oldest_sample) << " ms, farthest place " << count.farthest_m * 1e3 << " mm, longest recovery "
            << ms(count.longest_recovery) << " ms\nviolations: " << count.old_torque << " torque, " << count.old_samples
            << " samples, " << count.reported << " reported, " << count.unknown << " unknown, " << count.wrong_places
            << " places, " << count.late_recoveries << " recoveries\n";
  EXPECT_EQ(count.old_torque, 0u);
  EXPECT_EQ(count.old_samples, 0u);
  EXPECT_EQ(count.reported, 0u);
  EXPECT_EQ(count.unknown, 0u);
  EXPECT_EQ(count.wrong_places, 0u);
  EXPECT_EQ(count.late_recoveries, 0u);
  EXPECT_GT(count.torque, seconds * 100);  // there is torque to be seen: the test can fail
  EXPECT_GT(count.stale, only != nullptr && wanted == nullptr ? 0 : seconds / 10);
}

}  // namespace
}  // namespace cusp::test
