/// Coulomb friction of a proxy, regularised by its own speed: at rest it holds nothing, so it cannot feed energy.
#pragma once

#include <cmath>

#include "engine/base/vec.h"

namespace cusp::engine {

inline constexpr double kFrictionWholeMmS = 2.0;  // speed at which the Coulomb force is whole

/// Newtons, against the proxy's velocity. spring_n: the push that the cone stands on.
inline Vec3 coulomb_n(Vec3 velocity_mm_s, double coefficient, double spring_n) noexcept {
  const double speed = std::sqrt(glm::dot(velocity_mm_s, velocity_mm_s));
  if (!(speed > 1e-9)) return Vec3(0.0);
  const double whole = speed < kFrictionWholeMmS ? speed / kFrictionWholeMmS : 1.0;
  return velocity_mm_s * (-coefficient * spring_n * whole / speed);
}

}  // namespace cusp::engine
