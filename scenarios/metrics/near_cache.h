/// The answers of a target that were asked last. Tetrahedra of a cell share corners, and cells beside each other do too, so most
/// places are asked for many times. An answer depends on the place's bits alone, never on what was asked before.
/// Thread: one.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "scenarios/modules.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

/// Of `Answer` by a place of as many coordinates as `Point` has.
template <class Point, class Answer, std::size_t kEntries>
class PlaceCache {
 public:
  /// ask(): the answer at p. The reference lasts until the next call.
  template <class Ask>
  const Answer& at(const Point& p, Ask&& ask) noexcept {
    Bits bits;
    std::uint64_t mixed = 0;
    for (int i = 0; i < Point::length(); ++i) {
      bits[static_cast<std::size_t>(i)] = std::bit_cast<std::uint64_t>(p[i]);
      mixed = (mixed ^ bits[static_cast<std::size_t>(i)]) * kMix;
    }
    Entry& entry = entries_[(mixed >> 32) % kEntries];
    if (entry.bits != bits) entry = {bits, ask()};
    return entry.answer;
  }

 private:
  using Bits = std::array<std::uint64_t, Point::length()>;
  static constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio, odd
  static constexpr Bits nowhere() noexcept {
    Bits out;
    out.fill(std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN()));
    return out;
  }
  struct Entry {
    Bits bits = nowhere();
    Answer answer{};
  };
  std::array<Entry, kEntries> entries_;
};

/// Twice the lattice places of the cells of half a brick.
using NearCache = PlaceCache<Vec3, Near, 512>;
/// Columns of a brick's cells, with their halves.
using OutlineCache = PlaceCache<Vec2, double, 512>;

}  // namespace cusp::scenarios
