#include "scenarios/format/tool_axis.h"

#include <algorithm>

namespace cusp::scenarios {

SineCosine sine_cosine(double degrees) noexcept {
  const double x = std::clamp(degrees, -90.0, 90.0) * (3.141592653589793 / 180.0);
  double sine = 0, cosine = 0, term = 1;
  for (int n = 0; n < 28; ++n) {
    const bool even = n % 2 == 0;
    const double sign = (n / 2) % 2 == 0 ? 1.0 : -1.0;
    (even ? cosine : sine) += sign * term;
    term = term * x / static_cast<double>(n + 1);
  }
  return {sine, cosine};
}

Vec3 resting_axis(double tool_tilt_deg) noexcept {
  const SineCosine tilt = sine_cosine(tool_tilt_deg);
  return {0.0, tilt.sine, tilt.cosine};
}

}  // namespace cusp::scenarios
