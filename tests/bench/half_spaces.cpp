#include "tests/bench/half_spaces.h"

#include <array>
#include <cmath>
#include <utility>

namespace cusp::bench {

namespace {

/// The active set: up to three half spaces with their multipliers.
struct Binding {
  Vec3 c{0.0};
  int count = 0;
  std::array<std::size_t, 3> which{};
  std::array<double, 3> weight{};
};

/// Minimiser on the boundaries of the active set; false if a multiplier is negative.
bool corner_of(Vec3 z, const Mat3& inverse, const std::vector<HalfSpace>& few, Binding& on) {
  double m[3][4];
  for (int i = 0; i < on.count; ++i) {
    const HalfSpace& a = few[on.which[static_cast<std::size_t>(i)]];
    const Vec3 an = inverse * a.n;
    for (int j = 0; j < on.count; ++j) m[i][j] = glm::dot(an, few[on.which[static_cast<std::size_t>(j)]].n);
    m[i][on.count] = a.level - glm::dot(a.n, z);
  }
  for (int i = 0; i < on.count; ++i) {
    int best = i;
    for (int k = i + 1; k < on.count; ++k)
      if (std::fabs(m[k][i]) > std::fabs(m[best][i])) best = k;
    if (std::fabs(m[best][i]) < 1e-13) return false;
    for (int j = 0; j <= on.count; ++j) std::swap(m[i][j], m[best][j]);
    for (int k = 0; k < on.count; ++k) {
      if (k == i) continue;
      const double f = m[k][i] / m[i][i];
      for (int j = i; j <= on.count; ++j) m[k][j] -= f * m[i][j];
    }
  }
  on.c = z;
  for (int i = 0; i < on.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    on.weight[at] = m[i][on.count] / m[i][i];
    if (on.weight[at] < 0.0) return false;
    on.c += inverse * (few[on.which[at]].n * on.weight[at]);
  }
  return true;
}

/// Exact for a few half spaces: tries every active set of at most three.
Binding nearest_of_few(Vec3 z, const Mat3& inverse, const std::vector<HalfSpace>& few, const Binding& otherwise) {
  Binding best = otherwise;
  const Mat3 metric = glm::inverse(inverse);
  double least = 1e300;
  const auto consider = [&](Binding on) {
    if (!corner_of(z, inverse, few, on)) return;
    for (const HalfSpace& h : few)
      if (glm::dot(h.n, on.c) < h.level - 1e-10) return;
    const double far = glm::dot(on.c - z, metric * (on.c - z));
    if (far < least) {
      least = far;
      best = on;
    }
  };
  const std::size_t n = few.size();
  for (std::size_t i = 0; i < n; ++i) consider({{}, 1, {i, 0, 0}, {}});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) consider({{}, 2, {i, j, 0}, {}});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) consider({{}, 3, {i, j, k}, {}});
  return best;
}

}  // namespace

Found nearest_in(Vec3 z, const Mat3& inverse, const std::vector<HalfSpace>& spaces) {
  // Adds the most violated half space until none is violated. Inactive ones may leave, because the distance only grows.
  std::vector<HalfSpace> few;
  Binding on;
  on.c = z;
  for (int pass = 0; pass < 200; ++pass) {
    const HalfSpace* worst = nullptr;
    double most = 1e-10;
    for (const HalfSpace& h : spaces) {
      const double under = h.level - glm::dot(h.n, on.c);
      if (under > most) {
        most = under;
        worst = &h;
      }
    }
    if (worst == nullptr) break;
    if (few.size() >= 6) {
      std::vector<HalfSpace> kept;
      for (int i = 0; i < on.count; ++i) kept.push_back(few[on.which[static_cast<std::size_t>(i)]]);
      few = std::move(kept);
    }
    few.push_back(*worst);
    on = nearest_of_few(z, inverse, few, on);
  }
  Found out{on.c, Mat3(0.0)};
  for (int i = 0; i < on.count; ++i)
    out.bend += few[on.which[static_cast<std::size_t>(i)]].bend * on.weight[static_cast<std::size_t>(i)];
  return out;
}

}  // namespace cusp::bench
