#include "scenarios/metrics/walls.h"

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/angle.h"

namespace cusp::scenarios {

std::optional<WallAngle> wall_angle(const CutFaces& faces, FaceName wall, double point_sigma_mm) {
  const std::vector<CutFace>& all = faces.of(wall);
  if (all.empty()) return std::nullopt;
  double rise = 0, run = 0, area = 0;
  double low = all.front().middle_mm.z, high = low;
  Vec3 middle(0.0);
  for (const CutFace& face : all) {
    rise += face.area_mm2.z;
    run += std::sqrt(face.area_mm2.x * face.area_mm2.x + face.area_mm2.y * face.area_mm2.y);
    const double mm2 = std::sqrt(glm::dot(face.area_mm2, face.area_mm2));
    area += mm2;
    middle += mm2 * face.middle_mm;
    low = std::min(low, face.middle_mm.z);
    high = std::max(high, face.middle_mm.z);
  }
  if (!(high > low)) return std::nullopt;
  WallAngle out;
  out.deg = slope_deg(rise, run);
  out.uncertainty_deg = std::sqrt(2.0) * point_sigma_mm / (high - low) * kDegreesPerRadian;
  if (out.uncertainty_deg > kLeastCertainDeg) return std::nullopt;
  middle /= area;
  const auto off = [middle](const CutFace& face) { return glm::dot(face.middle_mm - middle, face.middle_mm - middle); };
  out.at_mm = std::ranges::min_element(all, {}, off)->middle_mm;
  return out;
}

}  // namespace cusp::scenarios
