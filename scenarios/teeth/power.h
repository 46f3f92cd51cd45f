/// Powers of two positive numbers at once. Of basic operations alone: the same bits on every machine, in half of libm's time.
#pragma once

#include <bit>
#include <cstdint>

namespace cusp::scenarios {

using Pair = double __attribute__((vector_size(16)));

namespace power_detail {

using Bits = std::uint64_t __attribute__((vector_size(16)));
constexpr double kTwoPerLn2 = 2.885390081777926815, kLn2 = 0.693147180559945309;

/// kBias keeps the shifted exponent positive: lanes of 64 bits have no arithmetic shift.
/// x = 2^e m with m within [sqrt(1/2), sqrt(2)); log2(m) = 2/ln(2) atanh(s) with s = (m - 1) / (m + 1), whose series ends at s^19.
inline Pair log2_of(Pair x) noexcept {
  constexpr std::uint64_t kRootOfHalf = 0x3FE6A09E667F3BCD, kOneExponent = std::uint64_t{1} << 52, kBias = 1024;
  const Bits bits = std::bit_cast<Bits>(x), biased = (bits - kRootOfHalf + kBias * kOneExponent) >> 52;
  const Pair exponent = std::bit_cast<Pair>(biased | std::bit_cast<std::uint64_t>(0x1p52)) - (0x1p52 + static_cast<double>(kBias));
  const Pair m = std::bit_cast<Pair>(bits - ((biased - kBias) << 52)), s = (m - 1.0) / (m + 1.0);
  const Pair z = s * s, z2 = z * z, z4 = z2 * z2;
  constexpr double c = kTwoPerLn2;
  const Pair low = c + c / 3 * z + (c / 5 + c / 7 * z) * z2, high = c / 9 + c / 11 * z + (c / 13 + c / 15 * z) * z2;
  return exponent + s * (low + high * z4 + (c / 17 + c / 19 * z) * (z4 * z4));
}

/// y = k + f with whole k and f within ±1/2; the series of e^(f ln 2) ends at the thirteenth power.
inline Pair exp2_of(Pair y) noexcept {
  constexpr double kToWhole = 0x1.8p52;
  const Pair whole = y + kToWhole, t = (y - (whole - kToWhole)) * kLn2, t2 = t * t, t4 = t2 * t2;
  const Pair p0 = 1.0 + t + (1.0 / 2 + 1.0 / 6 * t) * t2;
  const Pair p4 = 1.0 / 24 + 1.0 / 120 * t + (1.0 / 720 + 1.0 / 5040 * t) * t2;
  const Pair p8 = 1.0 / 40320 + 1.0 / 362880 * t + (1.0 / 3628800 + 1.0 / 39916800 * t) * t2;
  const Pair p12 = 1.0 / 479001600 + 1.0 / 6227020800 * t;
  return std::bit_cast<Pair>(std::bit_cast<Bits>(p0 + p4 * t4 + (p8 + p12 * t4) * (t4 * t4)) + (std::bit_cast<Bits>(whole) << 52));
}

}  // namespace power_detail

/// x^n. Pre: x normal and positive, |n log2(x)| < 1000. Relative error below 1e-15 (4 + |n log2(x)|).
inline Pair power(Pair x, Pair n) noexcept { return power_detail::exp2_of(n * power_detail::log2_of(x)); }

}  // namespace cusp::scenarios
