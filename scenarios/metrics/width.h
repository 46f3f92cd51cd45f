/// Width of a preparation. Source: dentistry.md, group "width"; dental.md 2.2 ("isthmus", row sets A and B).
///
/// isthmus_width (mm): least level distance across the void between a buccal and a lingual margin of the occlusal cavosurface, at right
/// angles to the margin. Without a tooth's number: between any two of its margins that face each other.
/// Needs: a target, a banded volume, a margin on the occlusal surface.
#pragma once

#include <optional>
#include <vector>

#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"

namespace cusp::scenarios {

struct Isthmus {
  double width_mm = 0;
  double uncertainty_mm = 0;  // 95 %: two places
  Vec3 from_mm{0.0}, to_mm{0.0};
};

/// nullopt where no margin of the occlusal surface faces another.
[[nodiscard]] std::optional<Isthmus> isthmus(const std::vector<MarginPoint>& margin, const Reference& reference);

}  // namespace cusp::scenarios
