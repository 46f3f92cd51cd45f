#include "scenarios/teeth/height_field.h"

namespace cusp::scenarios {

HeightField HeightField::blurred(double sigma_mm) const {
  const int reach = static_cast<int>(3.0 * sigma_mm / kStepMm) + 1;
  std::vector<double> weight(static_cast<std::size_t>(2 * reach + 1));
  double sum = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double x = k * kStepMm / sigma_mm;
    sum += weight[static_cast<std::size_t>(k + reach)] = std::exp(-0.5 * x * x);
  }
  for (double& w : weight) w /= sum;
  HeightField across = *this, out = *this;
  for (int j = 0; j < ny_; ++j) {
    for (int i = 0; i < nx_; ++i) {
      double v = 0.0;
      for (int k = -reach; k <= reach; ++k) v += weight[static_cast<std::size_t>(k + reach)] * double(clamped(i + k, j));
      across.cell(i, j) = static_cast<float>(v);
    }
  }
  for (int j = 0; j < ny_; ++j) {
    for (int i = 0; i < nx_; ++i) {
      double v = 0.0;
      for (int k = -reach; k <= reach; ++k) {
        v += weight[static_cast<std::size_t>(k + reach)] * double(across.clamped(i, j + k));
      }
      out.cell(i, j) = static_cast<float>(v);
    }
  }
  return out;
}

}  // namespace cusp::scenarios
