#include "scenarios/shapes/target.h"

#include <algorithm>

namespace cusp::scenarios {

TargetShape::TargetShape(const Region& region, std::shared_ptr<const Specimen> specimen)
    : region_(region, specimen), empty_(specimen == nullptr && needs_voxels(region)) {
  const std::vector<const Outline*> outlines = outlines_of(region);
  for (const Outline* one : outlines) corner_mm_ = std::max(corner_mm_, OutlineShape(*one).corner_mm());
  has_plane_ = !outlines.empty();
  const RegionBounds& b = region_.bounds();
  low_ = {b.low.x, b.low.y};
  high_ = {b.high.x, b.high.y};
  floor_mm_ = b.low.z;
  top_mm_ = has_plane_ ? outlines.front()->top_mm : b.high.z;
  half_width_mm_ = 0.5 * std::min(high_.x - low_.x, high_.y - low_.y);
  if (region.kind != RegionKind::outline) return;
  const OutlineShape shape(region.outline);
  empty_ = shape.empty();
  half_width_mm_ = shape.half_width_mm();
  if (!shape.tapered()) upright_ = shape;
}

}  // namespace cusp::scenarios
