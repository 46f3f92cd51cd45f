#include "scenarios/shapes/outline.h"

#include <limits>

namespace cusp::scenarios {

TargetShape::TargetShape(const Target& target)
    : top_mm_(target.top_mm), floor_mm_(target.top_mm - target.depth_mm) {
  if (target.shape == "box") {
    if (!target.paths.empty() && !target.paths.front().empty()) {
      const Vec3 c = target.paths.front().front();
      box_ = true;
      box_centre_ = {c.x, c.y};
      box_half_ = 0.5 * Vec2(target.box_size_mm.x, target.box_size_mm.y);
      half_width_mm_ = std::min(box_half_.x, box_half_.y);
      low_ = box_centre_ - box_half_;
      high_ = box_centre_ + box_half_;
    }
  } else {
    half_width_mm_ = 0.5 * target.width_mm;
    low_ = Vec2(std::numeric_limits<double>::max());
    high_ = -low_;
    for (const std::vector<Vec3>& path : target.paths) {
      for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec2 b(path[i].x, path[i].y);
        const Vec2 a = i == 0 ? b : Vec2(path[i - 1].x, path[i - 1].y);
        low_ = glm::min(low_, b - half_width_mm_);
        high_ = glm::max(high_, b + half_width_mm_);
        if (i > 0 || path.size() == 1) segments_.push_back({a, b});
      }
    }
    if (segments_.empty()) low_ = high_ = Vec2(0.0);
  }
  corner_mm_ = std::max(0.0, std::min({target.corner_radius_mm, half_width_mm_, target.depth_mm}));
}

double TargetShape::outline_mm(Vec2 p) const noexcept {
  if (box_) return rectangle_distance(p, box_centre_, box_half_);
  double nearest = std::numeric_limits<double>::max();
  for (const Segment& s : segments_) {
    const Vec2 off = p - (s.a + nearest_on_segment(p, s.a, s.b) * (s.b - s.a));
    nearest = std::min(nearest, glm::dot(off, off));
  }
  return std::sqrt(nearest) - half_width_mm_;
}

}  // namespace cusp::scenarios
