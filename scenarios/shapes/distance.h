/// Signed distances of plain shapes, negative inside, in mm. Exact unless stated otherwise. Any thread.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/vec.h"

namespace cusp::scenarios {

using Vec2 = glm::dvec2;

inline double ball_distance(Vec3 p, Vec3 centre, double radius) noexcept { return glm::length(p - centre) - radius; }

/// Nearest place of the segment a-b, as a fraction in [0, 1]; 0 for a segment without length.
inline double nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) noexcept {
  const Vec2 ab = b - a;
  const double square = glm::dot(ab, ab);
  return square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
}
inline double segment_distance(Vec2 p, Vec2 a, Vec2 b) noexcept {
  return glm::length(p - (a + nearest_on_segment(p, a, b) * (b - a)));
}
inline double capsule_distance(Vec3 p, Vec3 a, Vec3 b, double radius) noexcept {
  const Vec3 ab = b - a;
  const double square = glm::dot(ab, ab);
  const double t = square > 0.0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + t * ab)) - radius;
}
inline double rectangle_distance(Vec2 p, Vec2 centre, Vec2 half_size) noexcept {
  const Vec2 q = glm::abs(p - centre) - half_size;
  return glm::length(glm::max(q, Vec2(0.0))) + std::min(std::max(q.x, q.y), 0.0);
}
inline double box_distance(Vec3 p, Vec3 centre, Vec3 half_size) noexcept {
  const Vec3 q = glm::abs(p - centre) - half_size;
  return glm::length(glm::max(q, Vec3(0.0))) + std::min(std::max(q.x, std::max(q.y, q.z)), 0.0);
}

/// Intersection of two half spaces at a right angle whose edge is rounded with `radius`: u and v are the distances from
/// the two. Exact outside and near the surface; inside a lower bound of the depth.
inline double rounded_corner(double u, double v, double radius) noexcept {
  const double p = u + radius;
  const double q = v + radius;
  if (p > 0.0 && q > 0.0) return std::sqrt(p * p + q * q) - radius;
  return std::max(u, v);
}

/// Two distances that differ by more than this share of the radius are not blended: 4 (1 - 1/sqrt 2).
inline constexpr double kBlendReach = 1.1715728752538099;

/// The greater of two, blended where they differ by little: a round edge of about `radius` between two faces at a right
/// angle (a parabola that passes the middle of the round one). Of distances that change by no more than their place it is
/// one again, whatever the angle.
inline double blended_max(double a, double b, double radius) noexcept {
  const double reach = kBlendReach * radius;
  const double within = reach - std::fabs(a - b);
  return std::max(a, b) + (within > 0.0 ? within * within / (4.0 * reach) : 0.0);
}

}  // namespace cusp::scenarios
