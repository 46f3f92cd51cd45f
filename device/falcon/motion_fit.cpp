#include "device/falcon/motion_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cusp::device::falcon {

namespace {

constexpr double kWindowS = 0.040;     // long against an encoder's step, short against a sweep
constexpr double kStrideS = 0.010;
constexpr double kSlowestMS = 0.012;   // slower than this the sign of the motion is not sure
constexpr double kSpeedHalfS = 0.004;  // of the difference that gives the sign
constexpr double kMostDelayS = 0.012, kDelayStepS = 0.0005;
constexpr int kLeastWindows = 60;
constexpr std::size_t kUnknowns = 4;

using Row = std::array<double, kUnknowns>;

/// s^3 (1-s)^3 and its first two derivatives, s in 0..1.
struct Bump {
  double value, first, second;
};
Bump bump(double s) noexcept {
  const double r = 1.0 - s;
  return {s * s * s * r * r * r, 3.0 * s * s * r * r * (r - s), 6.0 * s * r * (r * r - 3.0 * s * r + s * s)};
}

/// Place between the samples.
double place_at(std::span<const MotionSample> record, std::size_t near, double t) noexcept {
  std::size_t i = near;
  while (i > 0 && record[i].t_s > t) --i;
  while (i + 2 < record.size() && record[i + 1].t_s < t) ++i;
  const double span = record[i + 1].t_s - record[i].t_s;
  const double share = span > 0 ? (t - record[i].t_s) / span : 0.0;
  return record[i].x_m + share * (record[i + 1].x_m - record[i].x_m);
}

/// A window's left side; the right side depends on the delay.
struct Window {
  Row row;
  double from_s, to_s;
  std::size_t first;  // sample at or before from_s
};

std::optional<Window> window_at(std::span<const MotionSample> record, std::size_t first) {
  const double t0 = record[first].t_s, t1 = t0 + kWindowS;
  if (t0 - kMostDelayS < record.front().t_s || t1 + kSpeedHalfS > record.back().t_s || t0 - kSpeedHalfS < record.front().t_s)
    return std::nullopt;
  Window out{{}, t0, t1, first};
  double sign = 0;
  const double middle = place_at(record, first, 0.5 * (t0 + t1));  // integrals of small numbers
  for (std::size_t i = first; i + 1 < record.size() && record[i].t_s < t1; ++i) {
    const double t = record[i].t_s, dt = std::min(record[i + 1].t_s, t1) - t;
    if (dt > 0.010) return std::nullopt;  // a gap in the record
    const double speed = (place_at(record, i, t + kSpeedHalfS) - place_at(record, i, t - kSpeedHalfS)) / (2.0 * kSpeedHalfS);
    const double way = speed > 0 ? 1.0 : -1.0;
    if (std::abs(speed) < kSlowestMS || (sign != 0 && way != sign)) return std::nullopt;
    sign = way;
    // The position is linear between two samples; the window is evaluated at the middle of the interval.
    const double tm = t + 0.5 * dt;
    const Bump phi = bump((tm - t0) / kWindowS);
    const double x = 0.5 * (record[i].x_m + place_at(record, i, t + dt)) - middle;
    out.row[0] += phi.second / (kWindowS * kWindowS) * x * dt;
    out.row[1] -= phi.first / kWindowS * x * dt;
    out.row[2] += phi.value * way * dt;
    out.row[3] += phi.value * dt;
  }
  return sign == 0 ? std::nullopt : std::optional(out);
}

/// The window's integral of the force that was commanded `delay` before.
double pushed(std::span<const MotionSample> record, const Window& window, double delay_s) noexcept {
  double sum = 0;
  std::size_t i = window.first;
  while (i > 0 && record[i].t_s + delay_s > window.from_s) --i;
  for (; i + 1 < record.size() && record[i].t_s + delay_s < window.to_s; ++i) {
    const double from = std::max(record[i].t_s + delay_s, window.from_s);
    const double to = std::min(record[i + 1].t_s + delay_s, window.to_s);
    if (to <= from) continue;
    // Simpson: the bump is smooth over a millisecond.
    const auto at = [&](double t) { return bump((t - window.from_s) / kWindowS).value; };
    sum += record[i].force_n * (to - from) / 6.0 * (at(from) + 4.0 * at(0.5 * (from + to)) + at(to));
  }
  return sum;
}

struct Solved {
  Row unknowns{};
  std::array<double, kUnknowns> variance{};
  double rest = 0;  // sum of squares left
};

std::optional<Solved> solve(const std::vector<Window>& windows, const std::vector<double>& right) {
  // Columns are scaled to one, so that a singular matrix has a small pivot.
  Row scale{};
  for (const Window& w : windows)
    for (std::size_t k = 0; k < kUnknowns; ++k) scale[k] += w.row[k] * w.row[k];
  for (double& s : scale) {
    if (!(s > 0)) return std::nullopt;
    s = std::sqrt(s);
  }
  std::array<std::array<double, 2 * kUnknowns>, kUnknowns> m{};  // normal matrix, and the unit matrix beside it
  Row v{};
  double square = 0;
  for (std::size_t n = 0; n < windows.size(); ++n) {
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      const double a = windows[n].row[i] / scale[i];
      v[i] += a * right[n];
      for (std::size_t j = 0; j < kUnknowns; ++j) m[i][j] += a * windows[n].row[j] / scale[j];
    }
    square += right[n] * right[n];
  }
  for (std::size_t i = 0; i < kUnknowns; ++i) m[i][kUnknowns + i] = 1.0;
  for (std::size_t p = 0; p < kUnknowns; ++p) {
    std::size_t best = p;
    for (std::size_t i = p + 1; i < kUnknowns; ++i)
      if (std::abs(m[i][p]) > std::abs(m[best][p])) best = i;
    std::swap(m[p], m[best]);
    if (!(std::abs(m[p][p]) > 1e-6)) return std::nullopt;
    const double by = m[p][p];
    for (double& x : m[p]) x /= by;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      if (i == p) continue;
      const double take = m[i][p];
      for (std::size_t j = 0; j < 2 * kUnknowns; ++j) m[i][j] -= take * m[p][j];
    }
  }
  Solved out;
  out.rest = square;
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    double x = 0;
    for (std::size_t j = 0; j < kUnknowns; ++j) x += m[i][kUnknowns + j] * v[j];
    out.unknowns[i] = x / scale[i];
    out.rest -= x * v[i];
  }
  out.rest = std::max(out.rest, 0.0);
  const double free = static_cast<double>(windows.size()) - static_cast<double>(kUnknowns);
  for (std::size_t i = 0; i < kUnknowns; ++i) out.variance[i] = m[i][kUnknowns + i] * out.rest / free / (scale[i] * scale[i]);
  return out;
}

}  // namespace

std::optional<MotionFit> fit_motion(std::span<const MotionSample> record) {
  if (record.size() < 100) return std::nullopt;
  std::vector<Window> windows;
  double next_s = record.front().t_s;
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (record[i].t_s < next_s) continue;
    next_s = record[i].t_s + kStrideS;
    if (const auto window = window_at(record, i)) windows.push_back(*window);
  }
  if (windows.size() < static_cast<std::size_t>(kLeastWindows)) return std::nullopt;

  std::vector<double> right(windows.size());
  const auto at = [&](double delay_s) {
    for (std::size_t n = 0; n < windows.size(); ++n) right[n] = pushed(record, windows[n], delay_s);
    return solve(windows, right);
  };
  double best_s = 0, least = 0;
  bool any = false;
  for (double delay = 0; delay <= kMostDelayS; delay += kDelayStepS) {
    const auto solved = at(delay);
    if (!solved || (any && solved->rest >= least)) continue;
    any = true;
    best_s = delay;
    least = solved->rest;
  }
  if (!any) return std::nullopt;
  // Near its least the rest is a parabola of the delay.
  double curve = 0;
  for (double step = kDelayStepS; step > 1e-5; step *= 0.5) {
    const double low_s = std::max(best_s - step, 0.0);
    const auto low = at(low_s), high = at(low_s + 2 * step), middle = at(low_s + step);
    if (!low || !high || !middle) return std::nullopt;
    const double bend = low->rest - 2.0 * middle->rest + high->rest;
    if (!(bend > 0)) break;
    curve = bend / (step * step);
    best_s = std::clamp(low_s + step + 0.5 * step * (low->rest - high->rest) / bend, low_s, low_s + 2 * step);
  }
  const auto solved = at(best_s);
  if (!solved || !(solved->unknowns[0] > 0)) return std::nullopt;
  MotionFit out;
  out.mass_kg = solved->unknowns[0];
  out.damping_ns_per_m = solved->unknowns[1];
  out.friction_n = solved->unknowns[2];
  out.weight_n = solved->unknowns[3];
  out.delay_ms = 1e3 * best_s;
  // Windows overlap fourfold: a quarter of them count.
  const double overlap = std::sqrt(kWindowS / kStrideS);
  out.damping_error = overlap * std::sqrt(solved->variance[1]);
  out.friction_error = overlap * std::sqrt(solved->variance[2]);
  const double sigma2 = solved->rest / static_cast<double>(windows.size());
  out.delay_error_ms = curve > 0 ? 1e3 * overlap * std::sqrt(2.0 * sigma2 / curve) : 0.0;
  out.windows = static_cast<int>(windows.size());
  return out;
}

}  // namespace cusp::device::falcon
