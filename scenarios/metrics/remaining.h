/// What is left of the tooth beside a preparation. Source: dental.md 2.2, row set A and class I ("marginal ridge").
///
/// ridge_mesial, ridge_distal (mm): least mesiodistal distance from the wall to the tooth's greatest proximal contour at
/// the same buccolingual place, as a calliper held across the marginal ridge measures it. A wall that converges occlusally is
/// outermost at its foot. A scratch on the ridge is no wall. A ridge that is cut through has 0.
/// Needs: a tooth whose sides are known and whose neighbours are of other tissues, a banded volume, a cut towards that side, a
/// target that leaves that ridge.
#pragma once

#include <optional>

#include "scenarios/metrics/cut_faces.h"

namespace cusp::scenarios {

/// Thinner than any marginal ridge that is to stay, mm [M].
inline constexpr double kRidgeMm = 1.0;
/// No wall is lower, mm: a bur that grazes the slope beside a cavity leaves about 0.05 [M].
inline constexpr double kLeastWallMm = 0.2;

struct RidgeThickness {
  double mm = 0;
  double uncertainty_mm = 0;  // 95 %: two places; half a voxel where a neighbour touches, for its border is known so
  Vec3 wall_at_mm{0.0}, contour_at_mm{0.0};
};

/// Pre: `wall` is mesial_wall or distal_wall. nullopt where that wall was not cut, and where a proximal box of the target opens
/// that side: it holds some of the tooth's outer surface within kRidgeMm of the greatest contour.
[[nodiscard]] std::optional<RidgeThickness> ridge_thickness(const CutFaces& faces, const Reference& reference,
                                                            const Volume& volume, FaceName wall);

}  // namespace cusp::scenarios
