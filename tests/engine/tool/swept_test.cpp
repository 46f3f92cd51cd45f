// The bur in space: its head at a pose, its head along a way, its neck and shank; against dense sampling of the way.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/tool/heads.h"

namespace cusp::test {
namespace {


Bur ball() {
  Bur out;
  out.radius_mm = 0.7;
  return out;
}

std::vector<Bur> all_heads() {
  std::vector<Bur> out = all_shapes();
  out.push_back(ball());
  return out;
}

TEST(HeadDistance, has_its_gradient_in_space) {
  Random random(21);
  for (const Bur& bur : all_heads())
    for (int round = 0; round < 500; ++round) {
      const Vec3 axis = random.direction();
      const Vec3 from = 1.5 * head_reach(bur) * random.vector();
      Vec3 gradient;
      const double d = head_distance(bur, axis, from, gradient);
      EXPECT_EQ(d, head_distance(bur, axis, from));
      EXPECT_NEAR(glm::dot(gradient, gradient), 1.0, 1e-12);
      if (d < 1e-3) continue;  // inside lie creases
      constexpr double h = 1e-6;
      for (int i = 0; i < 3; ++i) {
        Vec3 step(0.0);
        step[i] = h;
        const double slope = (head_distance(bur, axis, from + step) - head_distance(bur, axis, from - step)) / (2 * h);
        EXPECT_NEAR(slope, gradient[i], 1e-5) << bur.name;  // h^2 of curvature 1 / d^2, and rounding over h
      }
    }
}

TEST(HeadDistance, on_the_axis_is_defined) {
  for (const Bur& bur : all_heads()) {
    const Vec3 axis(0.6, 0.0, 0.8);
    for (double t = -3.0; t <= 9.0; t += 0.25) {
      Vec3 gradient;
      const double d = head_distance(bur, axis, axis * t, gradient);
      EXPECT_LT(std::fabs(d), 20.0);
      EXPECT_NEAR(glm::dot(gradient, gradient), 1.0, 1e-12) << bur.name << " " << t;
    }
  }
}

TEST(PassingHead, is_the_least_distance_along_the_way) {
  Random random(23);
  for (const Bur& bur : all_heads())
    for (const double way : {1e-6, 0.001, 0.05, 0.2, 3.0}) {
      for (int round = 0; round < 60; ++round) {
        const Vec3 axis = random.direction();
        const Vec3 a = random.vector(), b = a + way * random.direction();
        const Vec3 place = a + (head_reach(bur) + way) * 1.2 * random.vector();
        constexpr int kLooks = 4000;
        double least = 1e300;
        for (int i = 0; i <= kLooks; ++i)
          least = std::min(least, head_distance(bur, axis, place - (a + (b - a) * (static_cast<double>(i) / kLooks))));
        const Passing at = passing_head(bur, axis, a, b, place);
        // The samples are at most half a step, way / 8,000, from the least.
        EXPECT_LE(at.distance_mm, least + kPassingErrorMm) << bur.name << " " << way;
        EXPECT_GE(at.distance_mm, least - way / (2 * kLooks) - kPassingErrorMm) << bur.name << " " << way;
        EXPECT_GE(at.part, 0.0);
        EXPECT_LE(at.part, 1.0);
        EXPECT_NEAR(head_distance(bur, axis, place - (a + (b - a) * at.part)), at.distance_mm, 1e-12);
      }
    }
}

TEST(PassingHead, of_a_ball_is_a_capsule_and_of_no_way_the_head_itself) {
  Random random(25);
  const Vec3 a(0.1, 0.2, 0.3), b(1.1, 0.2, 0.3), axis(0, 0, 1);
  EXPECT_NEAR(passing_head(ball(), axis, a, b, {0.6, 1.2, 0.3}).distance_mm, 0.3, 1e-15);
  EXPECT_NEAR(passing_head(ball(), axis, a, b, {2.1, 0.2, 0.3}).distance_mm, 0.3, 1e-15);
  EXPECT_EQ(passing_head(ball(), axis, a, b, {0.6, 1.2, 0.3}).part, 0.5);
  for (const Bur& bur : all_heads())
    for (int round = 0; round < 100; ++round) {
      const Vec3 place = 3.0 * random.vector();
      EXPECT_EQ(passing_head(bur, axis, a, a, place).distance_mm, head_distance(bur, axis, place - a)) << bur.name;
    }
}

TEST(PassingHead, may_answer_any_bound_once_enough_is_passed) {
  Random random(27);
  for (const Bur& bur : all_heads())
    for (int round = 0; round < 500; ++round) {
      const Vec3 axis = random.direction(), a = random.vector(), b = a + 0.3 * random.direction();
      const Vec3 place = 8.0 * random.vector();
      const double exact = passing_head(bur, axis, a, b, place).distance_mm;
      const double bound = passing_head(bur, axis, a, b, place, 0.2).distance_mm;
      if (exact <= 0.2) {
        EXPECT_EQ(bound, exact) << bur.name;
      } else {
        EXPECT_GT(bound, 0.2) << bur.name;
        EXPECT_LE(bound, exact + kPassingErrorMm) << bur.name;
      }
    }
}

TEST(HolderDistance, is_neck_and_shank) {
  Bur bur;  // neck r 0.3 up to 4, shank r 0.8 up to 16
  const Vec3 axis(0, 0, 1);
  Vec3 gradient;
  EXPECT_NEAR(holder_distance(bur, axis, {0.5, 0, 2}, gradient), 0.2, 1e-12);
  EXPECT_EQ(gradient, Vec3(1, 0, 0));
  EXPECT_NEAR(holder_distance(bur, axis, {0, 1.0, 9}, gradient), 0.2, 1e-12);
  EXPECT_NEAR(holder_distance(bur, axis, {0, 0.6, 3.9}, gradient), 0.1, 1e-12);  // under the shoulder
  EXPECT_NEAR(gradient.z, -1.0, 1e-12);
  EXPECT_NEAR(holder_distance(bur, axis, {0.8 + 0.3, 0, 16.4}, gradient), 0.5, 1e-12);
  EXPECT_LT(holder_distance(bur, axis, {0.1, 0, 1.0}, gradient), -0.19);
  bur.shank_length_mm = 0.0;
  EXPECT_NEAR(holder_distance(bur, axis, {0, 0, 5}, gradient), 1.0, 1e-12);
}

}  // namespace
}  // namespace cusp::test
