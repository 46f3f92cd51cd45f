/// How far a place is from a bur at a pose, and from all that its head passes on a straight way at a fixed axis.
/// Lengths in mm, axes unit, from the head towards the shank. Any thread; wait-free; only + - * / sqrt: the step uses it.
#pragma once

#include "engine/tool/bur.h"

namespace cusp::engine {

/// Ball about the pivot that holds the whole head.
inline double head_reach(const Bur& bur) noexcept { return bur.head.ball() ? bur.radius_mm : bur.head.reach(); }

/// Signed distance, negative inside, of a place `from_pivot` to the cutting head; its gradient is unit (where it is not
/// defined, on the axis or at a ball's centre, one of those that touch).
double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot) noexcept;
double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept;

/// From the pivot, the head's place furthest along a unit direction (of many, the one that Profile::support names).
Vec3 head_furthest(const Bur& bur, Vec3 axis, Vec3 direction) noexcept;

/// The same, but of a flat end or a straight flank that all lies furthest the place nearest to `near` (from the pivot).
Vec3 head_support(const Bur& bur, Vec3 axis, Vec3 direction, Vec3 near) noexcept;

/// Where the head, on its way, is nearest to a place.
struct Passing {
  double distance_mm = 0.0;
  double part = 0.0;    // of the way: 0 at its start, 1 at its end; of a stretch that is equally near, one of its points
  Vec3 gradient{0.0};   // unit
};

/// Largest error of Passing::distance_mm for a head that is no ball; a ball's is exact.
inline constexpr double kPassingErrorMm = 1e-7;

/// The head's pivot goes straight from a to b. Where the distance is surely above `enough_mm`, the answer may be any
/// bound between the two (part and gradient then say nothing).
Passing passing_head(const Bur& bur, Vec3 axis, Vec3 a, Vec3 b, Vec3 place, double enough_mm = 1e300) noexcept;

/// Signed distance of a place to neck and shank (exact outside, a bound from above inside), and its gradient.
double holder_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept;

/// A unit vector across `axis`, the same everywhere.
Vec3 across(Vec3 axis) noexcept;

}  // namespace cusp::engine
