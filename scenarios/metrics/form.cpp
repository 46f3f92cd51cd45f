#include "scenarios/metrics/form.h"

#include <array>
#include <cmath>

#include "scenarios/metrics/floor.h"
#include "scenarios/metrics/remaining.h"
#include "scenarios/metrics/walls.h"
#include "scenarios/metrics/width.h"

namespace cusp::scenarios {

namespace {

struct Wall {
  FaceName name;
  const char* metric;
  std::optional<WallAngle> angle = std::nullopt;
};

void add_convergence(const char* metric, const Wall& a, const Wall& b, std::vector<Measure>& out) {
  if (!a.angle || !b.angle) {
    out.push_back(not_measured(metric, "deg"));
    return;
  }
  const double sigma = std::sqrt(a.angle->uncertainty_deg * a.angle->uncertainty_deg +
                                 b.angle->uncertainty_deg * b.angle->uncertainty_deg);
  const bool a_worse = std::fabs(a.angle->deg) >= std::fabs(b.angle->deg);
  out.push_back({metric, true, -(a.angle->deg + b.angle->deg), sigma, "deg", a_worse ? a.angle->at_mm : b.angle->at_mm});
}

void add_walls(const Reference& reference, const CutFaces& faces, std::vector<Measure>& out) {
  std::array<Wall, 4> walls = {{{FaceName::mesial_wall, "wall_angle_mesial"},
                                {FaceName::distal_wall, "wall_angle_distal"},
                                {FaceName::buccal_wall, "wall_angle_buccal"},
                                {FaceName::lingual_wall, "wall_angle_lingual"}}};
  for (Wall& wall : walls) {
    if (faces.side_known(wall.name)) wall.angle = wall_angle(faces, wall.name, reference.point_sigma_mm());
    if (wall.angle)
      out.push_back({wall.metric, true, wall.angle->deg, wall.angle->uncertainty_deg, "deg", wall.angle->at_mm});
    else
      out.push_back(not_measured(wall.metric, "deg"));
  }
  add_convergence("convergence_mesiodistal", walls[0], walls[1], out);
  add_convergence("convergence_buccolingual", walls[2], walls[3], out);
}

void add_floor(const Reference& reference, const CutFaces& faces, std::vector<Measure>& out) {
  const std::optional<FloorForm> floor = floor_form(faces, reference.point_sigma_mm());
  if (floor)
    out.push_back({"floor_flatness", true, floor->flatness_mm, floor->flatness_uncertainty_mm, "mm", floor->furthest_at_mm});
  else
    out.push_back(not_measured("floor_flatness", "mm"));
  if (floor && floor->tilt_deg)
    out.push_back({"floor_tilt", true, *floor->tilt_deg, floor->tilt_uncertainty_deg, "deg", floor->lowest_at_mm});
  else
    out.push_back(not_measured("floor_tilt", "deg"));
}

}  // namespace

void add_form(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
              std::vector<Measure>& out) {
  add_walls(reference, faces, out);
  add_floor(reference, faces, out);
  if (const auto narrow = isthmus(margin, reference))
    out.push_back({"isthmus_width", true, narrow->width_mm, narrow->uncertainty_mm, "mm", narrow->from_mm});
  else
    out.push_back(not_measured("isthmus_width", "mm"));
  for (const auto& [wall, metric] : {std::pair{FaceName::mesial_wall, "ridge_mesial"}, {FaceName::distal_wall, "ridge_distal"}}) {
    if (const auto ridge = ridge_thickness(faces, reference, volume, wall))
      out.push_back({metric, true, ridge->mm, ridge->uncertainty_mm, "mm", ridge->wall_at_mm});
    else
      out.push_back(not_measured(metric, "mm"));
  }
}

}  // namespace cusp::scenarios
