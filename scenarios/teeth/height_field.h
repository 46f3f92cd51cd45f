/// A function of two coordinates, sampled every 0.05 mm and read back with cubic weights: heights and wall features
/// would show the cells of a linear reading as facets in grazing light.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/vec.h"

namespace cusp::scenarios {

class HeightField {
 public:
  static constexpr double kStepMm = 0.05;
  HeightField() = default;
  HeightField(glm::dvec2 low, glm::dvec2 high)
      : low_(low),
        nx_(static_cast<int>(std::ceil((high.x - low.x) / kStepMm)) + 1),
        ny_(static_cast<int>(std::ceil((high.y - low.y) / kStepMm)) + 1),
        values_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), 0.0f) {}

  bool empty() const noexcept { return values_.empty(); }
  int width() const noexcept { return nx_; }
  int height() const noexcept { return ny_; }
  glm::dvec2 place(int i, int j) const noexcept { return low_ + kStepMm * glm::dvec2(i, j); }
  glm::dvec2 low() const noexcept { return low_; }
  glm::dvec2 high() const noexcept { return place(nx_ - 1, ny_ - 1); }
  float& cell(int i, int j) noexcept { return values_[index(i, j)]; }
  float cell(int i, int j) const noexcept { return values_[index(i, j)]; }
  float clamped(int i, int j) const noexcept { return cell(std::clamp(i, 0, nx_ - 1), std::clamp(j, 0, ny_ - 1)); }

  /// Catmull-Rom; beyond the map the value of its rim.
  double at(double x, double y) const noexcept {
    const double fx = std::clamp((x - low_.x) * (1.0 / kStepMm), 0.0, double(nx_ - 1));
    const double fy = std::clamp((y - low_.y) * (1.0 / kStepMm), 0.0, double(ny_ - 1));
    const int i = std::min(static_cast<int>(fx), nx_ - 2), j = std::min(static_cast<int>(fy), ny_ - 2);
    double wx[4], wy[4];
    weights(fx - i, wx);
    weights(fy - j, wy);
    double sum = 0.0;
    if (i >= 1 && j >= 1 && i + 2 < nx_ && j + 2 < ny_) {
      const float* row = &values_[index(i - 1, j - 1)];
      for (int b = 0; b < 4; ++b, row += nx_) {
        sum += wy[b] * (wx[0] * double(row[0]) + wx[1] * double(row[1]) + wx[2] * double(row[2]) + wx[3] * double(row[3]));
      }
      return sum;
    }
    for (int b = 0; b < 4; ++b) {
      double part = 0.0;
      for (int a = 0; a < 4; ++a) part += wx[a] * double(clamped(i - 1 + a, j - 1 + b));
      sum += wy[b] * part;
    }
    return sum;
  }
  double lowest() const noexcept { return double(*std::min_element(values_.begin(), values_.end())); }

  /// Gaussian, separable; the rim repeats.
  HeightField blurred(double sigma_mm) const;

 private:
  std::size_t index(int i, int j) const noexcept {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(nx_) * static_cast<std::size_t>(j);
  }
  static void weights(double t, double* w) noexcept {
    const double t2 = t * t, t3 = t2 * t;
    w[0] = 0.5 * (2.0 * t2 - t3 - t);
    w[1] = 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0);
    w[2] = 0.5 * (4.0 * t2 - 3.0 * t3 + t);
    w[3] = 0.5 * (t3 - t2);
  }
  glm::dvec2 low_{0.0};
  int nx_ = 0, ny_ = 0;
  std::vector<float> values_;
};

}  // namespace cusp::scenarios
