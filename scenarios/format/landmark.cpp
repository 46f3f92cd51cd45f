#include "scenarios/format/landmark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/teeth/landmarks.h"

namespace cusp::scenarios {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// From the first point to the second; nullopt where they are one.
std::optional<Vec3> way_of(const Landmark* axis) noexcept {
  if (axis == nullptr || axis->points_mm.size() != 2) return std::nullopt;
  const Vec3 way = axis->points_mm[1] - axis->points_mm[0];
  return glm::dot(way, way) > 0.0 ? std::optional(way) : std::nullopt;
}

}  // namespace

const Landmark* SpecimenLandmarks::find(MarkKind kind, std::string_view name) const noexcept {
  const auto at = std::ranges::find_if(marks, [&](const Landmark& one) { return one.kind == kind && one.name == name; });
  return at == marks.end() ? nullptr : &*at;
}

PointCount point_count(MarkKind kind) noexcept {
  switch (kind) {
    case MarkKind::long_axis:
    case MarkKind::mesial_axis: return {2, 2};
    case MarkKind::fissure:
    case MarkKind::marginal_ridge: return {2, kMostMarkPoints};
    case MarkKind::cej: return {4, kMostMarkPoints};
    case MarkKind::cusp_tip:
    case MarkKind::pit:
    case MarkKind::contact:
    case MarkKind::contour: break;
  }
  return {1, 1};
}

std::optional<double> turn_deg(const SpecimenLandmarks& landmarks) noexcept {
  const auto way = way_of(landmarks.find(MarkKind::mesial_axis));
  const int mesial = mesial_x(landmarks.fdi);
  if (mesial == 0 || !way || (way->x == 0.0 && way->y == 0.0)) return std::nullopt;
  return std::atan2(mesial * way->y, mesial * way->x) * kDegrees;
}

std::optional<double> tilt_deg(const SpecimenLandmarks& landmarks) noexcept {
  const auto way = way_of(landmarks.find(MarkKind::long_axis));
  if (!way) return std::nullopt;
  return std::atan2(std::hypot(way->x, way->y), way->z) * kDegrees;
}

}  // namespace cusp::scenarios
