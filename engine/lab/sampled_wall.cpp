#include "engine/lab/sampled_wall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace cusp::engine::lab {

namespace {

constexpr int kMostDelay = 6;
constexpr std::size_t kMostDegree = kMostDelay + 3;
using Coefficients = std::array<double, kMostDegree + 1>;  // of z to the power of the place

struct Polynomial {
  Coefficients c{};
  std::size_t degree = 0;
};

/// The hold equivalent of m x'' + b x' + k x = F: x(z) / F(z) = (n1 z + n0) / (z^2 + d1 z + d0).
struct Held {
  double n1 = 0, n0 = 0, d1 = 0, d0 = 0;
};

/// SI units.
struct Oscillator {
  double mass, damping, stiffness;
};

Held held(const Oscillator& of, double tick) {
  const auto [mass, damping, stiffness] = of;
  using Complex = std::complex<double>;
  Held out;
  if (stiffness <= 0.0) {
    // Roots 0 and -b/m. x after a tick of unit force from rest, and v, in closed form.
    const double a = damping / mass, t = a * tick;
    // Below 1e-4 the series: the closed forms lose half their digits there.
    const double small = -std::expm1(-t);
    const double v = t < 1e-4 ? tick / mass * (1.0 - t / 2.0 + t * t / 6.0) : small / damping;
    const double x = t < 1e-4 ? tick * tick / mass * (0.5 - t / 6.0 + t * t / 24.0) : (tick - small / a) / damping;
    const double p = 1.0 - small;                                                   // factor of v
    const double xv = t < 1e-4 ? tick * (1.0 - t / 2.0 + t * t / 6.0) : small / a;  // x gained from v
    out.d1 = -(1.0 + p);
    out.d0 = p;
    out.n1 = x;
    out.n0 = xv * v - p * x;
    return out;
  }
  // Roots s1, s2 of m s^2 + b s + k. A double root is separated by 1e-9: the closed form has a pole there.
  const double half = damping / (2.0 * mass);
  double square = half * half - stiffness / mass;
  if (std::fabs(square) < 1e-9 * stiffness / mass) square = -1e-9 * stiffness / mass;
  const Complex root = std::sqrt(Complex(square, 0.0));
  const Complex s1 = -half + root, s2 = -half - root, e1 = std::exp(s1 * tick), e2 = std::exp(s2 * tick);
  const Complex parted = s1 - s2;
  const double xx = ((s1 * e2 - s2 * e1) / parted).real(), xv = ((e1 - e2) / parted).real();
  const double vv = ((s1 * e1 - s2 * e2) / parted).real();
  const double x = (1.0 - xx) / stiffness, v = xv / mass;
  out.d1 = -(e1 + e2).real();
  out.d0 = (e1 * e2).real();
  out.n1 = x;
  out.n0 = xv * v - vv * x;
  return out;
}

Polynomial characteristic(const SampledWall& wall) {
  const double mass = wall.mass_kg + (wall.grip.holds() ? wall.grip.mass_kg : 0.0);
  const double damping = wall.damping_ns_per_m + (wall.grip.holds() ? wall.grip.damping_ns_per_m : 0.0);
  const Held h = held({mass, damping, wall.grip.stiffness_n_per_mm * 1000.0}, wall.tick_s);
  const double k = wall.stiffness_n_per_mm * 1000.0, b = wall.virtual_damping_ns_per_m / wall.tick_s;
  const auto delay = static_cast<std::size_t>(std::clamp(wall.delay_ticks, 0, kMostDelay));
  Polynomial p;
  if (b == 0.0) {
    p.degree = delay + 2;
    p.c[delay + 2] = 1.0;
    p.c[delay + 1] = h.d1;
    p.c[delay] = h.d0;
    p.c[1] += k * h.n1;
    p.c[0] += k * h.n0;
    return p;
  }
  p.degree = delay + 3;
  p.c[delay + 3] = 1.0;
  p.c[delay + 2] = h.d1;
  p.c[delay + 1] = h.d0;
  // ((K + b) z - b) (n1 z + n0)
  p.c[2] += (k + b) * h.n1;
  p.c[1] += (k + b) * h.n0 - b * h.n1;
  p.c[0] += -b * h.n0;
  return p;
}

double largest_root(const Polynomial& p) {
  using Complex = std::complex<double>;
  std::array<Complex, kMostDegree> z;
  for (std::size_t i = 0; i < p.degree; ++i)
    z[i] = 0.9 * std::polar(1.0, 0.4 + 6.283185307179586 * static_cast<double>(i) / static_cast<double>(p.degree));
  for (int pass = 0; pass < 200; ++pass) {
    double moved = 0.0;
    for (std::size_t i = 0; i < p.degree; ++i) {
      Complex value = p.c[p.degree], slope = 0.0, others = 0.0;
      for (std::size_t n = p.degree; n-- > 0;) {
        slope = slope * z[i] + value;
        value = value * z[i] + p.c[n];
      }
      for (std::size_t j = 0; j < p.degree; ++j)
        if (j != i && z[i] != z[j]) others += 1.0 / (z[i] - z[j]);
      const Complex below = slope - value * others;
      if (value == 0.0 || below == 0.0) continue;
      const Complex step = value / below;
      z[i] -= step;
      moved = std::max(moved, std::abs(step));
    }
    if (moved < 1e-14) break;
  }
  double most = 0.0;
  for (std::size_t i = 0; i < p.degree; ++i) most = std::max(most, std::abs(z[i]));
  return most;
}

}  // namespace

double spectral_radius(const SampledWall& wall) noexcept { return largest_root(characteristic(wall)); }

double critical_stiffness_n_per_mm(SampledWall wall) noexcept {
  // A free mass has an eigenvalue of 1, so the search starts at a small stiffness.
  constexpr double kFirst = 1e-4, kMost = 1e4, kFactor = 1.05;
  // That stiffness moves the eigenvalue from 1 by K T / b, far above the roots' rounding.
  const auto stable = [&wall](double k) {
    wall.stiffness_n_per_mm = k;
    return spectral_radius(wall) < 1.0;
  };
  if (!stable(kFirst)) return 0.0;
  double low = kFirst, high = kFirst * kFactor;
  while (high < kMost && stable(high)) {
    low = high;
    high *= kFactor;
  }
  if (high >= kMost) return kMost;
  while (high - low > 1e-6 * low) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

double colgate_bound_n_per_mm(const SampledWall& wall) noexcept {
  return std::max(0.0, 2.0 * (wall.damping_ns_per_m - std::fabs(wall.virtual_damping_ns_per_m)) / wall.tick_s * 1e-3);
}

double abbott_okamura_bound_n_per_mm(const DeviceSettings& device, double tick_s) noexcept {
  const double viscous = 2.0 * device.damping_ns_per_m / tick_s * 1e-3;
  return device.encoder_step_mm > 0.0 ? std::min(viscous, 2.0 * device.friction_n / device.encoder_step_mm) : viscous;
}

}  // namespace cusp::engine::lab
