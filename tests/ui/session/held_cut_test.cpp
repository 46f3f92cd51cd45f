#include "ui/session/held_cut.h"

#include <gtest/gtest.h>

#include "tests/modules.h"

namespace cusp::test {
namespace {

using Attempt = HeldCut::Attempt;

Sample pressed(std::uint16_t pedal = 65535) { return {.status = Sample::Status::fresh, .position_mm = {1, 2, 3}, .buttons = 3, .pedal = pedal}; }
Sample released() { return {.status = Sample::Status::fresh, .position_mm = {1, 2, 3}, .buttons = 2}; }

Sample taken(HeldCut& held, Sample sample, Attempt attempt) {
  held.take(sample, attempt);
  return sample;
}

TEST(HeldCut, APressWhileTheAttemptRunsCutsAtOnce) {
  HeldCut held;
  EXPECT_EQ(taken(held, pressed(30000), Attempt::runs).buttons, 3);
  EXPECT_EQ(taken(held, pressed(30000), Attempt::runs).pedal, 30000);
  EXPECT_FALSE(held.ignores());
}

TEST(HeldCut, APressThatIsHeldWhileTheAttemptStandsCutsOnlyOnceItWasReleased) {
  HeldCut held;
  taken(held, pressed(), Attempt::runs);
  taken(held, pressed(), Attempt::stands);
  for (int i = 0; i < 1000; ++i) {
    const Sample sample = taken(held, pressed(), Attempt::runs);
    ASSERT_EQ(sample.buttons, 2) << "the coolant's button stays";
    ASSERT_EQ(sample.pedal, 0);
    ASSERT_EQ(sample.position_mm, Vec3(1, 2, 3));
    ASSERT_TRUE(held.ignores());
  }
  taken(held, released(), Attempt::runs);
  EXPECT_FALSE(held.ignores());
  EXPECT_EQ(taken(held, pressed(), Attempt::runs).buttons, 3);
}

TEST(HeldCut, AReleaseWhileTheAttemptStandsCounts) {
  HeldCut held;
  taken(held, pressed(), Attempt::stands);
  taken(held, released(), Attempt::stands);
  EXPECT_EQ(taken(held, pressed(), Attempt::runs).buttons, 3);
}

TEST(HeldCut, APedalThatIsDownWithoutAButtonIsHeldToo) {
  Sample pedal = released();
  pedal.pedal = 30000;
  HeldCut held;
  EXPECT_EQ(taken(held, pedal, Attempt::stands).pedal, 0);
  EXPECT_EQ(taken(held, pedal, Attempt::runs).pedal, 0) << "a handpiece turns by the pedal alone";
  taken(held, released(), Attempt::runs);
  EXPECT_EQ(taken(held, pedal, Attempt::runs).pedal, 30000);
}

TEST(HeldCut, ADeviceThatIsFoundAgainWithItsButtonPressedDoesNotCut) {
  HeldCut held;
  taken(held, pressed(), Attempt::runs);
  taken(held, {}, Attempt::stands);  // gone: its buttons count as released
  taken(held, pressed(), Attempt::stands);
  EXPECT_EQ(taken(held, pressed(), Attempt::runs).buttons, 2);
}

}  // namespace
}  // namespace cusp::test
