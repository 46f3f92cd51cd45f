/// The shape that a Target draws: an outline on the occlusal plane, swept from its floor upwards without end (whatever
/// stands above the reference plane within the outline is to be removed too), the edge between wall and floor rounded.
/// Frame: specimen. Millimetres. Immutable; any thread.
#pragma once

#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/shapes/distance.h"

namespace cusp::scenarios {

class TargetShape {
 public:
  /// A channel is the slot about its one path, an outline the union of the slots about its paths, a box a rectangle of
  /// box_size_mm about paths[0][0]. A target without a path is empty(). The corner radius is cut to what fits: half the
  /// width, and the depth.
  explicit TargetShape(const Target& target);

  bool empty() const noexcept { return segments_.empty() && !box_; }
  /// From the wall, in the occlusal plane; negative inside the outline.
  double outline_mm(Vec2 p) const noexcept;
  /// Below the floor; negative above it.
  double below_floor_mm(double z) const noexcept { return floor_mm_ - z; }
  /// Signed distance: exact outside, inside a lower bound of the depth.
  double distance_mm(Vec3 p) const noexcept {
    return rounded_corner(outline_mm({p.x, p.y}), below_floor_mm(p.z), corner_mm_);
  }

  double top_mm() const noexcept { return top_mm_; }
  double floor_mm() const noexcept { return floor_mm_; }  // height of the floor
  double corner_mm() const noexcept { return corner_mm_; }
  /// Greatest distance from the wall inside the outline: half the width of a slot.
  double half_width_mm() const noexcept { return half_width_mm_; }
  /// The outline's bounding rectangle.
  Vec2 low() const noexcept { return low_; }
  Vec2 high() const noexcept { return high_; }

 private:
  struct Segment {
    Vec2 a, b;
  };
  std::vector<Segment> segments_;
  bool box_ = false;
  Vec2 box_centre_{0.0}, box_half_{0.0};
  double half_width_mm_ = 0, top_mm_ = 0, floor_mm_ = 0, corner_mm_ = 0;
  Vec2 low_{0.0}, high_{0.0};
};

}  // namespace cusp::scenarios
