/// Where a head that is no ball stands on a surface. From the pivot, mm; axis unit, from the head towards the shank. Any thread;
/// wait-free.
#pragma once

#include <cmath>

#include "engine/tool/swept.h"

namespace cusp::engine {

/// cos 26 deg: a head's side that turns further from a surface does not lie on it.
inline constexpr double kFacing = 0.9;

struct HeadFoot {
  Vec3 at{0.0}, normal{0.0};  // the place, and the direction that holds the head off there
  bool deepest = true;  // no place of the head stands deeper over the surface's plane
  double over = 0.0;    // mm: how high the deepest one stands over it
  Vec3 aside{0.0};      // unit, across the axis: where the deepest one is
};

/// From the axis to a point, unit.
inline Vec3 aside_of(const ByHead& point, Vec3 axis) noexcept { return point.at.rho > 0.0 ? point.off / point.at.rho : across(axis); }

/// The head's place that stands deepest over the plane of a point of a surface. `deepest` if the plane is to be believed there:
/// within `reach` of the point.
inline HeadFoot deepest_foot(const Bur& bur, Vec3 axis, Vec3 normal, Vec3 point_from_pivot, const ByHead& point, double reach) noexcept {
  HeadFoot foot;
  foot.normal = normal;
  OnHalf down{-glm::dot(normal, axis), 0.0};  // into the surface, by the axis
  const Vec3 sideways = -normal - axis * down.t;
  down.rho = length_of(sideways);
  foot.aside = down.rho > 1e-9 ? sideways / down.rho : aside_of(point, axis);
  const OnHalf deepest = bur.head.support(down, point.at);
  foot.at = axis * deepest.t + foot.aside * deepest.rho;
  const Vec3 d = foot.at - point_from_pivot;
  foot.over = glm::dot(normal, d);
  foot.deepest = glm::dot(d, d) - foot.over * foot.over <= reach * reach;
  return foot;
}

/// Where that one is not: the head's place at the height along the axis where it is nearest to the point: a flank, or an end, that
/// all but lies on the surface, which bends away from the plane before the flank ends; there the head's own normal holds it off.
HeadFoot foot_beside(const Bur& bur, Vec3 axis, Vec3 normal, Vec3 point_from_pivot, ByHead& point, double reach,
                     const HeadFoot& deepest) noexcept;

/// deepest_foot(), or foot_beside() where that one is not.
inline HeadFoot head_foot(const Bur& bur, Vec3 axis, Vec3 normal, Vec3 point_from_pivot, ByHead& point, double reach) noexcept {
  const HeadFoot foot = deepest_foot(bur, axis, normal, point_from_pivot, point, reach);
  return foot.deepest ? foot : foot_beside(bur, axis, normal, point_from_pivot, point, reach, foot);
}

}  // namespace cusp::engine
