/// Smooth value noise on a lattice, from a seed: the natural variation of a tooth. Integers until the last step.
#pragma once

#include <cstdint>

#include "engine/base/vec.h"

namespace cusp {

class ValueNoise {
 public:
  ValueNoise(std::uint64_t seed, double wavelength_mm) : seed_(seed), scale_(1.0 / wavelength_mm) {}
  /// Within [-1, 1], zero mean, twice differentiable.
  double at(Vec3 p) const noexcept;

 private:
  double corner(int x, int y, int z) const noexcept;
  std::uint64_t seed_;
  double scale_;
};

/// The n-th draw of a seed: roughly normal, zero mean, unit variance, cut at two sigma.
double normal_draw(std::uint64_t seed, std::uint64_t n) noexcept;

}  // namespace cusp
