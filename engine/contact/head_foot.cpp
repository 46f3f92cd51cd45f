#include "engine/contact/head_foot.h"

namespace cusp::engine {

HeadFoot foot_beside(const Bur& bur, Vec3 axis, Vec3 normal, Vec3 point_from_pivot, ByHead& point, double reach,
                     const HeadFoot& deepest) noexcept {
  reckon(bur, point);
  const OnHalf at = point.at, gradient = point.gradient;
  const OnHalf near{at.t - point.distance * gradient.t, at.rho - point.distance * gradient.rho};
  HeadFoot foot = deepest;
  if (std::fabs(gradient.t) < std::fabs(gradient.rho)) {
    // A flank: on the side that the surface faces.
    foot.at = axis * near.t + deepest.aside * near.rho;
    const Vec3 beside = foot.at - point_from_pivot;
    const double over = glm::dot(normal, beside);
    if (glm::dot(beside, beside) - over * over <= reach * reach) {
      foot.normal = -(axis * gradient.t + deepest.aside * gradient.rho);
      return foot;
    }
  }
  const Vec3 aside = aside_of(point, axis);
  foot.at = axis * near.t + aside * near.rho;
  foot.normal = -(axis * gradient.t + aside * gradient.rho);
  // A rim close by that stands deeper has many normals: the surface's own, but for what of it runs along the rim.
  OnHalf rim;
  if (!bur.head.rim(near, reach, rim)) return foot;
  const Vec3 of_rim = axis * rim.t + aside * rim.rho;
  const Vec3 along = glm::cross(axis, aside);
  const Vec3 facing = normal - along * glm::dot(normal, along);
  const double length = length_of(facing);
  if (length < kFacing || glm::dot(normal, of_rim) > glm::dot(normal, foot.at)) return foot;
  foot.at = of_rim;
  foot.normal = facing / length;
  return foot;
}

}  // namespace cusp::engine
