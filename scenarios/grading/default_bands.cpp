#include "scenarios/grading/default_bands.h"

#include <array>

namespace cusp::scenarios {

namespace {

constexpr double kNoEdgeMm = 100.0;  // beyond any tooth

struct DefaultRow {
  std::string_view metric;
  Bands bands;
};

/// Row set A has walls of 85 to 93 degrees excellent, 90 upright: -5 to 3 of divergence. Mesial and distal walls may
/// diverge as much as the others may converge [M]. Opposite walls: the sums. Row set A has flatness below 0.12 excellent
/// and below 0.25 acceptable; row set B an isthmus of 0.8 to 1.2 mm. Every other edge, and the tilt: [M].
constexpr std::array kRows = {
    DefaultRow{"wall_angle_buccal", {-12, -8, -5, 3, 5, 8}},
    DefaultRow{"wall_angle_lingual", {-12, -8, -5, 3, 5, 8}},
    DefaultRow{"wall_angle_mesial", {-8, -5, -3, 5, 8, 12}},
    DefaultRow{"wall_angle_distal", {-8, -5, -3, 5, 8, 12}},
    DefaultRow{"convergence_buccolingual", {-16, -10, -6, 10, 16, 24}},
    DefaultRow{"convergence_mesiodistal", {-24, -16, -10, 6, 10, 16}},
    DefaultRow{"floor_flatness", {0, 0, 0, 0.12, 0.25, 0.4}},
    DefaultRow{"floor_tilt", {0, 0, 0, 3, 6, 10}},
    DefaultRow{"isthmus_width", {0.5, 0.7, 0.8, 1.2, 1.5, 2}},
};

/// Class I: at least 2.0 mm on a molar [M], 1.6 on a premolar; row set A has 1.2 to 1.6 acceptable.
constexpr Bands kMolarRidge{1.2, 1.6, 2.0, kNoEdgeMm, kNoEdgeMm, kNoEdgeMm};
constexpr Bands kPremolarRidge{0.8, 1.2, 1.6, kNoEdgeMm, kNoEdgeMm, kNoEdgeMm};

}  // namespace

std::optional<Bands> default_bands(std::string_view metric, int fdi) noexcept {
  if (metric.starts_with("ridge_")) return fdi % 10 >= 6 ? kMolarRidge : kPremolarRidge;
  for (const DefaultRow& row : kRows)
    if (row.metric == metric) return row.bands;
  return std::nullopt;
}

}  // namespace cusp::scenarios
