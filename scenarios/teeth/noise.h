/// Smooth value noise on a lattice, from a seed: the natural variation of a tooth. Integers until the last step.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::scenarios {

class ValueNoise {
 public:
  /// Quick no further than `reach_mm` from the origin, along each axis; the same beyond.
  ValueNoise(std::uint64_t seed, double wavelength_mm, Vec3 reach_mm);
  /// Within [-1, 1], zero mean, twice differentiable.
  double at(Vec3 p) const noexcept;

 private:
  double corner(IVec3 at) const noexcept;
  std::size_t index(IVec3 at) const noexcept {
    const IVec3 q = at + far_;
    return static_cast<std::size_t>(q.x + (2 * far_.x + 1) * (q.y + (2 * far_.y + 1) * q.z));
  }
  std::uint64_t seed_;
  double scale_;
  IVec3 far_{0};               // of the corners that are kept
  std::vector<double> corners_;
};

/// The n-th draw of a seed: roughly normal, zero mean, unit variance, cut at two sigma.
double normal_draw(std::uint64_t seed, std::uint64_t n) noexcept;

}  // namespace cusp::scenarios
