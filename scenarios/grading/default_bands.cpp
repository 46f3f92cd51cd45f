#include "scenarios/grading/default_bands.h"

#include <array>

namespace cusp::scenarios {

namespace {

constexpr double kNoEdgeMm = 100.0;  // beyond any tooth

constexpr Bands kClearance{0, 0.25, 0.5, 1, 2, 3};

struct DefaultRow {
  std::string_view metric;
  Bands bands;
};

/// Row set A has walls of 85 to 93 degrees excellent, 90 upright: -5 to 3 of divergence. Mesial and distal walls may
/// diverge as much as the others may converge [M]. Opposite walls: the sums. Row set A has flatness below 0.12 excellent
/// and below 0.25 acceptable; row set B an isthmus of 0.8 to 1.2 mm. 72 % of the target within 200 µm passed (Sadid-Zadeh 2019).
/// Row set A has an axial height of 1.0 to 1.5 excellent and 0.8 to 2.0 acceptable; row set B a clearance of 0.5 mm and 90 degrees
/// at the margin; dentistry.md an axial wall 0.2 to 0.5 mm past the junction and a gingival floor of 1.0 to 1.5 mm. Unsupported
/// enamel is known to 1 or 2 mm3. Every other edge, the tilt and the caries: [M].
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
    DefaultRow{"surface_within_200", {50, 72, 90, 100, 100, 100}},
    DefaultRow{"surface_within_300", {50, 72, 90, 100, 100, 100}},
    DefaultRow{"surface_within_400", {50, 72, 90, 100, 100, 100}},
    DefaultRow{"gingival_above_cej", {0, 0.5, 1, kNoEdgeMm, kNoEdgeMm, kNoEdgeMm}},
    DefaultRow{"box_height", {0.6, 0.8, 1, 1.5, 2, 2.2}},
    DefaultRow{"axial_past_junction_least", {0, 0.1, 0.2, kNoEdgeMm, kNoEdgeMm, kNoEdgeMm}},
    DefaultRow{"axial_past_junction_mean", {0, 0.1, 0.2, 0.5, 1.5, 2.5}},
    DefaultRow{"axial_past_junction_most", {-kNoEdgeMm, -kNoEdgeMm, -kNoEdgeMm, 0.5, 1.5, 2.5}},
    DefaultRow{"cavosurface_angle", {70, 80, 85, 100, 110, 120}},
    DefaultRow{"cavosurface_off", {0, 0, 0, 10, 25, 50}},
    DefaultRow{"unsupported_enamel", {0, 0, 0, 2, 4, 8}},
    DefaultRow{"contact_broken", {0, 0.5, 1, 1, 1, 1}},
    DefaultRow{"clearance_buccal_gingival", kClearance},
    DefaultRow{"clearance_buccal_middle", kClearance},
    DefaultRow{"clearance_buccal_occlusal", kClearance},
    DefaultRow{"clearance_lingual_gingival", kClearance},
    DefaultRow{"clearance_lingual_middle", kClearance},
    DefaultRow{"clearance_lingual_occlusal", kClearance},
    DefaultRow{"clearance_gingival", kClearance},
    DefaultRow{"gingival_floor_mesiodistal", {0.6, 0.8, 1, 1.5, 2, 2.5}},
    DefaultRow{"caries_left_periphery", {0, 0, 0, 0.05, 0.3, 1}},
    DefaultRow{"caries_left_pulp", {0, 0, 0, 0.05, 0.3, 1}},
    DefaultRow{"caries_left_enamel", {0, 0, 0, 0.05, 0.3, 1}},
    DefaultRow{"sound_lost", {0, 0, 0, 0.5, 2, 5}},
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
