/// Angles from ratios with + - * / and the square root alone, so that every machine gives the same bits.
#pragma once

#include <cmath>

namespace cusp::scenarios {

inline constexpr double kDegreesPerRadian = 57.295779513082320877;

/// Angle in degrees whose tangent is rise / run, in [-90, 90]. Pre: run >= 0, not both 0.
/// Three half-angle steps bring the tangent below 0.2; twelve terms of the series then leave less than 1e-18.
inline double slope_deg(double rise, double run) noexcept {
  const double length = std::sqrt(rise * rise + run * run);
  if (!(length > 0.0)) return 0.0;
  double t = rise / (length + run);  // tangent of half the angle: no division by a run of 0
  for (int i = 0; i < 2; ++i) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double square = t * t;
  double sum = 0.0;
  for (int term = 11; term >= 0; --term) sum = (term % 2 == 0 ? 1.0 : -1.0) / (2.0 * term + 1.0) + square * sum;
  return 8.0 * t * sum * kDegreesPerRadian;
}

}  // namespace cusp::scenarios
