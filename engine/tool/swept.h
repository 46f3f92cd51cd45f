/// Distance of a place to a bur at a pose, and to the solid that its head sweeps along a straight line.
/// Lengths in mm, axes unit, from the head towards the shank. Any thread; wait-free. Only + - * / sqrt: the step uses it.
#pragma once

#include <cmath>

#include "engine/tool/bur.h"

namespace cusp::engine {

/// Radius of the ball about the pivot that contains the head.
inline double head_reach(const Bur& bur) noexcept { return bur.head.ball() ? bur.radius_mm : bur.head.reach(); }

/// Signed distance, negative inside, of a place `from_pivot` to the cutting head. The gradient is unit; on the axis and
/// at a ball's centre, where it is not defined, it is one of the limits.
double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot) noexcept;
double head_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept;

/// A place by a head that is no ball: in the half plane that holds it; and the head's distance and gradient there, once asked for.
struct ByHead {
  OnHalf at;
  Vec3 off{0.0};  // from the axis; at.rho long
  double distance = 0.0;
  OnHalf gradient;
  bool reckoned = false;  // distance and gradient
};
inline ByHead by_axis(Vec3 axis, Vec3 from_pivot) noexcept {
  ByHead out;
  out.at.t = glm::dot(from_pivot, axis);
  out.off = from_pivot - axis * out.at.t;
  out.at.rho = std::sqrt(glm::dot(out.off, out.off));
  return out;
}
inline void reckon(const Bur& bur, ByHead& place) noexcept {
  if (place.reckoned) return;
  place.distance = bur.head.distance(place.at, place.gradient);
  place.reckoned = true;
}
/// Of a place's distance, as head_distance() gives it. Pre: reckoned.
Vec3 gradient_in_space(const ByHead& place, Vec3 axis) noexcept;

/// From the pivot: the head's place furthest along a unit direction, by Profile::support().
Vec3 head_furthest(const Bur& bur, Vec3 axis, Vec3 direction) noexcept;

/// The same; if a whole flat end or straight flank is furthest, its place nearest to `near` (from the pivot).
Vec3 head_support(const Bur& bur, Vec3 axis, Vec3 direction, Vec3 near) noexcept;

/// The position of the moving head that is nearest to a place.
struct Passing {
  double distance_mm = 0.0;
  double part = 0.0;    // of the way: 0 at its start, 1 at its end; of a stretch that is equally near, any point
  Vec3 gradient{0.0};   // unit
};

/// Largest error of Passing::distance_mm for a head that is no ball; a ball's is exact.
inline constexpr double kPassingErrorMm = 1e-7;

/// The head's pivot goes straight from a to b. If the distance exceeds `enough_mm`, distance_mm may be any value
/// between the two; part and gradient are then undefined.
Passing passing_head(const Bur& bur, Vec3 axis, Vec3 a, Vec3 b, Vec3 place, double enough_mm = 1e300) noexcept;

/// Signed distance of a place to neck and shank (exact outside, a bound from above inside), and its gradient.
double holder_distance(const Bur& bur, Vec3 axis, Vec3 from_pivot, Vec3& gradient) noexcept;

/// A unit vector across `axis`, the same everywhere.
Vec3 across(Vec3 axis) noexcept;

}  // namespace cusp::engine
