#include "engine/lab/hand_model.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cusp::test {
namespace {

TEST(HandModel, SettlesWhereItIsWanted) {
  HandModel hand({}, Vec3(0));
  for (int i = 0; i < 1000; ++i) hand.advance(Vec3(1, -2, 3), Vec3(0), 0.001);
  EXPECT_NEAR(glm::length(hand.position_mm() - Vec3(1, -2, 3)), 0.0, 1e-6);
}

TEST(HandModel, AForceMovesItByForceOverGrip) {
  HandSettings s;
  s.stiffness_n_per_mm = 0.5;
  HandModel hand(s, Vec3(0));
  for (int i = 0; i < 3000; ++i) hand.advance(Vec3(0), Vec3(0, 0, 1.0), 0.001);
  EXPECT_NEAR(hand.position_mm().z, 2.0, 1e-6);  // closed form: 1 N / 0.5 N/mm
}

TEST(HandModel, IsLateByItsDelay) {
  HandSettings s;
  s.delay_s = 0.05;
  HandModel hand(s, Vec3(0));
  for (int i = 0; i < 50; ++i) EXPECT_EQ(hand.advance(Vec3(1, 0, 0), Vec3(0), 0.001).x, 0.0) << i;
  hand.advance(Vec3(1, 0, 0), Vec3(0), 0.001);
  EXPECT_GT(hand.position_mm().x, 0.0);
}

TEST(HandModel, DoesNotOvershootAtCriticalDamping) {
  HandModel hand({}, Vec3(0));
  double most = 0;
  for (int i = 0; i < 1000; ++i) most = std::max(most, hand.advance(Vec3(1, 0, 0), Vec3(0), 0.001).x);
  EXPECT_LE(most, 1.0 + 1e-3);
}

TEST(HandModel, HoldsStillOnAStiffWall) {
  // A wall of 10 N/mm at 0, wanted 0.5 mm inside: rests where grip and wall agree, 0.5 / 11, without growing.
  HandSettings s;
  HandModel hand(s, Vec3(0, 0, 1));
  double z = 1;
  for (int i = 0; i < 4000; ++i) z = hand.advance(Vec3(0, 0, -0.5), Vec3(0, 0, z < 0 ? -10.0 * z : 0.0), 0.001).z;
  EXPECT_NEAR(z, -0.5 / 11.0, 1e-3);
}

TEST(HandModel, TremorHasTheAskedSizeAndIsTheSameForTheSameSeed) {
  HandSettings s;
  s.tremor_mm = 0.2;
  s.stiffness_n_per_mm = 50.0;  // stiff, so that the muscles follow the tremor: above its 9 Hz by a factor of ten
  HandModel a(s, Vec3(0)), b(s, Vec3(0));
  s.seed = 2;
  HandModel other(s, Vec3(0));
  double square = 0;
  bool differs = false;
  const int ticks = 60000;
  for (int i = 0; i < ticks; ++i) {
    const Vec3 p = a.advance(Vec3(0), Vec3(0), 0.001);
    ASSERT_EQ(p, b.advance(Vec3(0), Vec3(0), 0.001));
    differs = differs || p != other.advance(Vec3(0), Vec3(0), 0.001);
    square += p.x * p.x;
  }
  EXPECT_TRUE(differs);
  EXPECT_NEAR(std::sqrt(square / ticks), 0.2, 0.05);  // a minute of a narrow band: 10 % either way
}

}  // namespace
}  // namespace cusp::test
