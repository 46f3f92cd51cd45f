/// Walls of a preparation against its axis. Source: dental.md 2.2, row set A ("wall angle").
///
/// wall_angle_<side> (deg): angle between the wall and the axis of insertion, over the wall's area; positive where the
/// wall diverges occlusally. convergence_<direction> (deg): how much two opposite walls approach each other occlusally,
/// the negative sum of their angles; negative where they diverge.
/// Needs: a tooth whose sides are known, a banded volume, walls above the rounded line angle.
#pragma once

#include <optional>

#include "scenarios/metrics/cut_faces.h"

namespace cusp::scenarios {

struct WallAngle {
  double deg = 0;
  double uncertainty_deg = 0;  // 95 %
  Vec3 at_mm{0.0};             // on the wall, nearest to its middle
};

/// The angle's rise is the sum of the area vectors' parts along the axis, in which a wall's roughness cancels; its run is
/// the sum of their level lengths, so that a wall that bends round a corner counts whole. The uncertainty is that of two
/// places, one at either edge: sqrt(2) * point_sigma / height. nullopt where that is above kLeastCertainDeg, or no such
/// wall was cut.
[[nodiscard]] std::optional<WallAngle> wall_angle(const CutFaces& faces, FaceName wall, double point_sigma_mm);

/// An angle that is known no better is not measurable.
inline constexpr double kLeastCertainDeg = 5.0;

}  // namespace cusp::scenarios
