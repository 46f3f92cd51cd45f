/// Poses of a bur that take nothing but the target: its head, neck and shank lie within the target or in air.
/// Frame: specimen; a pose is the pivot's place (engine/tool/bur.h). Millimetres. Immutable; any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/tool/bur.h"
#include "engine/volume/specimen.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {

/// A place is sampled so densely on the bur that a flat wall lies at most so far from what poses take of it; mm.
inline constexpr double kPoseErrorMm = 0.004;

/// Where a target that is looked for deeper begins.
enum class Top : std::uint8_t {
  moved,  // as much deeper: what is looked for is the target, moved
  kept    // where it is drawn: the bur enters there
};

class Poses {
 public:
  /// `moved_mm`: the target is looked for this far from where it is drawn. `wider_mm`: walls and floors may be passed by so
  /// much. `shape` and `specimen` outlive the poses. A filled specimen has no surface to measure air by: to an upright bur
  /// air counts as tissue there, to a tilted one by the voxels' faces. `clear_mm`: the bur keeps so far from tissue that is
  /// not the target's. `axis`: of the bur, unit, from the head towards the shank, with axis.z > 0.
  Poses(const TargetShape& shape, const Specimen& specimen, const Bur& bur, Vec3 moved_mm = Vec3(0.0), double wider_mm = 0.0,
        double clear_mm = 0.0, Top top = Top::moved, Vec3 axis = Vec3(0.0, 0.0, 1.0));

  /// How far the bur stands out into tissue that is not the target's; 0 or less: nowhere. Never more than the true length,
  /// and changes by no more than the pose.
  double blocked_mm(Vec3 pivot) const noexcept;
  /// How far pivot and tip are out of the target: a pose further off has nothing to do there.
  double beside_mm(Vec3 pivot) const noexcept;
  /// The greater of both: the pose is allowed at 0 or less.
  double out_mm(Vec3 pivot) const noexcept;
  /// Height of the head's lowest point above or below a place `away_mm` from the pivot along a level way, from the pivot; none: a
  /// large number. To an upright bur every way is alike.
  double underside_mm(Vec2 way, double away_mm) const noexcept;
  /// Signed distance of a place from the target, where it is looked for.
  double target_mm(Vec3 p) const noexcept {
    const double moved = shape_->distance_mm(p - moved_);
    return (top_ == Top::moved ? moved : std::min(moved, shape_->distance_mm(p - Vec3(moved_.x, moved_.y, 0.0)))) - wider_;
  }
  /// Box about it, in plan, and its lowest place.
  Vec2 low() const noexcept { return shape_->low() + Vec2(moved_.x, moved_.y) - wider_; }
  Vec2 high() const noexcept { return shape_->high() + Vec2(moved_.x, moved_.y) + wider_; }
  double floor_mm() const noexcept { return shape_->floor_mm() + moved_.z - wider_; }
  const Specimen& specimen() const noexcept { return *specimen_; }
  double radius_mm() const noexcept { return radius_; }
  Vec3 axis() const noexcept { return axis_; }
  Vec3 lowest() const noexcept { return lowest_; }          // place of the head, from the pivot
  double low_mm() const noexcept { return lowest_.z; }    // negative
  double spread_mm() const noexcept { return spread_; }   // of the head about the pivot, in plan; upright: its radius
  /// Height of the ridges that passes so far above one another leave on an upright wall.
  double ridge_mm(double apart_mm) const noexcept;

 private:
  /// Places round the bur's axis, from the pivot, at equal angles.
  struct Ring {
    std::vector<Vec3> places;
    double apart_mm = 0.0;
  };
  bool upright() const noexcept { return axis_.z == 1.0; }
  double place_out(Vec3 p) const noexcept;
  double underside_upright(double from_axis) const noexcept;
  void tilt(const Bur& bur);
  void add_ring(double t, double rho, int count, std::vector<Ring>& to) const;
  void sample_ball();
  void sample_head(const Profile& head);

  const TargetShape* shape_;
  const Specimen* specimen_;
  Vec3 moved_;
  Vec3 axis_, lowest_;
  double wider_, clear_, radius_, spread_, reach_;
  Top top_;
  std::optional<double> narrows_;  // of a straight flank, mm a mm of height; a head without one has none
  double air_mm_ = 0.0;  // of a voxel of air, as air_voxels() counts; 0: air counts as tissue
  Bur bur_;
  std::vector<Ring> coarse_, fine_;
};

}  // namespace cusp::scenarios
