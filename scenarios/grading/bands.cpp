#include "scenarios/grading/bands.h"

#include <cmath>

namespace cusp::scenarios {

namespace {

/// The share of the points at one edge of a band.
struct Edge {
  double at = 0, share = 0;
};

double between(double value, Edge a, Edge b) noexcept { return a.share + (b.share - a.share) * (value - a.at) / (b.at - a.at); }

}  // namespace

double share_of_points(const Bands& bands, double value) noexcept {
  if (!std::isfinite(value)) return 0.0;
  if (value >= bands.ideal_lo && value <= bands.ideal_hi) return 1.0;
  if (value < bands.ideal_lo) {
    if (value >= bands.acc_lo) return between(value, {bands.acc_lo, 0.5}, {bands.ideal_lo, 1.0});
    if (value > bands.fail_lo) return between(value, {bands.fail_lo, 0.0}, {bands.acc_lo, 0.5});
    return 0.0;
  }
  if (value <= bands.acc_hi) return between(value, {bands.ideal_hi, 1.0}, {bands.acc_hi, 0.5});
  if (value < bands.fail_hi) return between(value, {bands.acc_hi, 0.5}, {bands.fail_hi, 0.0});
  return 0.0;
}

std::string_view band_of(const Bands& bands, double value, double uncertainty, Possible possible) noexcept {
  const bool open_low = !(bands.fail_lo == bands.acc_lo && bands.acc_lo == bands.ideal_lo) || bands.ideal_lo > possible.least;
  const bool open_high = !(bands.fail_hi == bands.acc_hi && bands.acc_hi == bands.ideal_hi) || bands.ideal_hi < possible.most;
  const auto near = [&](double edge) { return std::fabs(value - edge) < uncertainty; };
  if (open_low && (near(bands.acc_lo) || near(bands.ideal_lo))) return "borderline";
  if (open_high && (near(bands.acc_hi) || near(bands.ideal_hi))) return "borderline";
  if (value >= bands.ideal_lo && value <= bands.ideal_hi) return "ideal";
  if (value >= bands.acc_lo && value <= bands.acc_hi) return "acceptable";
  return "fail";
}

}  // namespace cusp::scenarios
