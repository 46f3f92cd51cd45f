#include "scenarios/metrics/floor.h"

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/angle.h"
#include "scenarios/metrics/walls.h"

namespace cusp::scenarios {

namespace {

/// Weighted moments of the floor about its middle.
struct Moments {
  double area = 0;
  Vec3 middle{0.0};
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;  // mm2, means

  explicit Moments(const std::vector<CutFace>& floor) {
    for (const CutFace& face : floor) {
      const double mm2 = weight(face);
      area += mm2;
      middle += mm2 * face.middle_mm;
    }
    middle /= area;
    for (const CutFace& face : floor) {
      const double share = weight(face) / area;
      const Vec3 d = face.middle_mm - middle;
      xx += share * d.x * d.x;
      xy += share * d.x * d.y;
      yy += share * d.y * d.y;
      xz += share * d.x * d.z;
      yz += share * d.y * d.z;
    }
  }
  static double weight(const CutFace& face) noexcept { return std::sqrt(glm::dot(face.area_mm2, face.area_mm2)); }
  /// A strip as wide as the floor where it is narrowest has this variance times 12.
  double least_width_mm() const noexcept {
    const double half = 0.5 * (xx - yy);
    const double least = 0.5 * (xx + yy) - std::sqrt(half * half + xy * xy);
    return std::sqrt(12.0 * std::max(0.0, least));
  }
};

}  // namespace

std::optional<FloorForm> floor_form(const CutFaces& faces, double point_sigma_mm) {
  const std::vector<CutFace>& floor = faces.of(FaceName::pulpal_floor);
  if (floor.empty()) return std::nullopt;
  const Moments m(floor);
  FloorForm out;
  out.flatness_uncertainty_mm = point_sigma_mm;
  const double width = m.least_width_mm();
  double slope_x = 0, slope_y = 0;
  if (width > 0.0) out.tilt_uncertainty_deg = std::sqrt(2.0) * point_sigma_mm / width * kDegreesPerRadian;
  if (width > 0.0 && out.tilt_uncertainty_deg <= kLeastCertainDeg) {
    const double determinant = m.xx * m.yy - m.xy * m.xy;
    slope_x = (m.xz * m.yy - m.yz * m.xy) / determinant;
    slope_y = (m.yz * m.xx - m.xz * m.xy) / determinant;
    out.tilt_deg = slope_deg(std::sqrt(slope_x * slope_x + slope_y * slope_y), 1.0);
  } else {
    // A line: the slope along it is all that a plane could follow.
    const double along = m.xx + m.yy;
    if (along > 0.0) {
      slope_x = m.xx >= m.yy && m.xx > 0.0 ? m.xz / m.xx : 0.0;
      slope_y = m.xx >= m.yy ? 0.0 : m.yz / m.yy;
    }
  }
  const double tilt_length = std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
  double sum = 0, furthest = -1;
  out.lowest_at_mm = floor.front().middle_mm;
  for (const CutFace& face : floor) {
    const Vec3 d = face.middle_mm - m.middle;
    const double off = std::fabs(d.z - slope_x * d.x - slope_y * d.y) / tilt_length;
    sum += Moments::weight(face) * off * off;
    if (off > furthest) {
      furthest = off;
      out.furthest_at_mm = face.middle_mm;
    }
    if (face.middle_mm.z < out.lowest_at_mm.z) out.lowest_at_mm = face.middle_mm;
  }
  out.flatness_mm = std::sqrt(sum / m.area);
  return out;
}

}  // namespace cusp::scenarios
