// The exact swept bur against closed forms and against every place of the path.
#include "tests/bench/swept_bur.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string_view>

#include "engine/tool/swept.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/modules.h"
#include "tests/random.h"

namespace cusp::bench {
namespace {

using test::Random;

constexpr double kPi = std::numbers::pi;

Bur catalogue(const char* number) {
  const CatalogueBur* entry = catalogue_bur(number);
  EXPECT_NE(entry, nullptr) << number;
  return entry == nullptr ? Bur{} : entry->bur;
}

TEST(ShareOfACube, BehindAPlaneEqualsItsClosedForm) {
  // A half by symmetry; a slab; a corner's pyramid of edges 0.3: 0.3^3 / 6.
  EXPECT_NEAR(share_behind(unit({0.3, -0.5, 0.8}), 0.0), 0.5, 1e-12);
  EXPECT_NEAR(share_behind({0.0, 0.0, -1.0}, 0.2), 0.7, 1e-12);
  EXPECT_NEAR(share_behind(unit({1.0, 1.0, 1.0}), (0.3 - 1.5) / std::sqrt(3.0)), 0.0045, 1e-12);
  // Of a wedge of edges 0.4 and 0.4: half of their product. Nearly one, within the 1e-5 that counts as flat.
  EXPECT_NEAR(share_behind(unit({1.0, 1.0, 0.0}), (0.4 - 1.0) / std::sqrt(2.0)), 0.08, 1e-12);
  EXPECT_NEAR(share_behind(unit({1.0, 1.0, 1e-4}), (0.4 - 1.0) / std::sqrt(2.0)), 0.08, 1e-4);
  EXPECT_EQ(share_behind({0.0, 0.0, 1.0}, 0.6), 1.0);
  EXPECT_EQ(share_behind({0.0, 0.0, 1.0}, -0.6), 0.0);
}

TEST(UprightVolume, EqualsTheTextbooks) {
  // Ball of 0.5, 0.75 deep: half a ball and a cylinder; then a stadium. Cylinder of 0.5: discs and strips.
  const Bur ball = catalogue("2"), fissure = catalogue("57"), cone = catalogue("35");
  const double r = 0.5, half_ball = 2.0 / 3.0 * kPi * r * r * r;
  EXPECT_NEAR(upright_mm3(ball, 0.75, 0.0), half_ball + kPi * r * r * 0.25, 1e-9);
  EXPECT_NEAR(upright_mm3(fissure, 2.0, 0.0), kPi * r * r * 2.0, 1e-9);
  EXPECT_NEAR(upright_mm3(fissure, 2.0, 1.5), (kPi * r * r + 2.0 * r * 1.5) * 2.0, 1e-9);
  EXPECT_NEAR(upright_mm3(ball, r, 1.5), half_ball + 1.5 * kPi * r * r / 2.0, 1e-9);
  // An inverted cone widens its hole by its tip alone: straight down it leaves a cylinder.
  EXPECT_NEAR(upright_mm3(cone, 0.8, 0.0), kPi * r * r * 0.8, 1e-9);
  EXPECT_LT(upright_mm3(cone, 0.8, 1.5), (kPi * r * r + 2.0 * r * 1.5) * 0.8);
}

TEST(SweptBur, IsAsNearAsTheNearestPlaceOnThePath) {
  // Every 0.1 um of the way: what lies between is nearer by less than half of that, and hardly.
  Random random(11);
  const Vec3 axis = unit({0.3, 0.45, 0.84});
  for (const char* number : {"2", "35", "57", "330", "862-012"}) {
    const Bur bur = catalogue(number);
    const std::vector<Vec3> places = {{0.0, 0.0, 0.0}, {0.3, 0.1, -0.2}, {0.31, 0.1, -0.2}, {0.32, 0.105, -0.2}, {0.5, 0.4, -0.25}};
    const SweptBur swept(bur, axis, places);
    for (int k = 0; k < 20; ++k) {
      const Vec3 place = random.in(Vec3(-0.8, -0.8, -1.0), Vec3(1.3, 1.3, 1.5));
      double least = 1e300;
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const int parts = static_cast<int>(length(places[i + 1] - places[i]) / 1e-4) + 1;
        for (int p = 0; p <= parts; ++p)
          least = std::min(least, head_distance(bur, axis, place - (places[i] + (places[i + 1] - places[i]) *
                                                                                     (static_cast<double>(p) / parts))));
      }
      Vec3 gradient;
      const double d = swept.distance_mm(place, gradient);
      EXPECT_LE(d, least + 1e-9) << number;
      EXPECT_GE(d, least - 5e-5) << number;
      // With far_mm the result is beyond it on the same side.
      const double far = 0.5 * std::fabs(d), bound = swept.distance_mm(place, gradient, far);
      EXPECT_TRUE(std::fabs(bound) >= far && (bound > 0.0) == (d > 0.0)) << number;
    }
  }
}

TEST(SweptBur, HasTheVolumeOfTheClosedForm) {
  // Measured within 1.5e-5; within 4e-5 for the inverted cone, whose rim leaves walls that no head stays behind.
  const Frame face = Frame::of({0.11, 0.18, 1.0}, {1.0, 0.51, 0.0}, {0.013, 0.02, -0.03});
  for (const char* number : {"2", "35", "57", "330"}) {
    const Bur bur = catalogue(number);
    const double tip = bur.head.ball() ? -bur.radius_mm : bur.head.low();
    for (const double aside : {0.0, 1.5}) {
      if (aside > 0.0 && std::string_view(number) == "35") continue;  // the slow one
      const double deep = std::min(1.2, 0.9 * 2.0 * bur.radius_mm);
      const Vec3 above = face.to_world({0.0, 0.0, -tip + 0.05}), down = face.to_world({0.0, 0.0, -tip - deep});
      std::vector<Vec3> places{above, down};
      if (aside > 0.0) places.push_back(down + face.x * aside);
      const double exact = upright_mm3(bur, deep, aside);
      EXPECT_NEAR(SweptBur(bur, face.z, places).volume_mm3(face), exact, (std::string_view(number) == "35" ? 1.5e-4 : 2e-5) * exact)
          << number << ' ' << aside;
    }
  }
}

TEST(SweptBur, TakesNothingInFrontOfTheFace) {
  const Bur bur = catalogue("57");
  const SweptBur swept(bur, {0.0, 0.0, 1.0}, {{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}});
  EXPECT_EQ(swept.volume_mm3(Frame{}), 0.0);
}

}  // namespace
}  // namespace cusp::bench
