#include "device/pointer/pointer_port.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stop_token>
#include <thread>

#include "device/catalogue.h"
#include "tests/device/counted_new.h"
#include "tests/device/toy_tissue.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using Clock = std::chrono::steady_clock;
using test::allocations;
using test::armed;
using test::ToyTissue;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(PointerHand, IgnoresPlacesThatAreNone) {
  PointerHand hand(Vec3(1, 2, 3));
  hand.move_to(Vec3(kNan, 0, 0));
  EXPECT_EQ(hand.wish().target_mm, Vec3(1, 2, 3));
  hand.nudge(kNan, 1);
  EXPECT_EQ(hand.wish().target_mm, Vec3(1, 2, 3));
  hand.nudge(std::numeric_limits<double>::infinity(), 0);
  EXPECT_EQ(hand.wish().target_mm, Vec3(1, 2, 3));
  EXPECT_EQ(PointerHand(Vec3(kNan, 0, 0)).wish().target_mm, Vec3(0.0));
}

TEST(PointerHand, CutsAPushToItsRange) {
  PointerHand hand;
  hand.set_push(99);
  EXPECT_EQ(hand.wish().push_n, PointerHand::kMaxPushN);
  hand.set_push(-1);
  EXPECT_EQ(hand.wish().push_n, 0);
  hand.set_push(1);
  hand.set_push(kNan);
  EXPECT_EQ(hand.wish().push_n, 0);
}

TEST(PointerHand, NudgesAsThePersonSeesIt) {
  PointerHand hand;
  hand.nudge(0.5, 0.25);
  EXPECT_EQ(hand.wish().target_mm, Vec3(0.5, 0.25, 0));  // seen from above: x right, y up
  PointerHand side;
  side.set_view(Vec3(0, 1, 0), Vec3(1, 0, 0));  // looking along +y: x right, z up
  side.nudge(1, 2);
  EXPECT_NEAR(glm::length(side.wish().target_mm - Vec3(1, 0, 2)), 0, 1e-12);
}

TEST(PointerHand, RefusesAViewThatIsNone) {
  PointerHand hand;
  hand.set_view(Vec3(0.0), Vec3(1, 0, 0));
  hand.set_view(Vec3(0, 0, -1), Vec3(0, 0, 5));
  hand.set_view(Vec3(kNan, 0, -1), Vec3(1, 0, 0));
  EXPECT_EQ(hand.wish().approach, Vec3(0, 0, -1));
}

/// The threads wait for each other's progress: the UI thread begins a burst once the last wish of the one before was read.
TEST(PointerHand, NeverHandsOverHalfAWishNorAnOldOne) {
  constexpr int kBursts = 2000, kBurst = 1000;
  PointerHand hand;
  std::atomic<int> written{0};   // every wish up to it is whole
  std::atomic<double> taken{0};  // relaxed: it orders nothing, so TSan sees what PointerHand alone orders
  const std::jthread ui([&](const std::stop_token& stop) {
    for (int i = 1; i <= kBursts * kBurst && !stop.stop_requested(); ++i) {
      hand.move_to(Vec3(i, i, i));
      written.store(i, std::memory_order_release);
      if (i % kBurst != 0) continue;
      while (taken.load(std::memory_order_relaxed) < i && !stop.stop_requested()) std::this_thread::yield();
    }
  });
  double before = 0;
  for (int idle = 0; before < kBursts * kBurst;) {
    const int whole = written.load(std::memory_order_acquire);
    const Vec3 at = hand.latest().target_mm;
    ASSERT_EQ(at.x, at.y);
    ASSERT_EQ(at.x, at.z);
    ASSERT_GE(at.x, before);
    ASSERT_GE(at.x, whole);
    taken.store(at.x, std::memory_order_relaxed);
    idle = at.x > before ? 0 : idle + 1;
    before = at.x;
    if (idle > 100) std::this_thread::yield();  // the UI thread may need this core
  }
}

/// Deadlines in the past: wait() returns at once, and dt is still the time between them.
struct Paced {
  Clock::time_point at = Clock::now() - std::chrono::hours(1);
  Clock::time_point next() { return at += std::chrono::milliseconds(1); }
};

TEST(PointerPort, DrillsWithTheKeysAlone) {
  PointerPort port(Vec3(0, 0, 2));
  ASSERT_TRUE(port.open());
  ToyTissue tissue;
  Paced paced;
  port.hand().nudge(1, 0);
  port.hand().set_push(1.5);
  port.hand().set_cut(true);
  port.hand().set_bur(2);
  Sample sample;
  for (int i = 0; i < 3000; ++i) {
    sample = port.wait(paced.next());
    const Feedback felt = tissue.feel(sample.position_mm);
    if (felt.in_contact && (sample.buttons & 1) != 0) tissue.planes[0].point_mm.z -= 0.001;  // 1 mm/s
    port.write(felt);
  }
  EXPECT_EQ(sample.status, Sample::Status::fresh);
  EXPECT_EQ(sample.buttons, 1);
  EXPECT_EQ(sample.bur, 2);
  EXPECT_NEAR(sample.position_mm.x, 1, 1e-6);
  // About 0.2 s through the air at 10 mm/s, then 1 mm/s.
  EXPECT_LT(tissue.planes[0].point_mm.z, -2.7);
}

TEST(PointerPort, WaitsAndAnswersWithoutAllocating) {
  PointerPort port(Vec3(0, 0, 2));
  ASSERT_TRUE(port.open());
  ToyTissue tissue;
  Paced paced;
  port.hand().set_push(1);
  std::vector<Feedback> answers;
  armed = true;
  allocations = 0;
  for (int i = 0; i < 10000; ++i) {
    port.hand().nudge(0.001, 0.0005);
    const Sample sample = port.wait(paced.next());
    port.write(tissue.feel(sample.position_mm));
  }
  armed = false;
  EXPECT_EQ(allocations, 0);
  armed = true;
  answers.reserve(1);  // the counter counts
  armed = false;
  EXPECT_EQ(allocations, test::kCounts ? 1 : 0);
}

TEST(PointerPort, SleepsToTheDeadline) {
  PointerPort port(Vec3(0, 0, 2));
  ASSERT_TRUE(port.open());
  const auto deadline = Clock::now() + std::chrono::milliseconds(5);
  port.wait(deadline);
  EXPECT_GE(Clock::now(), deadline);
}

TEST(PointerPort, IsGoneOnceClosedAndBackOnceOpened) {
  PointerPort port(Vec3(0, 0, 2));
  Paced paced;
  EXPECT_EQ(port.wait(paced.next()).status, Sample::Status::gone);
  ASSERT_TRUE(port.open());
  EXPECT_EQ(port.wait(paced.next()).status, Sample::Status::fresh);
  port.close();
  EXPECT_EQ(port.wait(paced.next()).status, Sample::Status::gone);
}

TEST(PointerPort, SaysWhatItCanDo) {
  const DeviceLimits limits = PointerPort(Vec3(0.0)).limits();
  EXPECT_EQ(limits.device_class, "pointer");
  EXPECT_EQ(limits.position_axes, 3);
  EXPECT_EQ(limits.max_force_n, PointerHand::kMaxPushN);
  EXPECT_FALSE(limits.has_own_clock);
}

TEST(Catalogue, OffersTheMouseFirstAndKnowsItsKeys) {
  ASSERT_FALSE(device_kinds().empty());
  EXPECT_EQ(device_kinds().front().key, "pointer");
  ASSERT_NE(device_kind("scripted"), nullptr);
  EXPECT_TRUE(device_kind("scripted")->needs_file);
  ASSERT_NE(device_kind("falcon"), nullptr);
  EXPECT_TRUE(device_kind("falcon")->offered);
  ASSERT_NE(device_kind("emulated-falcon"), nullptr);
  EXPECT_NE(device_kind("emulated-falcon")->device_class, device_kind("falcon")->device_class);  // never mixed
  EXPECT_EQ(device_kind("trackball"), nullptr);
}

TEST(PointerHand, turns_the_handpiece_as_seen_along_the_approach_no_further_than_the_exercise_lets_it) {
  PointerHand hand;
  const auto shank = [&] { return hand.wish().orientation * Vec3(0.0, 0.0, 1.0); };
  hand.turn(20.0, 0.0);
  EXPECT_EQ(shank(), Vec3(0.0, 0.0, 1.0));  // no exercise has allowed it yet
  hand.set_turn_limit(30.0);
  hand.turn(20.0, 0.0);
  EXPECT_NEAR(shank().x, std::sin(20.0 * 3.14159265358979 / 180.0), 1e-12);  // to the right
  EXPECT_NEAR(shank().y, 0.0, 1e-12);
  hand.turn_back();
  hand.turn(0.0, 20.0);
  EXPECT_NEAR(shank().y, std::sin(20.0 * 3.14159265358979 / 180.0), 1e-12);  // up
  hand.turn(0.0, 50.0);
  EXPECT_NEAR(hand.turned_deg(), 30.0, 1e-9);
  hand.turn(kNan, 1.0);
  EXPECT_NEAR(hand.turned_deg(), 30.0, 1e-9);
  hand.set_turn_limit(10.0);
  EXPECT_NEAR(hand.turned_deg(), 10.0, 1e-9);
  hand.set_turn_limit(-1.0);
  EXPECT_EQ(hand.turned_deg(), 0.0);
}

TEST(PointerPort, hands_the_turned_handpiece_on) {
  PointerPort port(Vec3(0.0));
  ASSERT_TRUE(port.open());
  port.hand().set_turn_limit(45.0);
  port.hand().turn(45.0, 0.0);
  EXPECT_NEAR((port.wait(Clock::now()).orientation * Vec3(0.0, 0.0, 1.0)).x, std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace cusp::test
