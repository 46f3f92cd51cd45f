/// The lines of an outline from a tooth's fissures. Frame: mesial along +x (scope.h). Millimetres.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenarios/teeth/landmarks.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Which fissures, and how much of them.
struct FissurePaths {
  std::vector<std::string> names;            // "lingual", or "central*" for all that begin so
  double most_x = 1e9, least_x = -1e9;       // what lies beyond is left out
  double longest_mm = 1e9;                   // from each one's first point
};

/// One polyline for each stretch of a fissure, straightened to kStraightMm; heights are 0. Empty where the tooth has none.
[[nodiscard]] std::vector<std::vector<Vec3>> fissure_paths(const ToothLandmarks& landmarks, const FissurePaths& wanted);
inline constexpr double kStraightMm = 0.08;

}  // namespace cusp::scenarios
