/// A round tooth that touches a round neighbour, and a slot with a box at its mesial end, against closed forms.
#pragma once

#include "scenarios/metrics/proximal.h"
#include "scenarios/metrics/unsupported.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/metrics/known.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {

/// Two balls whose lower and upper parts are cut off; they touch at (5, 0, -1.5), 0.01 mm apart.
inline constexpr double kRadius = 5.0, kMiddle = -1.5, kBeside = 10.01, kDentineRadius = 3.6;
inline double own_tooth(Vec3 p) {
  return std::max(ball_distance(p, Vec3(0, 0, kMiddle), kRadius), box_distance(p, Vec3(2, 0, -2.25), Vec3(4, 3, 2.25)));
}
inline double neighbour(Vec3 p) {
  return std::max(ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius), box_distance(p, Vec3(5.5, 0, -2.25), Vec3(1, 3, 2.25)));
}
inline Tissue tissue_at(Vec3 p) {
  if (neighbour(p) < own_tooth(p)) return kNeighbourEnamel;
  return ball_distance(p, Vec3(0, 0, kMiddle), kDentineRadius) < 0.0 ? Tissue::dentine : Tissue::enamel;
}

template <class TissueAt>
std::shared_ptr<const Specimen> two_teeth(double voxel_mm, Draw& draw, TissueAt&& tissue) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  grid.size = IVec3(glm::ceil(Vec3(8.5, 6.0, 4.5) / voxel_mm)) + 10;
  const double x = draw(0, 1), y = draw(0, 1), z = draw(0, 1);
  grid.origin_mm = Vec3(-2, -3, -4.5) + voxel_mm * (Vec3(x, y, z) - 5.0);
  return carved::specimen(grid, Reading::banded, [](Vec3 p) { return std::min(own_tooth(p), neighbour(p)); }, tissue);
}

/// A slot and a box at its mesial end. Walls stand at y = lingual and buccal at the gingival floor and open by `slope` a mm.
struct Box {
  double axial_x = 2.9, buccal = 1.6, lingual = -1.6, gingival = 3.2, pulpal = 1.8, slope = 0.0;

  double wall_y(double z, bool at_buccal) const {
    const double up = slope * (z + gingival);
    return at_buccal ? buccal + up : lingual - up;
  }
  /// The void, which ends at the neighbour.
  double distance(Vec3 p) const {
    const double steep = std::sqrt(1.0 + slope * slope);
    const double walls = std::max(p.y - wall_y(p.z, true), wall_y(p.z, false) - p.y) / steep;
    const double box = std::max({walls, axial_x - p.x, -gingival - p.z});
    const double slot = std::max({std::fabs(p.y) - 0.6, -pulpal - p.z, -1.2 - p.x});
    return std::max(std::min(box, slot), -ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius));
  }
  static Region target() {
    Region proximal = box_region({4.9, 0, -1.1}, {4, 3.2, 4.2});
    proximal.faces = {{"z_low", FaceName::gingival_floor}, {"x_low", FaceName::axial_wall}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
    Outline slot;
    slot.shape = "box";
    slot.paths = {{Vec3(1, 0, -1.8)}};
    slot.box_size_mm = {4.4, 1.2, 0};
    slot.depth_mm = 1.8;
    slot.corner_radius_mm = 0.2;
    return node(RegionKind::joined, {region_of(slot), proximal});
  }
  /// The margin of a wall on the round tooth at a height.
  Vec3 margin(double z, bool at_buccal) const {
    const double y = wall_y(z, at_buccal);
    return {std::sqrt(kRadius * kRadius - y * y - (z - kMiddle) * (z - kMiddle)), y, z};
  }
  static double clearance(Vec3 p) { return ball_distance(p, Vec3(kBeside, 0, kMiddle), kRadius); }
};

/// A slot through enamel into a ball of dentine, and a groove beneath the enamel about it. Rods are the ball's radii.
struct UndercutSlot {
  double half_x = 0.7, half_y = 0.5, depth = 2.0, groove = 0.2, x = 1.0;
  static constexpr Vec3 kMiddleMm{1, 0, -5};
  static constexpr double kBallMm = 3.5;

  static double dentine(Vec3 p) { return ball_distance(p, kMiddleMm, kBallMm); }
  static Tissue tissue(Vec3 p) { return neighbour(p) < own_tooth(p) ? kNeighbourEnamel : dentine(p) < 0.0 ? Tissue::dentine : Tissue::enamel; }

  bool removed(Vec3 p) const { return distance(p) < 0.0; }
  double distance(Vec3 p) const {
    const auto slot = [&](double more) { return std::max({std::fabs(p.x - x) - half_x - more, std::fabs(p.y) - half_y - more, -depth - p.z}); };
    return std::min(slot(0.0), std::max(slot(groove), dentine(p)));
  }
  bool unsupported(Vec3 p) const {
    const Vec3 out = p - kMiddleMm;
    const double radius = glm::length(out);
    for (double mm = kBallMm - kCarrierMm; mm < radius; mm += 0.02)
      if (removed(kMiddleMm + mm / radius * out)) return true;
    return false;
  }
  double unsupported_mm3() const {
    constexpr double kStep = 0.04;
    double sum = 0;
    for (double px = -1.0; px < 3.0; px += kStep)
      for (double py = -1.6; py < 1.6; py += kStep)
        for (double pz = -depth; pz < 0.0; pz += kStep) {
          const Vec3 p = Vec3(px, py, pz) + 0.5 * kStep;
          const bool enamel = own_tooth(p) < 0.0 && dentine(p) >= 0.0;
          if (enamel && !removed(p) && unsupported(p)) sum += kStep * kStep * kStep;
        }
    return sum;
  }
};

/// A ball of soft caries in the dentine, firm for its outer 0.3 mm, under the middle of the tooth's top.
struct Lesion {
  Vec3 at{1.0, 0.0, -1.2};
  double radius = 0.9;
  Tissue operator()(Vec3 p) const {
    const Tissue sound = tissue_at(p);
    const double d = ball_distance(p, at, radius);
    if (d >= 0.0 || sound == kNeighbourEnamel) return sound;
    if (sound == Tissue::enamel) return Tissue::carious_enamel;
    return d > -0.3 ? kFirmCariousDentine : Tissue::carious_dentine;
  }
};

inline Scenario exercise() {
  Scenario s = box_exercise_on_36({2, 1, 2}, {Tissue::enamel, 3, 0.5});
  s.target = Box::target();
  s.rubric = whole_rubric();
  return s;
}

inline Measure get(const std::vector<Measure>& measures, std::string_view metric) {
  const auto found = std::ranges::find(measures, metric, &Measure::metric);
  return found == measures.end() ? not_measured("absent", "") : *found;
}

}  // namespace cusp::test
