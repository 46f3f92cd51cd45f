// Cuts of exactly known shape in a block of enamel over dentine, and what is measured of them.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "scenarios/format/keys.h"
#include "scenarios/metrics/measure.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {

using Shape = std::function<double(Vec3)>;

/// 9 x 6 x 6 mm below z = 0, voxels of 0.1 mm or that size times `coarser`; dentine from z = -3 down.
inline std::shared_ptr<const Specimen> block(int coarser = 1) {
  Grid grid;
  grid.size = IVec3(100, 70, 68) / coarser;
  grid.voxel_mm = 0.1 * coarser;
  grid.origin_mm = Vec3(-4.97, -3.44, -6.33);
  return carved::specimen(
      grid, Reading::banded, [](Vec3 p) { return box_distance(p, Vec3(0, 0, -3), Vec3(4.5, 3, 3)); },
      [](Vec3 p) { return p.z > -3 ? Tissue::enamel : Tissue::dentine; });
}

inline Outline isthmus(double width, double depth) {
  Outline out;
  out.paths = {{Vec3(-2, 0, -depth), Vec3(2, 0, -depth)}};
  out.width_mm = width;
  out.depth_mm = depth;
  out.corner_radius_mm = 0.3;
  return out;
}

/// A class II: a slot 2 mm deep, and a box at its end whose gingival floor lies at `deep` mm.
inline Region class_two(double deep, double width = 1.2) {
  Region proximal = box_region({3, 0, 0.5 - 0.5 * deep}, {2, 2.4, deep + 1});
  proximal.faces = {{"z_low", FaceName::gingival_floor}, {"x_low", FaceName::axial_wall}};
  return node(RegionKind::joined, {region_of(isthmus(width, 2)), proximal});
}

inline Scenario exercise(Region target) {
  Scenario s = box_exercise_on_36({2, 1, 2}, {Tissue::enamel, 3, 0.5});
  s.tissues.push_back({Tissue::dentine, 2, 2});
  s.target = std::move(target);
  return s;
}

inline Shape exactly(Region target) {
  return [shape = TargetShape(std::move(target))](Vec3 p) { return shape.distance_mm(p); };
}

inline std::vector<Measure> measured(const Scenario& scenario, const Shape& cut) {
  static const std::shared_ptr<const Specimen> specimen = block();
  Volume volume(specimen);
  carved::carve(volume, cut);
  return measure(Reference(scenario, specimen), volume, {});
}

inline Measure get(const std::vector<Measure>& measures, std::string_view metric) {
  for (const Measure& m : measures)
    if (m.metric == metric) return m;
  return not_measured(std::string(metric), "");
}

}  // namespace cusp::test
