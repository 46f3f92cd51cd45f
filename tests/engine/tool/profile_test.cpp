// The profile of revolution against its own outline, sampled densely, and against the formulas of simple bodies.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/tool/heads.h"

namespace cusp::test {
namespace {


constexpr double kPi = 3.14159265358979323846;

/// Points of the outline, `n` a piece.
std::vector<OnHalf> outline(const Profile& profile, int n) {
  std::vector<OnHalf> out;
  for (int i = 0; i < profile.size(); ++i) {
    const OutlinePiece& p = profile.piece(i);
    for (int j = 0; j <= n; ++j) {
      const double u = static_cast<double>(j) / n;
      if (p.radius == 0.0) {
        out.push_back({p.from.t + u * (p.to.t - p.from.t), p.from.rho + u * (p.to.rho - p.from.rho)});
        continue;
      }
      const double a = std::atan2(p.from.rho - p.centre.rho, p.from.t - p.centre.t);
      double b = std::atan2(p.to.rho - p.centre.rho, p.to.t - p.centre.t);
      const double angle = a + u * (b - a);
      out.push_back({p.centre.t + p.radius * std::cos(angle), p.centre.rho + p.radius * std::sin(angle)});
    }
  }
  return out;
}

/// Even-odd over the outline closed along the axis: knows nothing of convexity.
bool inside(const std::vector<OnHalf>& points, OnHalf at) {
  bool in = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const OnHalf a = points[i], b = points[j];
    if ((a.rho > at.rho) != (b.rho > at.rho) && at.t < a.t + (b.t - a.t) * (at.rho - a.rho) / (b.rho - a.rho)) in = !in;
  }
  return in;
}

TEST(Profile, says_the_distance_that_its_outline_sampled_densely_has) {
  Random random(3);
  for (const Bur& bur : all_shapes()) {
    const std::vector<OnHalf> points = outline(bur.head, 4000);
    const double middle = 0.5 * (bur.head.low() + bur.head.high()), half = bur.head.high() - middle;
    double worst = 0.0;
    for (int round = 0; round < 400; ++round) {
      const OnHalf at{middle + 1.4 * half * random(), std::fabs(2.0 * bur.head.widest() * random())};
      double least = 1e300;
      for (const OnHalf& p : points)
        least = std::min(least, (p.t - at.t) * (p.t - at.t) + (p.rho - at.rho) * (p.rho - at.rho));
      const double expected = inside(points, at) ? -std::sqrt(least) : std::sqrt(least);
      OnHalf gradient;
      const double distance = bur.head.distance(at, gradient);
      // 4,000 samples a piece of at most 8 mm stand 2 um apart: 1 um beside a sample, and near the outline all of it.
      EXPECT_NEAR(distance, expected, 1.1e-3) << bur.name << " " << at.t << " " << at.rho;
      if (std::fabs(expected) > 0.05) worst = std::max(worst, std::fabs(distance - expected));
    }
    EXPECT_LT(worst, 2e-5) << bur.name << ": further off the samples' spacing hardly counts";
  }
}

TEST(Profile, is_level_all_along_its_own_skin) {
  for (const Bur& bur : all_shapes())
    for (const OnHalf& at : outline(bur.head, 3000)) {
      OnHalf gradient;
      ASSERT_NEAR(bur.head.distance(at, gradient), 0.0, 1e-9) << bur.name << " " << at.t << " " << at.rho;
    }
}

TEST(Profile, has_the_gradient_of_its_distance) {
  Random random(5);
  for (const Bur& bur : all_shapes()) {
    const double middle = 0.5 * (bur.head.low() + bur.head.high()), half = bur.head.high() - middle;
    int creased = 0;
    for (int round = 0; round < 2000; ++round) {
      const OnHalf at{middle + 1.4 * half * random(), 1e-3 + std::fabs(2.0 * bur.head.widest() * random())};
      OnHalf gradient, other;
      const double d = bur.head.distance(at, gradient);
      EXPECT_NEAR(gradient.t * gradient.t + gradient.rho * gradient.rho, 1.0, 1e-12);
      EXPECT_GE(gradient.rho, -1e-9);
      constexpr double h = 1e-6;
      const double t = (bur.head.distance({at.t + h, at.rho}, other) - bur.head.distance({at.t - h, at.rho}, other)) / (2 * h);
      const double rho = (bur.head.distance({at.t, at.rho + h}, other) - bur.head.distance({at.t, at.rho - h}, other)) / (2 * h);
      // A step of 1 nm over 1e-6 mm of curvature 1 / distance; across an inner crease there is no gradient.
      const bool same = std::fabs(t - gradient.t) < 1e-4 && std::fabs(rho - gradient.rho) < 1e-4;
      if (same) continue;
      ++creased;
      EXPECT_LT(d, 1e-5) << bur.name << " " << at.t << " " << at.rho;
    }
    EXPECT_LT(creased, 10) << bur.name;
  }
}

TEST(Profile, is_convex_in_distance_too) {
  Random random(7);
  for (const Bur& bur : all_shapes())
    for (int round = 0; round < 3000; ++round) {
      const Vec3 a = 6.0 * random.vector(), b = 6.0 * random.vector();
      const Vec3 axis(0.36, 0.48, 0.8);
      const double middle = head_distance(bur, axis, 0.5 * (a + b));
      EXPECT_LE(middle, 0.5 * (head_distance(bur, axis, a) + head_distance(bur, axis, b)) + 1e-12) << bur.name;
    }
}

TEST(Profile, has_the_support_of_its_outline_and_slides_along_what_is_flat) {
  Random random(11);
  for (const Bur& bur : all_shapes()) {
    const std::vector<OnHalf> points = outline(bur.head, 2000);
    for (int round = 0; round < 500; ++round) {
      const double angle = 0.5 * kPi * (1.0 + random());
      const OnHalf direction{std::cos(angle), std::sin(angle)};
      double most = -1e300;
      for (const OnHalf& p : points) most = std::max(most, p.t * direction.t + p.rho * direction.rho);
      const OnHalf at = bur.head.support(direction, {0.0, 0.0});
      OnHalf gradient;
      EXPECT_NEAR(at.t * direction.t + at.rho * direction.rho, most, 2e-6) << bur.name;
      EXPECT_NEAR(bur.head.distance(at, gradient), 0.0, 1e-9) << bur.name << ": the point lies on the solid";
    }
  }
  const Profile straight = flat_head(0.5, 0.5, 4.0).value();
  // A flank and a flat end: what lies nearest to the place asked for.
  EXPECT_EQ(straight.support({0.0, 1.0}, {1.25, 7.0}), (OnHalf{1.25, 0.5}));
  EXPECT_EQ(straight.support({0.0, 1.0}, {9.0, 0.0}), (OnHalf{3.5, 0.5}));
  EXPECT_EQ(straight.support({-1.0, 0.0}, {0.0, 0.2}), (OnHalf{-0.5, 0.2}));
  EXPECT_EQ(straight.support({1.0, 0.0}, {0.0, 0.2}), (OnHalf{3.5, 0.2}));
}

/// By discs of revolution, the radius found where the distance changes sign.
double volume_of(const Profile& profile) {
  constexpr int kSlices = 4000;
  const double step = (profile.high() - profile.low()) / kSlices;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double t = profile.low() + (i + 0.5) * step;
    double in = 0.0, out = profile.widest() + 0.1;
    for (int halve = 0; halve < 50; ++halve) {
      const double middle = 0.5 * (in + out);
      OnHalf gradient;
      (profile.distance({t, middle}, gradient) <= 0.0 ? in : out) = middle;
    }
    sum += kPi * in * in * step;
  }
  return sum;
}

TEST(Profile, has_lines_that_touch_it_and_leave_its_outline_by_little) {
  Random random(8);
  for (const Bur& bur : all_shapes()) {
    const auto highest = [&](OnHalf at) {
      double most = -1e300;
      for (const SupportLine& line : bur.head.support_lines())
        most = std::max(most, line.normal.t * at.t + line.normal.rho * at.rho - line.level);
      return most;
    };
    for (int round = 0; round < 400; ++round) {
      const OnHalf at{3.0 * bur.head.reach() * random(), std::fabs(2.0 * bur.head.widest() * random())};
      OnHalf gradient;
      EXPECT_LE(highest(at), bur.head.distance(at, gradient) + 1e-12) << bur.name << " " << at.t << " " << at.rho;
    }
    for (const OnHalf& at : outline(bur.head, 200)) EXPECT_GE(highest(at), -Profile::kOffArcMm) << bur.name;
  }
}

TEST(Profile, is_as_sharp_as_its_least_arc_and_its_tip) {
  EXPECT_DOUBLE_EQ(flat_head(0.5, 0.5, 4.0).value().least_radius(), 0.5);
  EXPECT_NEAR(round_end_head(0.5, 0.9, 8.0).value().least_radius(), 0.5, 1e-12);
  EXPECT_NEAR(pear_head(0.4, 0.3, 0.25, 1.8).value().least_radius(), 0.25, 0.002);
  EXPECT_NEAR(oval_head(0.6, 0.1, 5.0, 0.45, 8.0).value().least_radius(), 0.1, 1e-12);
  // Wider at the tip: the narrow end's radius, a little more along the slanted flank's normal.
  const Profile cone = flat_head(0.6, 0.35, 1.2).value();
  EXPECT_NEAR(cone.least_radius(), 0.35 * std::sqrt(1.2 * 1.2 + 0.25 * 0.25) / 1.2, 1e-12);
  EXPECT_TRUE(cone.edge(0) && cone.edge(1));
  EXPECT_FALSE(cone.edge(2)) << "nothing follows the last piece";
  EXPECT_FALSE(round_end_head(0.5, 0.9, 8.0).value().edge(0)) << "a flank that touches its ball";
}

TEST(Profile, encloses_the_volume_that_solid_geometry_gives_it) {
  const auto cone = [](double a, double b, double h) { return kPi * h * (a * a + a * b + b * b) / 3.0; };
  // Midpoint discs, 4,000 of them: short by less than 2e-6 of each of these volumes.
  EXPECT_NEAR(volume_of(flat_head(0.5, 0.5, 4.0).value()), kPi * 0.25 * 4.0, 1e-9);
  EXPECT_NEAR(volume_of(flat_head(0.4, 0.6, 4.2).value()), cone(0.4, 0.6, 4.2), 1e-6);
  EXPECT_NEAR(volume_of(flat_head(0.6, 0.35, 1.2).value()), cone(0.6, 0.35, 1.2), 1e-6);
  EXPECT_NEAR(volume_of(round_end_head(0.6, 0.6, 4.0).value()), 2.0 / 3.0 * kPi * 0.216 + kPi * 0.36 * 3.4, 1e-5);
  // Half a ball, then a cone that leaves it where the line to the top touches: 3-4-5 by choice of the top.
  const Profile half = pear_head(0.5, 0.5, 0.5 * 0.8 - 0.3 * 0.75, 0.5 + 0.5 * 0.6 + 0.3).value();
  const double above = 0.5 * 0.6;
  const double ball = kPi * (0.25 * (above + 0.5) - (above * above * above + 0.125) / 3.0);
  EXPECT_NEAR(volume_of(half), ball + cone(0.4, 0.175, 0.3), 1e-5);
}

TEST(Profile, knows_how_far_it_reaches) {
  for (const Bur& bur : all_shapes()) {
    double reach = 0.0, wide = 0.0;
    for (const OnHalf& p : outline(bur.head, 2000)) {
      reach = std::max(reach, std::sqrt(p.t * p.t + p.rho * p.rho));
      wide = std::max(wide, p.rho);
    }
    EXPECT_NEAR(bur.head.reach(), reach, 1e-6) << bur.name;
    EXPECT_NEAR(bur.head.widest(), wide, 1e-6) << bur.name;
    EXPECT_NEAR(bur.head.widest(), bur.radius_mm, 1e-9) << bur.name << ": that is what its radius means";
    EXPECT_NEAR(bur.head.low(), -bur.radius_mm, 1e-12) << bur.name << ": the pivot is a radius above the tip";
  }
}

TEST(Profile, takes_only_what_stays_convex_and_joins) {
  const auto line = [](OnHalf a, OnHalf b) { return OutlinePiece{a, b, {}, 0.0}; };
  Profile p;
  EXPECT_FALSE(p.add(line({0, 0.5}, {0, 1}))) << "begins off the axis";
  EXPECT_FALSE(p.add(line({0, 0}, {0, 0}))) << "nothing at all";
  EXPECT_FALSE(p.add(line({0, 0}, {-0.5, 1}))) << "hollow at the tip";
  EXPECT_FALSE(p.add(line({0, 0}, {0, 0.0 / 0.0}))) << "not a number";
  EXPECT_FALSE(p.add({{-1, 0}, {0, 1}, {0, 0.1}, 1.0})) << "an arc that misses its ends";
  EXPECT_FALSE(p.add({{-1, 0}, {0, 1}, {-1, 1}, 1.0})) << "an arc that bulges inwards";
  EXPECT_EQ(p.size(), 0);
  EXPECT_TRUE(p.add(line({0, 0}, {0, 1})));
  EXPECT_FALSE(p.closed());
  EXPECT_FALSE(p.add(line({0, 0.9}, {2, 0.9}))) << "does not begin where the last ended";
  EXPECT_FALSE(p.add(line({0, 1}, {0, 2.0 / 0.0})));
  EXPECT_FALSE(p.add(line({0, 1}, {-1, 1.5}))) << "goes back along the axis";
  EXPECT_TRUE(p.add(line({0, 1}, {2, 0.5})));
  EXPECT_FALSE(p.add(line({2, 0.5}, {3, 0.5}))) << "turns to the left";
  EXPECT_FALSE(p.add(line({2, 0.5}, {2, -0.5}))) << "across the axis";
  EXPECT_TRUE(p.add(line({2, 0.5}, {2, 0})));
  EXPECT_TRUE(p.closed());
  EXPECT_FALSE(p.add(line({2, 0}, {3, 0}))) << "it is closed";
  EXPECT_EQ(p.size(), 3);
}

TEST(Heads, refuse_figures_that_make_no_head) {
  EXPECT_FALSE(flat_head(0.0, 0.5, 4.0));
  EXPECT_FALSE(flat_head(0.5, 0.5, -1.0));
  EXPECT_FALSE(round_end_head(0.6, 0.5, 4.0)) << "narrower at the top";
  EXPECT_FALSE(pear_head(0.4, 0.5, 0.3, 2.0)) << "a corner rounder than the bur";
  EXPECT_FALSE(oval_head(0.6, 0.6, 3.0, 0.4, 8.0));
  EXPECT_FALSE(oval_head(0.6, 0.1, 9.0, 0.4, 8.0)) << "widest beyond its end";
  EXPECT_FALSE(oval_head(0.6, 0.1, 0.3, 0.4, 8.0)) << "wide too near the tip: the flank would run back";
  EXPECT_FALSE(flat_head(0.0 / 0.0, 0.5, 4.0));
}

}  // namespace
}  // namespace cusp::test
