/// splitmix64: the same random numbers on every machine.
#pragma once

#include <cstdint>

namespace cusp::test {

/// Any thread, one object each; the same seed gives the same numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  /// A place in the box. Drawn from its last coordinate to its first: of arguments of one call the compiler chooses the order.
  template <class Vec>
  Vec in(Vec low, Vec high) {
    Vec out;
    for (int i = Vec::length() - 1; i >= 0; --i) out[i] = between(low[i], high[i]);
    return out;
  }

 private:
  std::uint64_t state_;
};

}  // namespace cusp::test
