/// Peaks, pits, valleys and crests of a biting surface near where they are expected. Inside of this folder.
#pragma once

#include <optional>
#include <vector>

#include "scenarios/landmarks/tooth_surface.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Highest places, or lowest.
enum class Looks : std::uint8_t { for_high, for_low };

/// Climbs (or descends) from a place to where nothing about it is higher (lower); nullopt where that lies beyond `reach_mm`, or does not
/// stand out of what is about it.
[[nodiscard]] std::optional<Vec3> extreme_near(const ToothSurface& tooth, Vec2 start_mm, double reach_mm, Looks looks);

/// A line beside `expected`, within `reach_mm` of it, along the bottom of a valley (or a crest): the sum of its heights and of its
/// turns is the least. Places where the surface falls (rises) to one side only are no part of it. Empty where less than half of it is one.
[[nodiscard]] std::vector<Vec3> line_near(const ToothSurface& tooth, const std::vector<Vec2>& expected, double reach_mm, Looks looks);

}  // namespace cusp::scenarios
