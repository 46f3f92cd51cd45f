/// Form of the pulpal floor. Source: dental.md 2.2, row set A ("floor flatness", its unit unstated there; taken as RMS).
///
/// floor_flatness (mm): RMS distance of the floor from its own best plane, over its area.
/// floor_tilt (deg): angle between that plane and the level across the axis.
/// Needs: a target, a banded volume, a floor that a bur left.
#pragma once

#include <optional>

#include "scenarios/metrics/cut_faces.h"

namespace cusp::scenarios {

struct FloorForm {
  double flatness_mm = 0;
  double flatness_uncertainty_mm = 0;  // 95 %
  Vec3 furthest_at_mm{0.0};            // of the floor, from the plane
  std::optional<double> tilt_deg;      // nullopt: the floor is too narrow for a plane
  double tilt_uncertainty_deg = 0;     // 95 %: sqrt(2) * point_sigma across the floor's least width
  Vec3 lowest_at_mm{0.0};
};

/// nullopt where no floor was cut.
[[nodiscard]] std::optional<FloorForm> floor_form(const CutFaces& faces, double point_sigma_mm);

}  // namespace cusp::scenarios
