/// Teeth beside one another: where a neighbour stands so that the two touch at their contacts, and a whole jaw.
/// Frame: that of the first tooth's table (quadrants 1 and 3). Any thread.
#pragma once

#include <memory>
#include <vector>

#include "scenarios/teeth/tooth_body.h"

namespace cusp::scenarios {

/// Gap that a neighbour is placed at: touching, as far as a surface can be known.
inline constexpr double kContactGapMm = 0.01;

struct Standing {
  int fdi = 0;
  std::shared_ptr<const ToothShape> shape;
  ToothPlace place;
  Vec3 contact_mm{0.0};  // where it touches the tooth before it in the row
  double gap_mm = 0.0;   // there
};

enum class Proximal : std::uint8_t { mesial, distal };

/// FDI number of the tooth on that side; 0 behind a third molar.
int neighbour_fdi(int fdi, Proximal side) noexcept;

/// A seed for a tooth of the mouth that `seed` grows; 0 stays the average.
std::uint64_t seed_in_mouth(std::uint64_t seed, int fdi) noexcept;

/// The fields of a tooth of that mouth. Pre: fdi is a tooth's.
std::shared_ptr<const ToothShape> shape_in_mouth(int fdi, std::uint64_t mouth_seed, double voxel_mm);

/// The neighbour of a placed tooth: turned along the arch, its contact on the tooth's.
/// Pre: neighbour_fdi(before.fdi, side) != 0.
Standing stand_beside(const Standing& before, Proximal side, std::shared_ptr<const ToothShape> shape);

/// Nearest two bodies come along `way` (unit, from a towards b, horizontal) about a place: the gap, negative where they
/// overlap, and the middle of it.
struct Gap {
  double mm = 0.0;
  Vec3 at_mm{0.0};
};
Gap gap_between(const ToothBody& a, const ToothBody& b, Vec3 way, Vec3 about_mm);

}  // namespace cusp::scenarios
