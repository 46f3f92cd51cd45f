#include "ui/editor/band_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cusp::ui {
namespace {

constexpr double kPadding = 0.12;      // of the span, at each side
constexpr double kOpenPadding = 0.35;  // at a side whose natural end is far off: the band runs on
constexpr double kNearEnd = 3;         // spans: a natural end within stands on the scale
constexpr double kNearValue = 1;       // spans: a measured value within widens the scale
constexpr double kLeastSteps = 8;      // on a scale whose edges coincide
constexpr double kKeptDigits = 1e4;         // as the editor keeps numbers

double to_kept(double value) { return std::round(value * kKeptDigits) / kKeptDigits; }

}  // namespace

Bands with_edges(Bands bands, const std::function<double(double)>& change) {
  const bool ends_low = bands.fail_lo == bands.ideal_lo && bands.acc_lo == bands.ideal_lo;
  const bool ends_high = bands.fail_hi == bands.ideal_hi && bands.acc_hi == bands.ideal_hi;
  for (std::size_t i = 0; i < kBandEdges.size(); ++i) {
    double& edge = bands.*kBandEdges[i];
    if (!(i < 3 ? ends_low : ends_high)) edge = to_kept(change(edge));
  }
  return bands;
}

double band_step(std::string_view unit) noexcept {
  if (unit == "mm" || unit == "mm3") return 0.05;
  if (unit == "N" || unit == "K") return 0.1;
  if (unit == "%" || unit == "deg") return 0.5;
  return 1;
}

double band_end(std::string_view unit) noexcept { return unit == "s" ? 86400.0 : 1000.0; }

BandScale::BandScale(const Bands& bands, BandRange possible, double step, std::span<const double> values)
    : bands_(bands),
      possible_(possible),
      step_(step),
      low_{bands.fail_lo, bands.fail_lo == bands.ideal_lo},
      high_{bands.fail_hi, bands.fail_hi == bands.ideal_hi} {
  choose_range(values);
}

void BandScale::choose_range(std::span<const double> values) {
  const double from = low_.upright && !high_.upright ? bands_.ideal_hi : low_.end;
  const double to = high_.upright && !low_.upright ? bands_.ideal_lo : high_.end;
  BandRange core{from, to};
  const double span = std::max(core.most - core.least, kLeastSteps * step_);
  double before = kPadding * span, after = before;
  if (low_.upright && !high_.upright) {
    const bool near = core.least - low_.end <= kNearEnd * span;
    if (near) core.least = low_.end;
    before = near ? before : kOpenPadding * span;
  }
  if (high_.upright && !low_.upright) {
    const bool near = high_.end - core.most <= kNearEnd * span;
    if (near) core.most = high_.end;
    after = near ? after : kOpenPadding * span;
  }
  for (const double value : values) {
    if (value < core.least - kNearValue * span || value > core.most + kNearValue * span) continue;
    core.least = std::min(core.least, value);
    core.most = std::max(core.most, value);
  }
  const double short_of = std::max(kLeastSteps * step_ - (core.most - core.least), 0.0) / 2;
  shown_.least = std::max(core.least - before - short_of, std::min(possible_.least, core.least));
  shown_.most = std::min(core.most + after + short_of, std::max(possible_.most, core.most));
  if (!(shown_.most > shown_.least)) shown_.most = shown_.least + step_;
}

BandScale BandScale::holding(const Bands& bands) const {
  BandScale out(bands, possible_, step_);
  out.shown_ = shown_;
  return out;
}

double BandScale::x_of(double value, const BandPlot& plot) const {
  const double share = (value - shown_.least) / (shown_.most - shown_.least);
  return plot.left + std::clamp(share, 0.0, 1.0) * plot.width;
}

double BandScale::value_at(double x, const BandPlot& plot) const {
  const double share = std::clamp((x - plot.left) / plot.width, 0.0, 1.0);
  return shown_.least + share * (shown_.most - shown_.least);
}

BandSpot BandScale::spot_of(std::size_t edge, const BandPlot& plot) const {
  return {x_of(bands_.*kBandEdges[edge], plot), plot.top + (1 - kBandEdgeShares[edge]) * plot.height};
}

bool BandScale::movable(std::size_t edge) const {
  const Side& side = edge < kBandEdges.size() / 2 ? low_ : high_;
  if (side.upright && (side.end <= possible_.least || side.end >= possible_.most)) return false;
  const double value = bands_.*kBandEdges[edge];
  return value >= shown_.least && value <= shown_.most;
}

std::optional<std::size_t> BandScale::edge_at(BandSpot at, const BandPlot& plot, double reach_px) const {
  std::optional<std::size_t> found;
  double nearest = reach_px;
  for (std::size_t edge = 0; edge < kBandEdges.size(); ++edge) {
    if (!movable(edge)) continue;
    const BandSpot spot = spot_of(edge, plot);
    const double apart = std::hypot(spot.x - at.x, spot.y - at.y);
    if (apart > nearest) continue;
    nearest = apart;
    found = edge;
  }
  return found;
}

BandRange BandScale::limits(std::size_t edge) const {
  const double below = edge == 0 ? possible_.least : bands_.*kBandEdges[edge - 1];
  const double above = edge + 1 == kBandEdges.size() ? possible_.most : bands_.*kBandEdges[edge + 1];
  const double own = bands_.*kBandEdges[edge];  // an author's number may lie beyond what is possible
  return {std::min(below, own), std::max(above, own)};
}

Bands BandScale::moved(std::size_t edge, double wanted, double step) const {
  const BandRange within = limits(edge);
  Bands out = bands_;
  out.*kBandEdges[edge] = std::clamp(to_kept(std::round(wanted / step) * step), within.least, within.most);
  return out;
}

std::vector<double> BandScale::ticks() const {
  const double rough = (shown_.most - shown_.least) / 5;
  const double ten = std::pow(10.0, std::floor(std::log10(rough)));
  double apart = 10 * ten;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * ten >= rough) apart = factor * ten;
  std::vector<double> out;
  const auto first = static_cast<long>(std::ceil(shown_.least / apart - 1e-9)), last = static_cast<long>(std::floor(shown_.most / apart + 1e-9));
  for (long i = first; i <= last; ++i) out.push_back(static_cast<double>(i) * apart);
  return out;
}

}  // namespace cusp::ui
