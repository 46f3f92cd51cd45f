#include "ui/render/mouth_mirror.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace cusp::ui {
namespace {

// From the place to the mirror's middle: a molar is 11 mm wide; the glass stands free of it.
constexpr double kBehindMm = 11.0, kAboveMm = 2.0;

/// Unit part of `v` across `axis`.
Vec3 across(Vec3 v, Vec3 axis) { return glm::normalize(v - glm::dot(v, axis) * axis); }

Vec3 rotated(Vec3 v, Vec3 axis, double rad) {
  return Vec3(glm::rotate(glm::dmat4(1.0), rad, axis) * glm::dvec4(v, 0.0));
}

}  // namespace

MouthMirror mirror_behind(const Camera& camera, Vec3 place_mm) {
  // Level, and away from the eye: from above, that is where the view's upright axis points.
  const Vec3 away = glm::normalize(Vec3(glm::dvec2(camera.forward()) + glm::dvec2(camera.up()), 0.0));
  MouthMirror out;
  out.centre_mm = place_mm + kBehindMm * away + Vec3(0.0, 0.0, kAboveMm);
  out.normal = glm::normalize(glm::normalize(camera.eye_mm() - out.centre_mm) + glm::normalize(place_mm - out.centre_mm));
  out.handle = across(camera.right() + Vec3(0.0, 0.0, 0.8) + 0.5 * away, out.normal);
  return out;
}

bool shows_glass(const MouthMirror& mirror, Vec3 eye_mm) noexcept {
  return glm::dot(eye_mm - mirror.centre_mm, mirror.normal) > 0.0;
}

Vec3 reflected(const MouthMirror& mirror, Vec3 place_mm) noexcept {
  return place_mm - 2.0 * glm::dot(place_mm - mirror.centre_mm, mirror.normal) * mirror.normal;
}

std::optional<double> distance_to(const MouthMirror& mirror, const Ray& ray) noexcept {
  const double towards = glm::dot(ray.along, mirror.normal);
  if (std::abs(towards) < 1e-9) return std::nullopt;
  const double t = glm::dot(mirror.centre_mm - ray.from_mm, mirror.normal) / towards;
  if (t <= 0.0 || glm::length(ray.from_mm + t * ray.along - mirror.centre_mm) > MouthMirror::kRadiusMm) return std::nullopt;
  return t;
}

MouthMirror moved(const MouthMirror& mirror, const Camera& camera, Vec3 by_mm) noexcept {
  MouthMirror out = mirror;
  out.centre_mm += by_mm.x * camera.right() + by_mm.y * camera.up() + by_mm.z * camera.forward();
  return out;
}

MouthMirror turned(const MouthMirror& mirror, const Camera& camera, glm::dvec2 by_rad) noexcept {
  MouthMirror out = mirror;
  for (const auto& [axis, rad] : {std::pair{camera.up(), by_rad.x}, std::pair{camera.right(), by_rad.y}}) {
    out.normal = glm::normalize(rotated(out.normal, axis, rad));
    out.handle = across(rotated(out.handle, axis, rad), out.normal);
  }
  return out;
}

}  // namespace cusp::ui
