#include "scenarios/shapes/outline_size.h"

#include <algorithm>

#include "scenarios/shapes/outline.h"

namespace cusp::scenarios {

OutlineSize size_of(const Outline& outline) {
  constexpr double kCellMm = 0.04;
  constexpr double kStepMm = 2.0 * kCellMm;  // to either side of the edge: the areas' difference is its length
  const auto share = [](double off) { return std::clamp(0.5 - off / kCellMm, 0.0, 1.0); };
  Outline upright = outline;
  upright.taper_deg = {};
  const OutlineShape shape(upright);
  if (shape.empty()) return {};
  const Vec2 from = shape.low() - Vec2(kStepMm + kCellMm), to = shape.high() + Vec2(kStepMm + kCellMm);
  double within = 0.0, less = 0.0, more = 0.0;  // cells, by the share of each
  for (double y = from.y + 0.5 * kCellMm; y < to.y; y += kCellMm)
    for (double x = from.x + 0.5 * kCellMm; x < to.x; x += kCellMm) {
      const double off = shape.outline_mm({x, y});
      within += share(off);
      less += share(off + kStepMm);
      more += share(off - kStepMm);
    }
  const double cell_mm2 = kCellMm * kCellMm;
  return {within * cell_mm2, (more - less) * cell_mm2 / (2.0 * kStepMm) * outline.depth_mm};
}

}  // namespace cusp::scenarios
