/// Smooth curves of the tooth tables: sampled functions of z, and polylines with the nearest point on them.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::scenarios {

using Vec2 = glm::dvec2;

struct Knot {
  double z = 0.0, value = 0.0;
};

/// Continuation of a curve beyond its knots.
enum class Beyond : std::uint8_t { constant, linear };

/// Monotone cubic (PCHIP) through knots, then blurred, kept as samples. Without the blur every knot shows as a band
/// in grazing light.
class Curve {
 public:
  static constexpr double kBlurMm = 0.4;   // teeth.md
  static constexpr double kStepMm = 0.02;  // linear reading then errs by under 0.1 µm on these curves
  Curve() = default;
  /// Knots in any order of z; at least one.
  explicit Curve(std::vector<Knot> knots, Beyond beyond = Beyond::constant, double blur_mm = kBlurMm);
  /// The constant zero has no samples.
  double at(double z) const noexcept {
    if (samples_.empty()) return 0.0;
    const double t = (z - first_) * (1.0 / kStepMm);
    if (!(t > 0.0)) return samples_.front();
    const auto i = static_cast<std::size_t>(t);
    if (i + 1 >= samples_.size()) return samples_.back();
    const double f = t - static_cast<double>(i);
    return samples_[i] + f * (samples_[i + 1] - samples_[i]);
  }

 private:
  double first_ = 0.0;
  std::vector<double> samples_;
};

/// Catmull-Rom through the points, `per_span` samples a span (1: the points themselves). T: Vec2 or Vec3.
template <class T>
std::vector<T> smooth_line(std::span<const T> points, int per_span) {
  std::vector<T> out;
  const auto n = points.size();
  if (n < 3 || per_span < 2) {
    out.assign(points.begin(), points.end());
    if (n == 2 && per_span >= 2) {
      out.clear();
      for (int k = 0; k <= per_span; ++k) out.push_back(points[0] + (points[1] - points[0]) * (double(k) / per_span));
    }
    return out;
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const T p1 = points[i], p2 = points[i + 1];
    const T p0 = i > 0 ? points[i - 1] : p1 + (p1 - p2);
    const T p3 = i + 2 < n ? points[i + 2] : p2 + (p2 - p1);
    for (int k = 0; k < per_span; ++k) {
      const double t = double(k) / per_span, t2 = t * t, t3 = t2 * t;
      out.push_back(0.5 * (2.0 * p1 + (p2 - p0) * t + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * t2 +
                           (3.0 * p1 - p0 - 3.0 * p2 + p3) * t3));
    }
  }
  out.push_back(points[n - 1]);
  return out;
}

/// A polyline in a plane, ready to be asked for its nearest point.
class Line2 {
 public:
  explicit Line2(std::vector<Vec2> points);
  struct Nearest {
    double distance = 0.0;
    double along = 0.0;   // arc length from the first point
    std::size_t segment = 0;
    double share = 0.0;   // within the segment
    Vec2 point{0.0};
  };
  Nearest nearest(Vec2 p) const noexcept;
  double length() const noexcept { return along_.back(); }
  const std::vector<Vec2>& points() const noexcept { return points_; }
  Vec2 low() const noexcept { return low_; }
  Vec2 high() const noexcept { return high_; }

 private:
  /// Segments in a row, with a box about them: most are too far away to be tested one by one.
  struct Run {
    std::size_t begin = 0, end = 0;
    Vec2 low{0.0}, high{0.0};
  };
  std::vector<Vec2> points_;
  std::vector<double> along_;
  std::vector<Run> runs_;
  Vec2 low_{0.0}, high_{0.0};
};

inline double smoothstep(double a, double b, double x) noexcept {
  double t = (x - a) / (b - a);
  t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
  return t * t * (3.0 - 2.0 * t);
}
/// Rounded maximum: exceeds max(a, b) by at most k/4, where a = b.
inline double smax(double a, double b, double k) noexcept {
  const double h = k - std::fabs(a - b);
  const double m = a > b ? a : b;
  return h > 0.0 ? m + h * h / (4.0 * k) : m;
}
inline double smin(double a, double b, double k) noexcept { return -smax(-a, -b, k); }

}  // namespace cusp::scenarios
