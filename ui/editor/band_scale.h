/// The bands of a criterion on a scale: value to place, which edge is under the pointer, how far an edge may go. No widget.
/// Units: values in the criterion's, places in px, y down. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

/// The edges from left to right, and the share of the points at each.
inline constexpr std::array kBandEdges = {&Bands::fail_lo,  &Bands::acc_lo, &Bands::ideal_lo,
                                          &Bands::ideal_hi, &Bands::acc_hi, &Bands::fail_hi};
inline constexpr std::array kBandEdgeShares = {0.0, 0.5, 1.0, 1.0, 0.5, 0.0};

/// Each edge changed, rounded to 0.0001. A side whose three edges coincide is a natural end and stays.
[[nodiscard]] Bands with_edges(Bands bands, const std::function<double(double)>& change);

/// What an edge is snapped to: 0.05 mm as the handles on the tooth [M].
[[nodiscard]] double band_step(std::string_view unit) noexcept;
/// Beyond what an attempt reaches: a day, of any other unit 1000.
[[nodiscard]] double band_end(std::string_view unit) noexcept;
inline constexpr double kFineBandStep = 0.2;  // of band_step(), with Shift: 0.01 mm

struct BandSpot {
  double x = 0, y = 0;
};
/// Where the curve of shares is drawn: full points at the top, none at the bottom.
struct BandPlot {
  double left = 0, top = 0, width = 1, height = 1;
};
struct BandRange {
  double least = 0, most = 0;
};

class BandScale {
 public:
  /// `possible`: what the metric can be. `values`: measured ones, shown too unless they lie far off. Pre: all finite, bands ordered.
  BandScale(const Bands& bands, BandRange possible, double step, std::span<const double> values = {});

  /// Other bands on the same scale: it stands still under a drag.
  [[nodiscard]] BandScale holding(const Bands& bands) const;
  const Bands& bands() const { return bands_; }
  BandRange shown() const { return shown_; }
  double x_of(double value, const BandPlot& plot) const;  // clamped to the plot
  double value_at(double x, const BandPlot& plot) const;  // clamped to the scale
  BandSpot spot_of(std::size_t edge, const BandPlot& plot) const;
  /// False for the edges of a natural end (0 mm3, 100 %) and for those off the scale: the numbers change them.
  bool movable(std::size_t edge) const;
  /// The movable edge nearest to `at`, within `reach_px`.
  std::optional<std::size_t> edge_at(BandSpot at, const BandPlot& plot, double reach_px) const;
  /// Between its neighbours and within what is possible, so that the bands stay ordered.
  BandRange limits(std::size_t edge) const;
  /// The bands with that edge at `wanted`, snapped to `step` and kept within its limits.
  Bands moved(std::size_t edge, double wanted, double step) const;
  /// Round values for the figures of the scale, four to seven.
  std::vector<double> ticks() const;

 private:
  struct Side {
    double end = 0;        // of the three edges, the one farthest out
    bool upright = false;  // they coincide
  };
  void choose_range(std::span<const double> values);
  Bands bands_;
  BandRange possible_, shown_;
  double step_;
  Side low_, high_;
};

}  // namespace cusp::ui
