/// The shape that an Outline draws: an outline on the occlusal plane, swept from its floor upwards without end (whatever
/// stands above the reference plane within the outline is to be removed too), the edge between wall and floor rounded.
/// Frame: specimen. Millimetres. Immutable; any thread.
#pragma once

#include <array>
#include <vector>

#include "scenarios/format/region.h"
#include "scenarios/shapes/distance.h"
#include "scenarios/shapes/facing.h"
#include "scenarios/shapes/near.h"

namespace cusp::scenarios {

class OutlineShape {
 public:
  /// A channel is the slot about its one path, an outline the union of the slots about its paths, a box a rectangle of
  /// box_size_mm about paths[0][0]. One without a path is empty(). The corner radius is cut to what fits: half the
  /// width, and the depth.
  explicit OutlineShape(const Outline& outline);

  bool empty() const noexcept { return segments_.empty() && !box_; }
  bool tapered() const noexcept { return tapered_; }
  /// From the wall at the narrowest height, in the occlusal plane; negative inside the outline.
  double outline_mm(Vec2 p) const noexcept;
  /// From the wall, which may lean. Of upright walls outline_mm(). Of leaning ones the sign is exact and the distance a
  /// lower bound.
  double wall_mm(Vec3 p) const noexcept;
  /// Below the floor; negative above it.
  double below_floor_mm(double z) const noexcept { return floor_mm_ - z; }
  /// Signed distance. Upright walls: exact outside, inside a lower bound of the depth; where a rectangle's vertical edge meets the
  /// rounded floor it falls short by at most 0.09 of the corner's radius. Leaning ones: a lower bound, its corner a parabola
  /// through the middle of the round one.
  double distance_mm(Vec3 p) const noexcept;
  /// Distances and face. `faces`: in the order of face_slots(RegionKind::outline).
  Near near(Vec3 p, const std::array<FaceName, 6>& faces) const noexcept;
  /// Its floor, and its four walls (a rectangle) or the wall beside the place (slots). Returns how many.
  std::size_t faces_at(Vec3 p, const std::array<FaceName, 6>& faces, std::array<LeafFace, 6>& out) const noexcept;

  double top_mm() const noexcept { return top_mm_; }
  double floor_mm() const noexcept { return floor_mm_; }  // height of the floor
  double corner_mm() const noexcept { return corner_mm_; }
  /// Greatest distance from the wall inside the outline: half the width of a slot.
  double half_width_mm() const noexcept { return half_width_mm_; }
  /// The outline's bounding rectangle, at its widest height.
  Vec2 low() const noexcept { return low_; }
  Vec2 high() const noexcept { return high_; }

 private:
  struct Segment {
    Vec2 a, b;
  };
  /// How far the walls on the sides -x, +x, -y, +y stand out at a height, mm; at least 0.
  std::array<double, 4> spread_at(double z) const noexcept;
  std::size_t side_of(Vec3 p) const noexcept;

  std::vector<Segment> segments_;
  bool box_ = false, tapered_ = false;
  Vec2 box_centre_{0.0}, box_half_{0.0};
  double half_width_mm_ = 0, top_mm_ = 0, floor_mm_ = 0, corner_mm_ = 0;
  std::array<double, 4> slope_{};  // mm out a mm of height; below 0: widens downwards
  double steepness_ = 1.0;         // >= 1: divides the distance, so that it changes by no more than its place
  Vec2 low_{0.0}, high_{0.0};
};

}  // namespace cusp::scenarios
