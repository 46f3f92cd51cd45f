// What counts as a hand at the device of an attempt.
#include "ui/drill/hand_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/modules.h"

namespace cusp::test {
namespace {

const Quat kUpright{1.0, 0.0, 0.0, 0.0};

/// About the x axis.
Quat turned_by(double degrees) {
  const double half = 0.5 * degrees * std::numbers::pi / 180.0;
  return {std::cos(half), std::sin(half), 0.0, 0.0};
}

TEST(HandMotion, takes_no_trembling_for_a_hand_and_counts_the_way_since_it_last_did) {
  HandMotion motion;
  EXPECT_TRUE(motion.moved(Vec3(0.0), kUpright)) << "whoever begins holds it";
  EXPECT_FALSE(motion.moved(Vec3(0.0), kUpright));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(motion.moved(Vec3(i % 2 == 0 ? 0.3 : -0.3, 0.0, 0.0), kUpright));
  EXPECT_TRUE(motion.moved(Vec3(0.0, 0.6, 0.0), kUpright));
  EXPECT_FALSE(motion.moved(Vec3(0.0, 0.2, 0.0), kUpright)) << "0.4 mm back";
  EXPECT_TRUE(motion.moved(Vec3(0.0, 0.0, 0.0), kUpright)) << "0.6 mm in two steps";
}

TEST(HandMotion, sees_a_hand_that_only_turns_the_device) {
  HandMotion motion;
  motion.moved(Vec3(0.0), kUpright);
  EXPECT_FALSE(motion.moved(Vec3(0.0), turned_by(2.9)));
  EXPECT_TRUE(motion.moved(Vec3(0.0), turned_by(3.1)));
  EXPECT_FALSE(motion.moved(Vec3(0.0), -turned_by(3.1))) << "the same turn";
}

}  // namespace
}  // namespace cusp::test
