/// The margin: where the cut surface meets the tooth's original surface. Source: dentistry.md, group "margin"; dental.md 2.2, row
/// set B (class V: 90° cavosurface; inlay 100 to 120°).
///
/// cavosurface_angle (deg): angle of the tooth that is left, between chords of 0.3 mm along the cut and along the original surface,
/// at right angles to the margin; mean over the margin's length.
/// cavosurface_off (%): share of the margin where it is below 80 or above 110 degrees [M].
/// Needs: a banded volume whose voxels are at most half a chord, a margin on the exercise's own hard tissue.
#pragma once

#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

inline constexpr double kChordMm = 0.3;
inline constexpr double kLeastCavosurfaceDeg = 80.0, kMostCavosurfaceDeg = 110.0;

/// A place of the margin: one in each cell of voxels that it passes.
struct MarginPoint {
  Vec3 at_mm{0.0};
  Vec3 out{0.0};        // normal of the original surface
  Vec3 into_void{0.0};  // normal of the cut surface
  double weight = 0;    // length of the margin in its cell, voxels
  std::optional<double> angle_deg;  // none at a line angle, and where a chord has no room
};

/// In the order of the bricks. Tens of milliseconds. Empty for a filled reading. Voxels above half a chord leave every place
/// without an angle.
[[nodiscard]] std::vector<MarginPoint> margin_points(const Volume& volume);

struct Cavosurface {
  double mean_deg = 0, mean_uncertainty_deg = 0;
  double off_share = 0, off_uncertainty = 0;  // 0 to 1; 95 %: what lies near an edge of the band, and what has no angle
  Vec3 worst_at_mm{0.0};
};
/// nullopt where no place has an angle.
[[nodiscard]] std::optional<Cavosurface> cavosurface(const std::vector<MarginPoint>& margin, double point_sigma_mm);

void add_margin(const std::vector<MarginPoint>& margin, const Reference& reference, std::vector<Measure>& out);

}  // namespace cusp::scenarios
