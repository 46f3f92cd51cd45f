/// How much goes in a tick: eq. (4) of the paper, per time (design, "Removal"). Pure functions, exact arithmetic.
#pragma once

#include <span>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// Wear coefficient alpha of eq. (4): distance over d_max = full_force / stiffness, at most 1.
/// Source: paper, eq. (4), read as a force set against a length.
inline double wear_coefficient(double distance_mm, double stiffness_n_per_mm, double full_force_n) noexcept {
  if (!(full_force_n > 0.0)) return 0.0;
  const double alpha = distance_mm * stiffness_n_per_mm / full_force_n;
  return alpha < 0.0 ? 0.0 : alpha > 1.0 ? 1.0 : alpha;
}

/// The head's part of a push. Neck and shank cut nothing; they take what leads into the walls that hold them.
struct HeadPush {
  Vec3 direction{0.0};  // unit; 0 if nothing is left
  double gap_mm = 0.0;  // how far it leads
  double share = 1.0;   // of the whole push
};
/// The nearest vector to `to_device` (from the pose, mm) that leads into no wall.
/// Pre: at most three normals of walls, unit, out of the tissue.
HeadPush push_of_head(Vec3 to_device, std::span<const Vec3> walls) noexcept;

/// A ring about the axis of a head that is no ball, and what it has of the head's area. For front_speed.
struct FrontRing {
  OnHalf at, normal;
  double area = 0.0;
};

/// Rings over the whole head, at most 24. Empty for a ball. Not for the haptic thread.
std::vector<FrontRing> front_rings(const Profile& head);

/// A bur that pushes on.
struct Front {
  const Bur& bur;
  std::span<const FrontRing> rings;  // front_rings(bur.head)
  Vec3 axis{0.0}, pose_mm{0.0};      // unit, and of the pivot
  Vec3 direction{0.0};               // of the push, unit
};

/// Speed at full wear of a bur: harmonic mean over the tissues that its front meets, weighted by what each point of the front
/// sweeps. 0 where the front meets tissue that cannot be cut. fallback: the speed when the front meets nothing yet. tick: the
/// points are turned from tick to tick (a ball's about its way, another head's about its axis), and each asks another eighth of a
/// voxel about it, for a tissue is known to its voxel only: where two tissues meet they then count by their shares (measured over
/// 78 seams: 1.6 % of the speed at most).
double front_speed(const Volume& volume, const Scene& scene, const Front& front, double fallback_mm_s, std::uint64_t tick) noexcept;

/// Sliding: how deep (mm) a bur that goes `slide` sideways while it wears `advance` into `direction` may stand, if nothing
/// recedes faster than it wears: the height over its lowest place of where its surface has turned so far that sliding asks
/// just that of it, sine = advance / slide (of a ball to the second order). Pre: both > 0.
double slide_depth(const Bur& bur, Vec3 axis, Vec3 direction, Vec3 slide_mm, double advance_mm) noexcept;

}  // namespace cusp::engine
