/// Width of a preparation. Source: dental.md 2.2 ("isthmus", row sets A and B).
///
/// isthmus_width (mm): least horizontal distance between two walls that face each other, above the rounded line angle.
/// Needs: a target, a banded volume, walls.
#pragma once

#include <optional>

#include "scenarios/metrics/cut_faces.h"

namespace cusp::scenarios {

struct Isthmus {
  double width_mm = 0;
  double uncertainty_mm = 0;  // 95 %: two places
  Vec3 from_mm{0.0}, to_mm{0.0};
};

/// From each wall straight into the void, level, until tissue stands against it. nullopt where nothing does.
[[nodiscard]] std::optional<Isthmus> isthmus(const CutFaces& faces, const Volume& volume, double point_sigma_mm);

}  // namespace cusp::scenarios
