/// How much goes in a tick: eq. (4) of the paper, per time (design, "Removal"). Pure functions, exact arithmetic.
#pragma once

#include "engine/step/scene.h"
#include "engine/volume/volume.h"

namespace cusp {

/// Wear coefficient alpha of eq. (4): distance over d_max = full_force / stiffness, at most 1.
/// Source: paper, eq. (4), read as a force set against a length.
inline double wear_coefficient(double distance_mm, double stiffness_n_per_mm, double full_force_n) noexcept {
  if (!(full_force_n > 0.0)) return 0.0;
  const double alpha = distance_mm * stiffness_n_per_mm / full_force_n;
  return alpha < 0.0 ? 0.0 : alpha > 1.0 ? 1.0 : alpha;
}

/// Density of eq. (6) for a removal velocity: (updates per second / voxels per mm) / velocity. 40 updates a second.
inline double density_for(double velocity_mm_s, double voxel_mm) noexcept { return 40.0 * voxel_mm / velocity_mm_s; }

/// Speed at full wear of a ball that pushes towards `direction` (unit): harmonic mean over the tissues that its front
/// meets, weighted by what each point of the front sweeps. 0 where the front meets tissue that cannot be cut.
/// fallback: the speed when the front meets nothing yet.
double front_speed(const Volume& volume, const Scene& scene, Vec3 pose_mm, double radius_mm, Vec3 direction,
                   double fallback_mm_s) noexcept;

}  // namespace cusp
