// The powers of the sections agree with libm's, and are exact where that can be known.
#include "scenarios/teeth/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cusp::scenarios {
namespace {

double one(double x, double n) {
  const Pair out = power(Pair{x, 1.0}, Pair{n, 1.0});
  EXPECT_EQ(out[1], 1.0);
  return out[0];
}

TEST(Power, IsLibmsWithinItsErrorOverAllThatSectionsAsk) {
  for (double x = 1e-9; x < 1e3; x *= 1.0371) {
    for (const double n : {1.2, 1.9, 2.0, 2.7, 4.0, 6.0, 1.0 / 1.2, 1.0 / 2.7, 1.0 / 6.0}) {
      const double want = std::pow(x, n);
      EXPECT_LE(std::fabs(one(x, n) - want), 1e-15 * (4.0 + std::fabs(n * std::log2(x))) * want) << x << " ^ " << n;
    }
  }
}

TEST(Power, IsExactForPowersOfTwo) {
  for (int k = -29; k <= 10; ++k) EXPECT_EQ(one(std::ldexp(1.0, k), 3.0), std::ldexp(1.0, 3 * k));
}

TEST(Power, OfOneIsOneWhateverTheExponent) {
  for (const double n : {0.2, 1.0, 2.7, 9.0}) EXPECT_EQ(one(1.0, n), 1.0);
}

TEST(Power, OfTwoAtOnceAreThoseOfEachAlone) {
  const Pair both = power(Pair{0.37, 12.5}, Pair{2.7, 0.4});
  EXPECT_EQ(both[0], one(0.37, 2.7));
  EXPECT_EQ(both[1], one(12.5, 0.4));
}

}  // namespace
}  // namespace cusp::scenarios
