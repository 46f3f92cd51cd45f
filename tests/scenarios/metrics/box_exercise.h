/// An exercise whose target is a box below z = 0 on tooth 36, for preparations carved by analysis.
#pragma once

#include "scenarios/format/scenario.h"
#include "tests/modules.h"

namespace cusp::test {

/// size_mm: along x, along y, depth.
inline Scenario box_exercise_on_36(Vec3 size_mm, ScenarioTissue tissue) {
  Scenario s;
  s.specimen.generator = "tooth";
  s.specimen.fdi = 36;
  s.tissues = {tissue};
  s.instruments = {{}};
  s.target.outline.shape = "box";
  s.target.outline.paths = {{Vec3(0, 0, -size_mm.z)}};
  s.target.outline.box_size_mm = {size_mm.x, size_mm.y, 0};
  s.target.outline.depth_mm = size_mm.z;
  s.target.outline.corner_radius_mm = 0.3;
  return s;
}

}  // namespace cusp::test
