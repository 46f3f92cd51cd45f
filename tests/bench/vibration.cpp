#include "tests/bench/vibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cusp::bench {

namespace {


/// Bilinear transform of s^2 / (s^2 + sqrt(2) s + 1), by samples of 1 ms.
void high_pass(std::vector<Vec3>& x) {
  const double w = std::tan(std::numbers::pi * kVibrationHz * 1e-3);
  const double norm = 1.0 / (1.0 + std::sqrt(2.0) * w + w * w);
  const double b = norm, a1 = 2.0 * (w * w - 1.0) * norm, a2 = (1.0 - std::sqrt(2.0) * w + w * w) * norm;
  // Initial state: the first sample for all time before.
  Vec3 x1 = x.empty() ? Vec3(0.0) : x.front(), x2 = x1, y1(0.0), y2(0.0);
  for (Vec3& v : x) {
    const Vec3 y = b * (v - 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1;
    x1 = v;
    y2 = y1;
    y1 = y;
    v = y;
  }
}

}  // namespace

double vibration_n(const std::vector<Vec3>& force_n, std::size_t from, std::size_t to) {
  std::vector<Vec3> x = force_n;
  high_pass(x);
  std::ranges::reverse(x);
  high_pass(x);
  std::ranges::reverse(x);
  Vec3 low = x[from], high = x[from];
  for (std::size_t i = from; i < to; ++i) {
    low = glm::min(low, x[i]);
    high = glm::max(high, x[i]);
  }
  const Vec3 wide = high - low;
  return std::max({wide.x, wide.y, wide.z});
}

}  // namespace cusp::bench
