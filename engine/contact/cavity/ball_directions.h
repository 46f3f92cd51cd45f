/// Directions about a ball, spread evenly, and which of them are neighbours. Thread: any.
/// The first of() takes the memory, at the construction of CavityWalls; later ones are wait-free.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::engine {

struct BallDirections {
  /// Four directions about a fifth; four k has the directions 4 k to 4 k + 3.
  struct Four {
    Vec3 middle, of[4];
  };
  struct Pair {
    std::int16_t a, b;
  };
  std::vector<Four> fours;
  std::vector<Pair> pairs;  // of neighbours

  static constexpr int kLeastSide = 2, kMostSide = 7;
  /// side: fours along a side of a face of the cube about the ball, kLeastSide to kMostSide.
  static const BallDirections& of(int side);
};

}  // namespace cusp::engine
