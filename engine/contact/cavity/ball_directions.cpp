#include "engine/contact/cavity/ball_directions.h"

#include <array>
#include <cmath>

namespace cusp::engine {

namespace {

/// A direction by its place on a face of a cube, -1 to 1 each, moved so that equal parts of the face have about equal shares.
Vec3 direction(int face, double u, double v) {
  const double u2 = u * u, v2 = v * v;
  Vec3 d(0.0);
  const double across = std::sqrt(1.0 - 0.5 * u2 - 0.5 * v2 + u2 * v2 / 3.0);
  d[face % 3] = face < 3 ? across : -across;
  d[(face + 1) % 3] = u * std::sqrt(1.0 - 0.5 - v2 / 6.0);
  d[(face + 2) % 3] = v * std::sqrt(1.0 - 0.5 - u2 / 6.0);
  return d / std::sqrt(glm::dot(d, d));
}

BallDirections made(int side) {
  BallDirections out;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const double u = (2.0 * i + 1.0) / side - 1.0, v = (2.0 * j + 1.0) / side - 1.0, half = 0.5 / side;
        out.fours.push_back({direction(face, u, v),
                             {direction(face, u - half, v - half), direction(face, u + half, v - half),
                              direction(face, u - half, v + half), direction(face, u + half, v + half)}});
      }
  // Neighbours lie a quarter of a circle over 2 side apart, 0.79 / side, diagonal ones 1.4 times that.
  const double near2 = (0.97 / side) * (0.97 / side);
  const int count = static_cast<int>(4 * out.fours.size());
  const auto of = [&](int i) { return out.fours[static_cast<std::size_t>(i / 4)].of[i % 4]; };
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      const Vec3 off = of(a) - of(b);
      if (glm::dot(off, off) < near2) out.pairs.push_back({static_cast<std::int16_t>(a), static_cast<std::int16_t>(b)});
    }
  return out;
}

}  // namespace

const BallDirections& BallDirections::of(int side) {
  static const std::array<BallDirections, kMostSide - kLeastSide + 1> all{made(2), made(3), made(4), made(5), made(6), made(7)};
  return all[static_cast<std::size_t>(side - kLeastSide)];
}

}  // namespace cusp::engine
