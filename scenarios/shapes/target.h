/// The shape that an attempt is measured against: a region, and what a lone outline is known for besides.
/// Frame: specimen. Millimetres. Immutable; any thread.
#pragma once

#include <optional>

#include "scenarios/shapes/region.h"

namespace cusp::scenarios {

/// A specimen for a shape that it outlives.
inline std::shared_ptr<const Specimen> lent(const Specimen& specimen) { return {std::shared_ptr<const Specimen>(), &specimen}; }

class TargetShape {
 public:
  /// `specimen`: uncut; needed where a leaf is of its voxels.
  explicit TargetShape(const Region& region, std::shared_ptr<const Specimen> specimen = nullptr);

  /// An outline without a path, or a tree with a leaf of voxels and no specimen to have them from.
  bool empty() const noexcept { return empty_; }
  /// The lone outline with upright walls that the target is; else nullptr. What is asked of it is bit for bit format 1's.
  const OutlineShape* upright() const noexcept { return upright_ ? &*upright_ : nullptr; }
  Near near(Vec3 p) const noexcept { return region_.near(p); }
  std::optional<Facing> facing(Vec3 p, Vec3 into_void) const noexcept { return region_.facing(p, into_void); }
  /// Whether the target's own surface passes over a place at the face that it faces: another part has not taken it away there, and
  /// the edge between two parts is not rounded there.
  bool bounded_by(const Facing& facing, Vec3 p) const noexcept {
    constexpr double kRoundedMm = 0.01;  // an edge begins where the surface leaves the face by so much
    return distance_mm(p + facing.beyond_mm * facing.into_void) > -kRoundedMm;
  }
  /// Signed distance: exact or a lower bound.
  double distance_mm(Vec3 p) const noexcept { return upright_ ? upright_->distance_mm(p) : region_.near(p).distance_mm; }
  /// From the wall in plan, negative inside: of an upright outline; of any other target its distance at half its depth.
  double outline_mm(Vec2 p) const noexcept {
    return upright_ ? upright_->outline_mm(p) : distance_mm({p.x, p.y, 0.5 * (top_mm_ + floor_mm_)});
  }
  /// Below the lowest floor; negative above it.
  double below_floor_mm(double z) const noexcept { return floor_mm_ - z; }

  /// Whether an outline says from which plane depth is taken; without one no depth is measured.
  bool has_plane() const noexcept { return has_plane_; }
  double top_mm() const noexcept { return top_mm_; }      // that plane, or the region's highest place
  double floor_mm() const noexcept { return floor_mm_; }  // the region's lowest place
  double corner_mm() const noexcept { return corner_mm_; }  // the greatest of its outlines
  /// Of a slot half its width; of a tree half its lesser extent in plan.
  double half_width_mm() const noexcept { return half_width_mm_; }
  /// The bounding rectangle.
  Vec2 low() const noexcept { return low_; }
  Vec2 high() const noexcept { return high_; }

 private:
  std::optional<OutlineShape> upright_;
  RegionShape region_;
  bool empty_ = false, has_plane_ = false;
  double top_mm_ = 0, floor_mm_ = 0, corner_mm_ = 0, half_width_mm_ = 0;
  Vec2 low_{0.0}, high_{0.0};
};

}  // namespace cusp::scenarios
