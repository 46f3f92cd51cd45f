#include "scenarios/teeth/curve.h"

#include <algorithm>
#include <cassert>

namespace cusp::scenarios {
namespace {

/// Fritsch-Carlson slopes: the curve never overshoots its knots.
std::vector<double> pchip_slopes(const std::vector<Knot>& k) {
  const std::size_t n = k.size();
  std::vector<double> slope(n, 0.0), h(n - 1), delta(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = k[i + 1].z - k[i].z;
    delta[i] = (k[i + 1].value - k[i].value) / h[i];
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (delta[i - 1] * delta[i] <= 0.0) continue;
    const double w1 = 2.0 * h[i] + h[i - 1], w2 = h[i] + 2.0 * h[i - 1];
    slope[i] = (w1 + w2) / (w1 / delta[i - 1] + w2 / delta[i]);
  }
  const auto end_slope = [](double h0, double h1, double d0, double d1) {
    double s = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (s * d0 <= 0.0) s = 0.0;
    else if (d0 * d1 < 0.0 && std::fabs(s) > 3.0 * std::fabs(d0)) s = 3.0 * d0;
    return s;
  };
  if (n == 2) {
    slope[0] = slope[1] = delta[0];
  } else {
    slope[0] = end_slope(h[0], h[1], delta[0], delta[1]);
    slope[n - 1] = end_slope(h[n - 2], h[n - 3], delta[n - 2], delta[n - 3]);
  }
  return slope;
}

}  // namespace

Curve::Curve(std::vector<Knot> knots, Beyond beyond, double blur_mm) {
  assert(!knots.empty());
  std::stable_sort(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.z < b.z; });
  knots.erase(std::unique(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return b.z - a.z < 1e-9; }),
              knots.end());
  if (knots.size() == 1) {
    samples_.assign(1, knots.front().value);
    first_ = knots.front().z;
    return;
  }
  const std::vector<double> slope = pchip_slopes(knots);
  const double margin = 3.0;  // mm beyond the knots: more than any blur reaches, and all that a cap or a neck reads
  first_ = knots.front().z - margin;
  const auto count = static_cast<std::size_t>((knots.back().z + margin - first_) / kStepMm) + 2;
  std::vector<double> raw(count);
  std::size_t span = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = first_ + static_cast<double>(i) * kStepMm;
    if (z <= knots.front().z) {
      raw[i] = knots.front().value + (beyond == Beyond::linear ? slope.front() * (z - knots.front().z) : 0.0);
      continue;
    }
    if (z >= knots.back().z) {
      raw[i] = knots.back().value + (beyond == Beyond::linear ? slope.back() * (z - knots.back().z) : 0.0);
      continue;
    }
    while (z > knots[span + 1].z) ++span;
    const Knot &a = knots[span], &b = knots[span + 1];
    const double h = b.z - a.z, t = (z - a.z) / h, t2 = t * t, t3 = t2 * t;
    raw[i] = (2 * t3 - 3 * t2 + 1) * a.value + (t3 - 2 * t2 + t) * h * slope[span] + (3 * t2 - 2 * t3) * b.value +
             (t3 - t2) * h * slope[span + 1];
  }
  const int reach = static_cast<int>(3.0 * blur_mm / kStepMm);
  if (reach < 1) {
    samples_ = std::move(raw);
    return;
  }
  std::vector<double> weight(static_cast<std::size_t>(reach) + 1);
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    const double x = i * kStepMm / blur_mm;
    weight[static_cast<std::size_t>(i)] = std::exp(-0.5 * x * x);
    sum += (i == 0 ? 1.0 : 2.0) * weight[static_cast<std::size_t>(i)];
  }
  samples_.resize(count);
  const int last = static_cast<int>(count) - 1;
  for (int i = 0; i <= last; ++i) {
    double v = weight[0] * raw[static_cast<std::size_t>(i)];
    for (int j = 1; j <= reach; ++j) {
      v += weight[static_cast<std::size_t>(j)] * (raw[static_cast<std::size_t>(std::max(0, i - j))] +
                                                  raw[static_cast<std::size_t>(std::min(last, i + j))]);
    }
    samples_[static_cast<std::size_t>(i)] = v / sum;
  }
}

Line2::Line2(std::vector<Vec2> points) : points_(std::move(points)), along_(points_.size(), 0.0) {
  assert(!points_.empty());
  low_ = high_ = points_.front();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) along_[i] = along_[i - 1] + glm::length(points_[i] - points_[i - 1]);
    low_ = glm::min(low_, points_[i]);
    high_ = glm::max(high_, points_[i]);
  }
  constexpr std::size_t kRun = 6;
  for (std::size_t i = 0; i + 1 < points_.size(); i += kRun) {
    Run run{i, std::min(i + kRun, points_.size() - 1), points_[i], points_[i]};
    for (std::size_t k = i; k <= run.end; ++k) {
      run.low = glm::min(run.low, points_[k]);
      run.high = glm::max(run.high, points_[k]);
    }
    runs_.push_back(run);
  }
}

Line2::Nearest Line2::nearest(Vec2 p) const noexcept {
  Nearest best;
  best.point = points_.front();
  double best2 = glm::dot(p - best.point, p - best.point);
  // The line comes at least as near as to the far corner of any run's box.
  double bound = best2;
  for (const Run& run : runs_) {
    const Vec2 furthest = glm::max(glm::abs(p - run.low), glm::abs(p - run.high));
    bound = std::min(bound, glm::dot(furthest, furthest));
  }
  for (const Run& run : runs_) {
    const Vec2 off = glm::max(glm::max(run.low - p, p - run.high), Vec2(0.0));
    if (glm::dot(off, off) > (1.0 + 1e-9) * std::min(bound, best2) + 1e-12) continue;  // with a margin for rounding
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Vec2 a = points_[i], ab = points_[i + 1] - a;
      const double len2 = glm::dot(ab, ab);
      double t = len2 > 0.0 ? glm::dot(p - a, ab) / len2 : 0.0;
      t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
      const Vec2 c = a + t * ab;
      const double d2 = glm::dot(p - c, p - c);
      if (d2 < best2) {
        best2 = d2;
        best.point = c;
        best.segment = i;
        best.share = t;
      }
    }
  }
  best.distance = std::sqrt(best2);
  if (points_.size() > 1) {
    best.along = along_[best.segment] + best.share * (along_[best.segment + 1] - along_[best.segment]);
  }
  return best;
}

}  // namespace cusp::scenarios
