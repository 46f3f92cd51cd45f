/// HeadCurve gives the furthest and the nearest point of a convex body of revolution, from the arcs and straight lines
/// of its outline. It reads an engine Profile's pieces and calls none of its functions. Unit: mm, from the bur's pivot.
/// Thread: any but the haptic one.
#pragma once

#include <vector>

#include "engine/base/vec.h"
#include "engine/tool/bur.h"
#include "tests/modules.h"

namespace cusp::bench {

class HeadCurve {
 public:
  /// The cutting head: the profile's pieces, or a ball.
  explicit HeadCurve(const Bur& bur);
  static HeadCurve ball(double radius_mm);
  /// t from from_mm to to_mm along the axis.
  static HeadCurve cylinder(double radius_mm, double from_mm, double to_mm);

  /// Furthest point along a direction; of a flat or a flank that all lies furthest, its first point.
  OnHalf furthest(OnHalf direction) const;
  /// Nearest point of the outline. Pre: `place` is outside.
  OnHalf nearest(OnHalf place) const;
  /// The same in space, with the body's axis (unit).
  Vec3 furthest(Vec3 direction, Vec3 axis) const;
  Vec3 nearest(Vec3 place, Vec3 axis) const;

  /// Angle between the axis and the outward normal of each straight line, radians.
  std::vector<double> straight_normals() const;

 private:
  struct Piece {
    OutlinePiece outline;
    double first = 0.0, last = 0.0;  // angles of the outward normal to the axis at both ends; first >= last
  };
  HeadCurve() = default;
  void add(const OutlinePiece& outline);

  std::vector<Piece> pieces_;
};

}  // namespace cusp::bench
