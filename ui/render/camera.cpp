#include "ui/render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace cusp::ui {
namespace {
// A long lens, as an intra-oral camera: little distortion at the cusps.
constexpr double kFieldOfView = 28.0 * std::numbers::pi / 180.0;  // upright
constexpr double kMostPitch = 1.55;                               // short of the pole, where `up` would turn over
constexpr double kNearestFactor = 0.15, kFarthestFactor = 8.0;
}  // namespace

Camera Camera::about(Vec3 centre_mm, double radius_mm) {
  Camera out;
  out.centre_ = centre_mm;
  out.distance_ = std::max(radius_mm, 0.1) / std::sin(kFieldOfView / 2);
  out.first_distance_ = out.distance_;
  out.set_preset(PresetView::working);
  return out;
}

void Camera::orbit(double yaw, double pitch) noexcept { set_angles(yaw_ + yaw, pitch_ + pitch); }

void Camera::set_angles(double yaw, double pitch) noexcept {
  yaw_ = std::remainder(yaw, 2 * std::numbers::pi);
  pitch_ = std::clamp(pitch, -kMostPitch, kMostPitch);
}

void Camera::zoom(double factor) noexcept {
  if (!(factor > 0)) return;
  distance_ = std::clamp(distance_ / factor, kNearestFactor * first_distance_, kFarthestFactor * first_distance_);
}

void Camera::pan(glm::dvec2 by_px, double shorter_px) noexcept {
  const double mm = 1.0 / px_per_mm(shorter_px);
  centre_ += -by_px.x * mm * right() + by_px.y * mm * up();
}

void Camera::set_preset(PresetView view, int mesial_x) noexcept {
  constexpr double kQuarter = std::numbers::pi / 2;
  switch (view) {
    case PresetView::working: set_angles(0.14, 0.98); break;
    case PresetView::occlusal: set_angles(0.0, kMostPitch); break;
    case PresetView::buccal: set_angles(0.0, 0.2); break;
    case PresetView::lingual: set_angles(2 * kQuarter, 0.2); break;
    case PresetView::distal: set_angles(mesial_x < 0 ? -kQuarter : kQuarter, 0.2); break;
  }
}

Vec3 Camera::forward() const noexcept {
  return -Vec3(-std::sin(yaw_) * std::cos(pitch_), std::cos(yaw_) * std::cos(pitch_), std::sin(pitch_));
}

Vec3 Camera::right() const noexcept { return {-std::cos(yaw_), -std::sin(yaw_), 0.0}; }

Vec3 Camera::up() const noexcept { return glm::cross(right(), forward()); }

Vec3 Camera::eye_mm() const noexcept { return centre_ - distance_ * forward(); }

glm::dmat4 Camera::view_from_world() const noexcept { return glm::lookAt(eye_mm(), centre_, up()); }

glm::dmat4 Camera::clip_from_view(double aspect, double reach_mm) const noexcept {
  // A view that is wider than high keeps its height; one that is higher than wide keeps its width.
  const double fov = aspect >= 1.0 ? kFieldOfView : 2 * std::atan(std::tan(kFieldOfView / 2) / aspect);
  const double nearest = std::max(distance_ - reach_mm, 0.02 * distance_);
  return glm::perspective(fov, aspect, nearest, distance_ + reach_mm);
}

glm::dmat4 Camera::clip_from_world(double aspect, double reach_mm) const noexcept {
  return clip_from_view(aspect, reach_mm) * view_from_world();
}

double Camera::px_per_mm(double shorter_px) const noexcept {
  return shorter_px / (2.0 * distance_ * std::tan(kFieldOfView / 2));
}

namespace {
/// Half height and half width of the picture at distance 1.
glm::dvec2 half_extent(glm::dvec2 view_px) {
  const double t = std::tan(kFieldOfView / 2);
  const double aspect = view_px.x / view_px.y;
  return aspect >= 1.0 ? glm::dvec2(t * aspect, t) : glm::dvec2(t, t / aspect);
}
}  // namespace

Ray Camera::ray(glm::dvec2 at_px, glm::dvec2 view_px) const noexcept {
  const glm::dvec2 half = half_extent(view_px);
  const double x = (2 * at_px.x / view_px.x - 1) * half.x, y = (1 - 2 * at_px.y / view_px.y) * half.y;
  return {eye_mm(), glm::normalize(forward() + x * right() + y * up())};
}

std::optional<glm::dvec2> Camera::project(Vec3 mm, glm::dvec2 view_px) const noexcept {
  const Vec3 from_eye = mm - eye_mm();
  const double depth = glm::dot(from_eye, forward());
  if (depth < 1e-6) return std::nullopt;
  const glm::dvec2 half = half_extent(view_px);
  const double x = glm::dot(from_eye, right()) / depth / half.x, y = glm::dot(from_eye, up()) / depth / half.y;
  return glm::dvec2((x + 1) / 2 * view_px.x, (1 - y) / 2 * view_px.y);
}

}  // namespace cusp::ui
